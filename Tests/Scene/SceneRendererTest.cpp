// Tests rendering a scene on several threads.
#include "Scene/SceneRenderer.h"
#include "Instrument/ObjectLibrary.h"
#include "Object/WorkTeam.h"
#include "Scene/FactoryScenes.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;

namespace {

constexpr double rateHz = 48000;

struct Rendered {
    std::vector<float> left, right;
    std::vector<std::vector<float>> stems; ///< left channels
    std::int64_t impacts = 0;
};

Rendered render(const std::shared_ptr<const SceneAssets>& assets,
                double seconds,
                unsigned threads,
                SceneStems stems = SceneStems::none) {
    WorkTeam team(threads);
    SceneSimulation motion(assets, {.team = &team});
    SceneRenderer renderer(motion, *assets, nullptr, assets->scene().parameters, rateHz, team,
                           stems);
    Rendered rendered;
    rendered.stems.resize(renderer.stems().size());
    while (static_cast<double>(rendered.left.size()) < seconds * rateHz) {
        const auto cell = renderer.next();
        rendered.left.insert(rendered.left.end(), cell.left.begin(), cell.left.end());
        rendered.right.insert(rendered.right.end(), cell.right.begin(), cell.right.end());
        for (std::size_t stem = 0; stem < renderer.stems().size(); ++stem)
            rendered.stems[stem].insert(rendered.stems[stem].end(),
                                        renderer.stems()[stem].left.begin(),
                                        renderer.stems()[stem].left.end());
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

TEST_CASE("Stems of one run sum to the scene without stems") {
    for (const auto* name : {"Ball on a washboard", "A hundred rings"})
        for (const auto kind : {SceneStems::bodies, SceneStems::contacts}) {
            INFO(name);
            const auto assets =
                SceneAssets::make(*findFactoryScene(name), ObjectLibrary::shared()).value();
            const auto whole = render(assets, 1, 1);
            const auto parts = render(assets, 1, 2, kind);
            double peak = 0, worst = 0, worstSum = 0;
            for (std::size_t i = 0; i < whole.left.size(); ++i) {
                double sum = 0;
                for (const auto& stem : parts.stems)
                    sum += static_cast<double>(stem[i]);
                const auto sample = static_cast<double>(whole.left[i]);
                peak = std::max(peak, std::abs(sample));
                worst = std::max(worst, std::abs(sum - sample));
                worstSum = std::max(worstSum, std::abs(sum - static_cast<double>(parts.left[i])));
            }
            REQUIRE(peak > 0);
            CHECK(worstSum <= 1e-6 * peak);
            CHECK(worst <= 1e-6 * peak);
        }
}

TEST_CASE("Stems tell impacts, slides and rolls apart") {
    const auto soundsOf = [](const char* scene) {
        const auto assets =
            SceneAssets::make(*findFactoryScene(scene), ObjectLibrary::shared()).value();
        std::vector<bool> sounds;
        for (const auto& stem : render(assets, 1.5, 1, SceneStems::contacts).stems)
            sounds.push_back(std::ranges::any_of(stem, [](float x) { return x != 0; }));
        return sounds;
    };
    CHECK(soundsOf("A hundred rings") == std::vector{true, true, true});
    CHECK(soundsOf("Ball on a washboard") == std::vector{true, false, true});
}
