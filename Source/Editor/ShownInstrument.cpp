#include "Editor/ShownInstrument.h"

#include <algorithm>
#include <new>
#include <utility>

namespace idiophone {

ShownInstrument ShownInstrument::of(const ProcessorView& view) {
    ShownInstrument shown{.played = view.instrument.playedObjects(),
                          .scene = nullptr,
                          .furniture = nullptr,
                          .onStage = view.stage.hasStage(),
                          .bodies = view.stage.stageBodies(),
                          .formerBodies = {}};
    shown.formerBodies = shown.bodies;
    const auto build = [&] {
        using enum ObjectScene::Layout;
        shown.scene =
            std::make_shared<const ObjectScene>(shown.played, shown.onStage ? stage : keyboard);
        shown.furniture = std::make_shared<const InstrumentFurniture>(shown.played, *shown.scene,
                                                                      shown.onStage, shown.bodies);
    };
    try {
        build();
    } catch (const std::bad_alloc&) { // keep playing without a picture
        shown = {};
        build();
    }
    return shown;
}

std::vector<ScenePlace> ShownInstrument::outline() const {
    if (!bodies.empty())
        return scene->outline(bodies);
    auto places = scene->outline();
    if (places.empty())
        return places;
    // A keyboard fills the picture with its bars. Its tubes and legs may reach out of it below.
    const float lowest =
        played.size() == 1 ? furniture->floorHeight()
                           : std::ranges::min(places, {}, [](const auto& at) { return at[2]; })[2];
    for (const auto& part : furniture->parts())
        for (int corner = 0; corner < 8; ++corner) {
            const auto side = [corner](int axis) {
                return (corner >> axis & 1) != 0 ? 1.0f : -1.0f;
            };
            auto at = scenePlace(vectorOf(part.shape.middle) +
                                 Eigen::Vector3f(side(0), side(1), side(2))
                                     .cwiseProduct(vectorOf(part.shape.halfExtent)));
            at[2] = std::max(at[2], lowest);
            places.push_back(at);
        }
    return places;
}

std::optional<ScenePick> ShownInstrument::pick(const ViewRay& ray) const {
    return onStage ? scene->pick(ray.origin, ray.direction, bodies)
                   : scene->pick(ray.origin, ray.direction);
}

bool ShownInstrument::follow(const std::vector<BodyNow>& next) {
    formerBodies = std::exchange(bodies, next);
    return formerBodies != bodies;
}

bool ShownInstrument::rests(const BodyNow& body) const {
    const auto isIn = [&](const std::vector<BodyNow>& poses) {
        return std::ranges::find(poses, body) != poses.end();
    };
    return isIn(bodies) && isIn(formerBodies);
}

std::optional<std::vector<SceneBody>> ShownInstrument::drawnBodies() const {
    if (!onStage)
        return std::nullopt;
    std::vector<SceneBody> drawn;
    for (const auto& body : bodies) {
        SceneBody next{.object = static_cast<std::size_t>(body.object)};
        Eigen::Map<Eigen::Matrix4f>(next.pose.data()) = poseOf(body).matrix();
        drawn.push_back(next);
    }
    return drawn;
}

} // namespace idiophone
