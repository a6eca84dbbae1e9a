#include "Synth/Synthesiser.h"

#include "Synth/ModalResonator.h"
#include "Synth/QualityScaling.h"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

namespace idiophone {

namespace {

void clear(const CellOutput& cell) {
    for (std::size_t c = 0; c < cell.channels(); ++c)
        std::fill_n(cell[c].data(), cellSamples, 0.0f);
}

} // namespace

struct Synthesiser::Implementation {
    double sampleRate;
    std::unique_ptr<SynthesisScratch> scratch;
    std::deque<ModalResonator> objects; ///< do not move
    SynthesisSettings settings;
    bool settingsChanged = false;
    std::int64_t nextCell = 0;

    std::vector<SlotStatus> status;
    std::vector<char> wasTouched; ///< of every slot, since its last reset
    std::int64_t mixedNow = 0; ///< number of mixed modes, including those that strikes have added
    // The slots that ring in this cell, with their demands and shares.
    std::vector<std::int32_t> sounding; ///< ascending
    std::vector<ModeDemand> demands;
    std::vector<std::int32_t> shares;
    std::vector<std::int32_t> ranking;

    void listSounding();
    void report();
    std::int32_t allowance(std::size_t slot) const;
    template <class Action>
    bool apply(std::size_t slot, Action action);
};

Synthesiser::Synthesiser(std::vector<SynthesiserSlot> slots,
                         double sampleRateHz,
                         std::size_t channels)
    : implementation(std::make_unique<Implementation>()) {
    auto& all = *implementation;
    all.sampleRate = sampleRateHz;
    std::size_t maximumModes = 0;
    for (SynthesiserSlot& slot : slots) {
        if (!slot.object)
            slot.object = std::make_shared<const ModalObject>();
        maximumModes = std::max(maximumModes, slot.object->modeCount());
    }
    all.scratch = std::make_unique<SynthesisScratch>(maximumModes, channels);
    std::map<const ModalObject*, ModeGroups::ModeWeights> known; // one for all slots of an object
    for (SynthesiserSlot& slot : slots) {
        auto& modeWeights = known[slot.object.get()];
        if (!modeWeights)
            modeWeights =
                std::make_shared<const std::vector<double>>(summedSquareShapes(*slot.object));
        all.objects.emplace_back(std::move(slot), modeWeights,
                                 static_cast<std::uint32_t>(all.objects.size()), channels,
                                 sampleRateHz, *all.scratch);
    }
    all.status.resize(slots.size());
    all.wasTouched.resize(slots.size());
    all.sounding.reserve(slots.size());
    all.demands.reserve(slots.size());
    all.shares.resize(slots.size());
    all.ranking.resize(slots.size());
}

Synthesiser::~Synthesiser() = default;

void Synthesiser::setSettings(const SynthesisSettings& settings) noexcept {
    auto& all = *implementation;
    const SynthesisSettings wanted = corrected(settings, all.settings);
    all.settingsChanged = all.settingsChanged || wanted != all.settings;
    all.settings = wanted;
}

void Synthesiser::setDamping(std::size_t slot, double dampingPerSecond) noexcept {
    if (slot < slotCount())
        implementation->objects[slot].setDamping(dampingPerSecond);
}

void Synthesiser::setFrequencyRatio(std::size_t slot, double ratio) noexcept {
    if (slot < slotCount())
        implementation->objects[slot].setFrequencyRatio(ratio);
}

double Synthesiser::frequencyRatio(std::size_t slot) const noexcept {
    return slot < slotCount() ? implementation->objects[slot].frequencyRatio() : 1;
}

void Synthesiser::setMaterial(std::size_t slot,
                              const std::optional<LiveMaterial>& material) noexcept {
    if (slot < slotCount() && (!material || valid(*material)))
        implementation->objects[slot].setMaterial(material);
}

void Synthesiser::setSilencedModes(std::size_t slot,
                                   std::span<const std::uint8_t> silenced) noexcept {
    if (slot < slotCount())
        implementation->objects[slot].setSilencedModes(silenced);
}

void Synthesiser::setTubeOpening(const TubeOpening& opening) noexcept {
    implementation->scratch->tubes = opening;
}

void Synthesiser::beginCell(const CellOutput& cell) noexcept {
    clear(cell);
    mixInto([&cell](std::size_t) -> const CellOutput& { return cell; });
}

void Synthesiser::beginCell(std::span<const CellOutput> cellsOfSlots) noexcept {
    for (const CellOutput& cell : cellsOfSlots)
        clear(cell);
    mixInto([cellsOfSlots](std::size_t slot) -> const CellOutput& { return cellsOfSlots[slot]; });
}

template <class CellOf>
void Synthesiser::mixInto(CellOf cellOf) noexcept {
    auto& all = *implementation;
    all.scratch->tubesNow = all.scratch->tubes.start;
    all.listSounding();
    all.mixedNow = 0;
    shareModeBudget(all.demands, all.settings.modeBudget, all.settings.qualitySlope, all.ranking,
                    all.shares);
    for (std::size_t k = 0; k < all.sounding.size(); ++k) {
        const auto slot = static_cast<std::size_t>(all.sounding[k]);
        all.objects[slot].mix(all.shares[k], cellOf(slot));
        all.mixedNow += all.objects[slot].modesMixed();
    }
    all.scratch->tubesNow = all.scratch->tubes.end;
    all.report();
}

void Synthesiser::Implementation::listSounding() {
    sounding.clear();
    demands.clear();
    for (std::size_t slot = 0; slot < objects.size(); ++slot) {
        if (!objects[slot].beginCell(nextCell, settings, settingsChanged))
            continue;
        sounding.push_back(static_cast<std::int32_t>(slot));
        demands.push_back(objects[slot].demand());
    }
    settingsChanged = false;
    ++nextCell;
}

void Synthesiser::Implementation::report() {
    std::fill(status.begin(), status.end(), SlotStatus{});
    for (std::size_t k = 0; k < sounding.size(); ++k) {
        const auto slot = static_cast<std::size_t>(sounding[k]);
        const ModalResonator& object = objects[slot];
        status[slot] = {static_cast<float>(object.demand().amplitude),
                        object.demand().modes,
                        object.modesMixed(),
                        static_cast<std::int32_t>(object.channelsSounding()),
                        shares[k],
                        object.groupCount(),
                        object.groupsAudible()};
    }
}

std::int32_t Synthesiser::Implementation::allowance(std::size_t slot) const {
    const bool sounds = std::ranges::binary_search(sounding, static_cast<std::int32_t>(slot));
    const std::size_t objectsThen = sounding.size() + (sounds ? 0 : 1);
    const double budget = std::min(settings.modeBudget, 1e9);
    const double unused = std::max(0.0, budget - static_cast<double>(mixedNow));
    return std::max({status[slot].share,
                     static_cast<std::int32_t>(budget / static_cast<double>(objectsThen)),
                     objects[slot].modesMixed() + static_cast<std::int32_t>(unused)});
}

/// Applies an action to one resonator and updates the count of mixed modes for the others.
template <class Action>
bool Synthesiser::Implementation::apply(std::size_t slot, Action action) {
    ModalResonator& object = objects[slot];
    wasTouched[slot] = 1;
    const std::int32_t allowed = allowance(slot);
    mixedNow -= object.modesMixed();
    const bool done = action(object, allowed);
    mixedNow += object.modesMixed();
    return done;
}

bool Synthesiser::strike(std::size_t slot,
                         const Strike& strike,
                         double sampleInCell,
                         const CellOutput& cell) noexcept {
    auto& all = *implementation;
    return slot < slotCount() && all.apply(slot, [&](ModalResonator& object, std::int32_t allowed) {
        object.catchUp(all.settings);
        return object.strike(strike, sampleInCell, allowed, cell);
    });
}

bool Synthesiser::contactsUsedUp(std::size_t slot) const noexcept {
    return slot < slotCount() && implementation->objects[slot].contactsUsedUp();
}

bool Synthesiser::applyForce(std::size_t slot,
                             const ForceCell& force,
                             const CellOutput& cell) noexcept {
    auto& all = *implementation;
    return slot < slotCount() && all.apply(slot, [&](ModalResonator& object, std::int32_t allowed) {
        return object.applyForce(force, allowed, cell);
    });
}

void Synthesiser::reset() noexcept {
    auto& all = *implementation;
    // Skip untouched slots: their banks are in the reset state already, and may be large.
    for (std::size_t slot = 0; slot < all.objects.size(); ++slot)
        if (std::exchange(all.wasTouched[slot], 0) != 0)
            all.objects[slot].reset();
    std::fill(all.status.begin(), all.status.end(), SlotStatus{});
    all.sounding.clear();
    all.mixedNow = 0;
}

std::span<const Synthesiser::SlotStatus> Synthesiser::status() const noexcept {
    return implementation->status;
}

std::int64_t Synthesiser::modesMixed() const noexcept {
    std::int64_t sum = 0;
    for (const SlotStatus& slot : implementation->status)
        sum += slot.modesMixed;
    return sum;
}

void Synthesiser::report(std::size_t slot, SoundingGroups& groups) const noexcept {
    if (slot < slotCount())
        implementation->objects[slot].report(groups);
}

const SynthesisSettings& Synthesiser::settings() const noexcept {
    return implementation->settings;
}

bool Synthesiser::silent() const noexcept {
    return std::ranges::all_of(implementation->objects, &ModalResonator::silent);
}

double Synthesiser::sampleRateHz() const noexcept {
    return implementation->sampleRate;
}

std::size_t Synthesiser::slotCount() const noexcept {
    return implementation->objects.size();
}

} // namespace idiophone
