#include "Scene/SceneStage.h"

#include "Object/OneLine.h"
#include "Scene/NamedContent.h"
#include "Scene/ScenePlayer.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr std::size_t maximumMovingSlots = 64; // of all simulations, unless a single one has more
constexpr int middleVelocity = 64;
constexpr double longestRehearsalSeconds = 3;
constexpr double maximumWorkBefore = 2e6; // a few seconds, in the units of RigidWorld::work

/// Interpolates from the softest to the hardest note.
double between(const std::array<double, 2>& ends, int velocity) {
    return std::lerp(ends[0], ends[1], (velocity - 1) / 126.0);
}

} // namespace

Result<std::shared_ptr<const Instrument>> buildInstrument(const KeyMap& keyMap,
                                                          ObjectSource& objects) {
    if (keyMap.kind != KeyMapKind::scene)
        return Instrument::build(keyMap, objects);
    const auto made =
        sceneNamed(keyMap.object)
            .and_then([&](const Scene& scene) { return SceneAssets::make(scene, objects); })
            .and_then(&SceneStage::make);
    if (!made)
        return tl::unexpected(made.error());
    const auto& stage = *made;
    if (stage->slots().empty())
        return failure("nothing in the scene " + inQuotes(stage->assets()->scene().name) +
                       " can sound");
    if (const auto bounded = boundedSlots(stage->slots(), inQuotes(keyMap.object), "bodies");
        !bounded)
        return tl::unexpected(bounded.error());
    return Instrument::onStage(keyMap, stage->slots(),
                               stage->slotOfKey(keyMap.lowestNote, keyMap.highestNote), stage);
}

BodyPose bodyPose(const SceneSimulation& run, std::size_t slot) {
    const auto& pose = run.pose(slot);
    if (!pose)
        return {};
    const Eigen::Vector3f origin = pose->translation().cast<float>();
    const auto turn = Eigen::Quaterniond(pose->linear()).normalized().cast<float>();
    return {.isThere = true,
            .originMetres = {origin.x(), origin.y(), origin.z()},
            .turn = {turn.x(), turn.y(), turn.z(), turn.w()}};
}

Result<std::shared_ptr<const SceneStage>>
SceneStage::make(std::shared_ptr<const SceneAssets> assets) {
    const std::shared_ptr<SceneStage> stage(new SceneStage(std::move(assets)));
    return stage->setUp().map([&] { return std::shared_ptr<const SceneStage>(stage); });
}

Result<void> SceneStage::setUp() {
    const auto& scene = played->scene();
    std::size_t moving = scene.noteDrop ? 1 : 0, bodies = moving + played->keyboard().size();
    for (const auto& release : scene.releases) {
        const auto count = static_cast<std::size_t>(release.count);
        bodies += count;
        moving += played->roles()[release.kind].kind.model->isFixed ? 0 : count;
    }
    if (bodies > maximumBodies)
        return failure("the scene " + inQuotes(scene.name) + " has " + std::to_string(bodies) +
                       " bodies, more than the " + std::to_string(maximumBodies) +
                       " that keys can set in motion");
    int note = 0;
    while (note < 127 && !played->target(note))
        ++note;
    SceneSimulation prototype(played, trialSetup(note));
    prototype.advanceTo(0);
    if (prototype.isCrowded())
        return tl::unexpected(crowdedFault(scene));
    if (prototype.isCutShort())
        return failure("the notes of the scene " + inQuotes(scene.name) +
                       " fall for too long, or too many bodies do");
    const auto& slots = prototype.slots();
    const auto moves = [&](std::size_t slot) { return !prototype.isFixed(slot); };
    const std::size_t simulations =
        moving == 0 ? maximumSimulations
                    : std::clamp<std::size_t>(maximumMovingSlots / moving, 1, maximumSimulations);
    for (std::size_t simulation = 0; simulation < simulations; ++simulation) {
        SlotMap own;
        for (std::size_t slot = 0; slot < slots.size(); ++slot) {
            if (simulation > 0 && !moves(slot)) {
                own.push_back(slotsOfSimulations[0][slot]);
                continue;
            }
            if (moves(slot) && !firstMovingSlot)
                firstMovingSlot = static_cast<int>(allSlots.size());
            own.push_back(allSlots.size());
            allSlots.push_back(slots[slot]);
            allRoles.push_back(prototype.roleOf(slot));
            firstPlaces.push_back(prototype.places()[slot]);
            posesAtFirst.push_back(moves(slot) ? BodyPose() : bodyPose(prototype, slot));
        }
        slotsOfSimulations.push_back(std::move(own));
    }
    if (const auto& drop = scene.noteDrop) {
        delay = std::sqrt(2 * std::max(drop->softestMetres, drop->hardestMetres) /
                          std::max(scene.gravityMetresPerSecond2, 1e-3));
        return {};
    }
    return firstImpactSeconds().map([&](double seconds) { delay = seconds; });
}

double SceneStage::lengthSeconds() const {
    const auto& scene = played->scene();
    return scene.noteDrop ? delay + scene.noteDrop->lifeSeconds : scene.seconds;
}

Result<double> SceneStage::firstImpactSeconds() const {
    SceneSimulation trial(played, trialSetup(0));
    const double longest = std::min(longestRehearsalSeconds, played->scene().seconds);
    for (double seconds = 0; seconds < longest && !trial.isCutShort(); seconds += 0.01) {
        trial.advanceTo(seconds);
        if (const auto impact = trial.takeImpact(seconds))
            return impact->seconds;
        if (trial.isCrowded())
            return tl::unexpected(crowdedFault(played->scene()));
    }
    return 0;
}

SimulationSetup SceneStage::trialSetup(int midiNote) const {
    auto setup = setupFor(midiNote, middleVelocity, played->scene().seed);
    setup.maximumWork = maximumWorkBefore;
    return setup;
}

SimulationSetup SceneStage::setupFor(int midiNote, int velocity, std::uint32_t seed) const {
    const auto& scene = played->scene();
    SimulationSetup setup{.seed = seed};
    if (scene.noteDrop) {
        setup.notes = {{.seconds = delay, .note = midiNote, .velocity = velocity}};
        setup.seconds = 0;
    }
    setup.raisedMetres = between(scene.keyThrow.raisedMetres, velocity);
    setup.speedRatio = between(scene.keyThrow.speedRatios, velocity);
    return setup;
}

std::array<int, 128> SceneStage::slotOfKey(int lowestNote, int highestNote) const {
    std::array<int, 128> slots;
    slots.fill(-1);
    // The bars have the first slots, in the order of the notes.
    int bar = 0;
    const bool hasBars = !played->keyboard().empty();
    for (int note = 0; note < 128; ++note) {
        const bool isBar = hasBars && played->target(note);
        const bool plays = !played->scene().noteDrop || played->target(note).has_value();
        if (plays && note >= lowestNote && note <= highestNote)
            slots[static_cast<std::size_t>(note)] = isBar ? bar : firstMovingSlot.value_or(0);
        bar += isBar ? 1 : 0;
    }
    return slots;
}

std::unique_ptr<StagePlayer> SceneStage::makePlayer(double sampleRateHz, std::uint64_t seed) const {
    return std::make_unique<ScenePlayer>(*this, sampleRateHz, seed);
}

} // namespace idiophone
