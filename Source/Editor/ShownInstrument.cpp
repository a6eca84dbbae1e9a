#include "Editor/ShownInstrument.h"

#include <new>

namespace idiophone {

ShownInstrument ShownInstrument::of(const ProcessorView& view) {
    ShownInstrument shown{.played = view.instrument.playedObjects(),
                          .scene = nullptr,
                          .furniture = nullptr,
                          .onStage = view.stage.hasStage(),
                          .bodies = view.stage.stageBodies()};
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
    if (played.size() == 1)
        for (const auto& part : furniture->parts())
            for (const float side : {-1.0f, 1.0f})
                places.push_back(scenePlace(vectorOf(part.shape.middle) +
                                            side * vectorOf(part.shape.halfExtent)));
    return places;
}

std::optional<ScenePick> ShownInstrument::pick(const ViewRay& ray) const {
    return onStage ? scene->pick(ray.origin, ray.direction, bodies)
                   : scene->pick(ray.origin, ray.direction);
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
