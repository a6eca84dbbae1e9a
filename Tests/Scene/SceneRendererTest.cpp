// Tests rendering a scene on several threads.
#include "Scene/SceneRenderer.h"
#include "Object/WorkTeam.h"
#include "Scene/FactoryScenes.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

namespace {

constexpr double rateHz = 48000;

struct Rendered {
    std::vector<float> left, right;
    std::int64_t impacts = 0;
};

Rendered
render(const std::shared_ptr<const SceneAssets>& assets, double seconds, unsigned threads) {
    WorkTeam team(threads);
    SceneSimulation motion(assets, {.team = &team});
    SceneRenderer renderer(motion, *assets, nullptr, assets->scene().parameters, rateHz, team);
    Rendered rendered;
    while (static_cast<double>(rendered.left.size()) < seconds * rateHz) {
        const auto cell = renderer.next();
        rendered.left.insert(rendered.left.end(), cell.left.begin(), cell.left.end());
        rendered.right.insert(rendered.right.end(), cell.right.begin(), cell.right.end());
        rendered.impacts += std::ssize(renderer.impacts());
    }
    return rendered;
}

} // namespace

TEST_CASE("A scene has the same samples on one thread and on several") {
    for (const auto& [name, seconds, fewestImpacts] :
         {std::tuple{"A hundred rings", 1.5, 2000}, std::tuple{"Ball on a washboard", 1.0, 5}}) {
        const auto assets =
            SceneAssets::make(*findFactoryScene(name), ObjectLibrary::shared()).value();
        const auto alone = render(assets, seconds, 1);
        CHECK(alone.impacts > fewestImpacts);
        for (const unsigned threads : {2u, 3u}) {
            INFO(name << ", " << threads << " threads");
            const auto shared = render(assets, seconds, threads);
            CHECK(shared.impacts == alone.impacts);
            CHECK(shared.left == alone.left);
            CHECK(shared.right == alone.right);
        }
    }
}
