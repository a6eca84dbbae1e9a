#include "Browser/BrowserInstrument.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/OwnSlots.h"
#include "Instrument/SingleObjectMap.h"
#include "Instrument/StartingLevel.h"
#include "Object/OneLine.h"
#include "Scene/SceneStage.h"

#include <algorithm>

namespace idiophone {
namespace {

/// A callback that comes meanwhile waits for a few pieces only. Each is about 10 ms of a scene, so
/// that two of them get ahead.
constexpr int maximumPieces = 2;

} // namespace

BrowserInstrument::BrowserInstrument(double sampleRateHz, bool isOffline)
    : rateHz(sampleRateHz), isOffline(isOffline) {
    output.prepare(rateHz, static_cast<int>(maximumFrames));
    events.reserve(4096);
}

Result<void> BrowserInstrument::loadFactory(std::string_view name) {
    const auto* preset = findFactoryPreset(name);
    if (preset == nullptr)
        return failure("there is no factory preset " + inQuotes(name));
    return load(*preset);
}

Result<void> BrowserInstrument::loadText(std::string_view text, std::string_view name) {
    return parsePreset(text, name).and_then([&](Preset preset) { return load(std::move(preset)); });
}

Result<void> BrowserInstrument::loadObject(const std::string& name) {
    const auto object = fetched.find(name);
    if (!object)
        return tl::unexpected(object.error());
    if ((*object)->modeCount() == 0 || (*object)->shapeVertexCount() == 0 ||
        (*object)->faceCount() == 0)
        return failure(name + ": it has no mode, or no surface to be struck");
    auto preset = initialPreset();
    preset.name = (*object)->name.empty() ? name : (*object)->name;
    preset.description = {};
    preset.keyMap = singleObjectMap(**object, name, KeyMapKind::scaled);
    auto instrument = Instrument::build(preset.keyMap, fetched);
    if (!instrument)
        return tl::unexpected(instrument.error());
    const Phrase phrase(*instrument, preset.surface, rateHz);
    auto& values = preset.parameters;
    values = withAudibleMallet(phrase, values);
    values.set(ParameterId::level, startingLevel(phrase, values));
    play(std::move(preset), std::move(*instrument));
    return {};
}

Result<void> BrowserInstrument::load(Preset preset) {
    auto instrument = buildInstrument(preset.keyMap, fetched);
    if (!instrument)
        return failure(preset.name + ": " + instrument.error().message);
    play(std::move(preset), std::move(*instrument));
    return {};
}

void BrowserInstrument::play(Preset preset, std::shared_ptr<const Instrument> instrument) {
    current = withSetupOf(current, preset.parameters);
    auto next = std::make_unique<Player>(std::move(instrument), rateHz, preset.surface, preset.seed,
                                         preset.matched());
    next->setOffline(isOffline);
    next->setSilencedModes(silencedModes(next->instrument(), preset.mutedModes, {}));
    if (player)
        next->takeControllersOf(*player);
    next->prepare(current, next->modulationWheel());
    player = std::move(next);
    played = std::move(preset);
    slotsOfObjects = ownSlots(player->instrument());
    surfaces.clear();
    surfaces.resize(slotsOfObjects.size());
    events.clear();
    output.reset();
    fetched.forgetUnplayed();
}

const ObjectSurface& BrowserInstrument::surfaceOf(std::size_t object) {
    auto& surface = surfaces[object];
    if (!surface)
        surface = std::make_unique<ObjectSurface>(
            *player->instrument().slots()[slotsOfObjects[object]].object);
    return *surface;
}

void BrowserInstrument::strike(std::size_t object,
                               const std::array<double, 3>& pointMetres,
                               int velocity) {
    if (object < surfaces.size())
        player->strikeSurface({.slot = slotsOfObjects[object],
                               .point = surfaceOf(object).nearest(pointMetres),
                               .velocity = velocity});
}

void BrowserInstrument::scrape(std::size_t object,
                               const std::array<double, 3>& pointMetres,
                               double pressure) {
    if (object < surfaces.size())
        player->scrapeSurface({.slot = slotsOfObjects[object],
                               .point = surfaceOf(object).nearest(pointMetres),
                               .pressure = pressure});
}

void BrowserInstrument::silence() {
    if (player)
        player->reset();
    events.clear();
    output.reset();
}

void BrowserInstrument::work() {
    if (player && player->matchedGain())
        player->matchedGain()->answer();
    if (player)
        for (int piece = 0; piece < maximumPieces && player->stage().simulateAhead(); ++piece)
            continue;
}

std::span<const float> BrowserInstrument::poses() {
    if (!player)
        return {};
    poseNumbers.clear();
    for (const auto& pose : player->stage().bodyPoses()) {
        const auto& [x, y, z] = pose.originMetres;
        const auto& [i, j, k, w] = pose.turn;
        poseNumbers.insert(poseNumbers.end(), {pose.isThere ? 1.0f : 0.0f, x, y, z, i, j, k, w});
    }
    return poseNumbers;
}

StereoSpan BrowserInstrument::render(std::size_t frames) {
    frames = std::min(frames, maximumFrames);
    const StereoSpan block{std::span(left).first(frames), std::span(right).first(frames)};
    if (!player) {
        std::ranges::fill(block.left, 0.0f);
        std::ranges::fill(block.right, 0.0f);
        return block;
    }
    player->process(block, events, current);
    events.clear();
    if (const auto silenced = player->takeSilenced())
        output.hush(*silenced);
    const std::array channels{left.data(), right.data()};
    output.process(block.left, block.right, channels, current);
    return block;
}

} // namespace idiophone
