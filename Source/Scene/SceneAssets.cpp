#include "Scene/SceneAssets.h"

#include "Instrument/Instrument.h"
#include "Instrument/StrikePointMetres.h"
#include "Object/OneLine.h"
#include "Scene/NamedContent.h"

#include <algorithm>
#include <numbers>

namespace idiophone {
namespace {

/// Returns the surface of a kind that sets none: as rough as its material.
Surface plainSurface(const Material& material) {
    return {.name = material.name, .roughness = material.roughness};
}

/// Bit k is the collision group of kind k. Kinds that pass through others are among the first 24
/// (SceneText); all further ones share a group. The bars have the last bit.
constexpr int keyboardGroup = 1 << 29;

int groupOf(std::size_t kind) {
    return 1 << std::min(kind, std::size_t{28});
}

int collidingGroups(const std::vector<BodyTemplate>& kinds, std::size_t kind) {
    const auto passes = [&](std::size_t one, std::size_t other) {
        return std::ranges::find(kinds[one].passes, other) != kinds[one].passes.end();
    };
    int groups = keyboardGroup;
    for (std::size_t other = 0; other < kinds.size(); ++other)
        if (!passes(kind, other) && !passes(other, kind))
            groups |= groupOf(other);
    return groups;
}

double topMetres(const ModalObject& object) {
    float top = object.vertices[2];
    for (std::size_t k = 2; k < object.vertices.size(); k += 3)
        top = std::max(top, object.vertices[k]);
    return static_cast<double>(top);
}

} // namespace

Result<std::shared_ptr<const SceneAssets>> SceneAssets::make(Scene scene, ObjectSource& objects) {
    const std::shared_ptr<SceneAssets> assets(new SceneAssets(std::move(scene)));
    return assets->loadKinds(objects)
        .and_then([&] { return assets->loadKeyboard(objects); })
        .map([&] { return std::shared_ptr<const SceneAssets>(assets); });
}

Result<void> SceneAssets::addRole(const BodyTemplate& kind,
                                  const std::shared_ptr<const ModalObject>& object,
                                  int group,
                                  int collidesWith) {
    std::shared_ptr<const ObjectSurface> surface;
    for (const auto& role : allRoles)
        if (role.kind.model->object == object)
            surface = role.surface;
    if (surface == nullptr && object->modeCount() > 0)
        surface = std::make_shared<ObjectSurface>(*object);
    return makeRigidBodyModel(kind, object)
        .map([&](const std::shared_ptr<const RigidBodyModel>& model) {
            allRoles.push_back(
                {.kind = {.model = model, .group = group, .collidesWith = collidesWith},
                 .object = kind.object,
                 .surface = surface,
                 .surfaceIndex = indexOf(kind.surface.value_or(plainSurface(object->material)))});
        });
}

std::size_t SceneAssets::indexOf(const Surface& surface) {
    auto known = std::ranges::find(allSurfaces, surface);
    if (known == allSurfaces.end())
        known = allSurfaces.insert(known, surface);
    return static_cast<std::size_t>(known - allSurfaces.begin());
}

Result<void> SceneAssets::loadKinds(ObjectSource& objects) {
    BoxSearch touching;
    for (std::size_t k = 0; k < played.kinds.size(); ++k) {
        const auto& kind = played.kinds[k];
        const auto object = kind.given != nullptr ? kind.given : objects.find(kind.object);
        if (!object)
            return tl::unexpected(object.error());
        if (auto done = addRole(kind, *object, groupOf(k), collidingGroups(played.kinds, k)); !done)
            return done;
        // Count a surface once for each kind: every simulation builds a shape for each.
        const auto& own = allRoles.back().kind.model->touchingFaces;
        touching.pairs += own.pairs;
        touching.boxes += own.boxes;
        if (touching.pairs > maximumTouchingFaces.pairs ||
            touching.boxes > maximumTouchingFaces.boxes)
            return failure("the surfaces in the scene " + inQuotes(played.name) +
                           " have too many faces together");
    }
    return {};
}

Result<void> SceneAssets::loadKeyboard(ObjectSource& objects) {
    if (!played.keyboard) {
        if (played.noteDrop)
            targets.fill(played.noteDrop->positionMetres);
        return {};
    }
    const auto& stage = *played.keyboard;
    const auto preset = presetNamed(stage.preset);
    if (!preset)
        return tl::unexpected(preset.error());
    if (preset->keyMap.kind != KeyMapKind::bars)
        return failure("the keyboard's preset " + inQuotes(preset->name) + " has no bars");
    const auto built = Instrument::build(preset->keyMap, objects);
    if (!built)
        return tl::unexpected(built.error());
    const auto& instrument = **built;
    const double middle = (preset->keyMap.lowestNote + preset->keyMap.highestNote) / 2.0;
    for (int note = preset->keyMap.lowestNote; note <= preset->keyMap.highestNote; ++note) {
        const auto& key = instrument.key(note);
        if (!instrument.hasOwn(note))
            continue;
        const auto& object = instrument.slots()[static_cast<std::size_t>(key.slot)].object;
        BodyTemplate bar;
        bar.name = object->name;
        bar.object = preset->keyMap.objectFor(note);
        bar.isFixed = true;
        if (auto done = addRole(bar, object, keyboardGroup, ~0); !done)
            return done;
        const Eigen::Isometry3d pose =
            Eigen::Translation3d(
                stage.positionMetres +
                Eigen::Vector3d((note - middle) * stage.spacingMetres, 0, -topMetres(*object))) *
            Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ());
        bars.push_back({.role = allRoles.size() - 1, .motion = {.pose = pose}});
        const auto place = key.strip->between(key.along, 0).point;
        targets[static_cast<std::size_t>(note)] =
            pose * Eigen::Vector3d(strikePointMetres(*object, place).data());
    }
    return {};
}

SynthesiserSlot SceneAssets::slotOf(std::size_t role) const {
    const auto& model = *allRoles[role].kind.model;
    return {.object = model.object, .sizeRatio = model.sizeRatio};
}

} // namespace idiophone
