#include "Synth/RegroupTurns.h"
#include "ModalReference.h"
#include "Synth/ModalResonator.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;
constexpr std::size_t slots = 12, modes = 60;

/// Modes that beat with little damping and merge with much.
ModalObject denseObject() {
    std::vector<double> frequencies;
    for (std::size_t k = 0; k < modes; ++k)
        frequencies.push_back(200 + 0.7 * static_cast<double>(k));
    return ringingObject(frequencies, 2, std::vector<float>(modes, 0.5f));
}

SynthesisSettings settingsOf(double fluidDamping) {
    SynthesisSettings settings = exactSettings();
    settings.compression = 1;
    settings.material = LiveMaterial{1e10, 1000, {fluidDamping, 0}};
    return settings;
}

} // namespace

TEST_CASE("Turns go to every slot once, within the modes and slots of a cell") {
    RegroupTurns turns(100);
    std::vector<std::size_t> visited;
    const auto visit = [&visited](std::size_t slot) -> std::size_t {
        visited.push_back(slot);
        return slot < 50 ? 40 : 0; // the others have nothing to regroup
    };
    turns.give(visit);
    CHECK(visited.empty());
    turns.restart();
    int cells = 0;
    for (std::size_t before = 1; before != visited.size(); ++cells) {
        before = visited.size();
        turns.give(visit);
        CHECK(visited.size() - before <= RegroupTurns::slotsPerCell);
        if (before < 40)
            CHECK(visited.size() - before == (RegroupTurns::modesPerCell + 39) / 40);
    }
    REQUIRE(visited.size() == 100);
    CHECK(std::ranges::is_sorted(visited));
    CHECK(cells > 100 / static_cast<int>(RegroupTurns::slotsPerCell));
}

TEST_CASE("After a change of material a bounded number of modes regroup in each cell") {
    const ModalObject object = denseObject();
    Synthesiser synthesiser(std::vector<SynthesiserSlot>(slots, slotOf(object)), sampleRate);
    std::array<float, cellSamples> samples{};
    const CellOutput cell{samples};
    const auto countMerged = [&] {
        return std::ranges::count_if(synthesiser.status(), [](const SlotStatus& slot) {
            return slot.groups < static_cast<std::int32_t>(modes);
        });
    };
    synthesiser.setSettings(settingsOf(2));
    synthesiser.beginCell(cell);
    for (std::size_t slot = 0; slot < slots; ++slot)
        REQUIRE(synthesiser.strike(slot, unitStrike(), 0, cell));
    synthesiser.beginCell(cell);
    REQUIRE(countMerged() == 0);
    synthesiser.setSettings(settingsOf(30));
    std::ptrdiff_t merged = 0;
    for (int k = 0; k < 20 && merged < std::ptrdiff_t{slots}; ++k) {
        synthesiser.beginCell(cell);
        const auto now = countMerged();
        CHECK(now - merged <=
              static_cast<std::ptrdiff_t>((RegroupTurns::modesPerCell + modes - 1) / modes));
        CHECK((k < 2 || now > merged));
        merged = now;
    }
    CHECK(merged == std::ptrdiff_t{slots});
}

TEST_CASE("A settled synthesiser regroups a bounded number of modes in its first cells") {
    const ModalObject object = denseObject();
    Synthesiser synthesiser(std::vector<SynthesiserSlot>(slots, slotOf(object)), sampleRate);
    std::array<float, cellSamples> samples{};
    const CellOutput cell{samples};
    const auto isMerged = [&](std::size_t slot) {
        SoundingGroups groups(modes);
        synthesiser.report(slot, groups);
        return groups.count < modes;
    };
    const auto countMerged = [&] {
        std::size_t merged = 0;
        for (std::size_t slot = 0; slot < slots; ++slot)
            merged += isMerged(slot) ? 1 : 0;
        return merged;
    };
    synthesiser.setSettings(settingsOf(2));
    const bool isSettled = GENERATE(false, true);
    if (isSettled)
        synthesiser.settle();
    synthesiser.setSettings(settingsOf(30));
    synthesiser.beginCell(cell);
    CHECK(countMerged() == (isSettled ? 0 : slots));
    CHECK(synthesiser.strike(slots - 1, unitStrike(), 0, cell));
    synthesiser.beginCell(cell);
    if (isSettled)
        CHECK(countMerged() <= RegroupTurns::modesPerCell / modes + 1);
    for (std::size_t k = 0; k < slots; ++k)
        synthesiser.beginCell(cell);
    CHECK(countMerged() == slots);
}

TEST_CASE("A strike on a silent object has the poles of a frequency ratio set before") {
    const ModalObject object = ringingObject({440}, 5, {1});
    const auto play = [&](bool isSetFirst) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        synthesiser.setSettings(exactSettings());
        return render(synthesiser, {{4 * cellSamples, unitStrike()}}, 20, [&](int cell) {
            if (cell == (isSetFirst ? 0 : 4))
                synthesiser.setFrequencyRatio(0, 1.5);
        });
    };
    CHECK(play(true) == play(false));
}

TEST_CASE("A ringing mode that a bend lifts into the band sounds from its object's turn on") {
    Synthesiser synthesiser({slotOf(ringingObject({15}, 0.1, {1}))}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto sound = render(synthesiser, {{0, unitStrike()}}, 100, [&](int cell) {
        if (cell == 50)
            synthesiser.setFrequencyRatio(0, 4);
    });
    const auto bent = sound.begin() + 50 * cellSamples;
    CHECK(std::all_of(sound.begin(), bent, [](float sample) { return sample == 0; }));
    CHECK(std::any_of(bent, sound.end(), [](float sample) { return std::abs(sample) > 0.5f; }));
}
