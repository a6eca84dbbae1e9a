#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/Timer.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>

namespace idiophone {
namespace {

constexpr std::size_t objectCount = 37;
constexpr std::size_t struckTogether = 16;
constexpr std::size_t struckCell = 48;
constexpr std::size_t lastCell = 72;
constexpr int replays = 20;

// 20 g of hard plastic at 1 m/s.
constexpr double malletNewtonSeconds = 0.02;
constexpr double malletSeconds = 0.36e-3;

/// Strikes every object once, one in each cell, and then 16 of them in a single cell.
std::vector<SceneStrike> strikesOf(std::span<const SynthesiserSlot> slots) {
    std::vector<SceneStrike> strikes;
    const auto strikeAt = [&](std::size_t slot, double cells) {
        strikes.push_back({cells * cellSeconds, slot,
                           strikeInto(strikePointAt(*slots[slot].object, {0.2, 0.3, 1}),
                                      malletNewtonSeconds, malletSeconds)});
    };
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        strikeAt(slot, static_cast<double>(slot) + 0.3);
    for (std::size_t k = 0; k < struckTogether; ++k)
        strikeAt(2 * k, struckCell + (static_cast<double>(k) + 0.4) / struckTogether);
    return strikes;
}

struct CallbackFigures {
    double struckSeconds = 0;
    double worstSeconds = 0;
    double meanSeconds = 0;
    std::vector<double> seconds;
};

CallbackFigures figuresOf(const CellTimes& times) {
    const auto ringing = std::span(times.seconds).subspan(objectCount);
    return {.struckSeconds = times.seconds[struckCell],
            .worstSeconds = std::ranges::max(ringing),
            .meanSeconds = times.sum(objectCount, lastCell) / static_cast<double>(ringing.size()),
            .seconds = times.seconds};
}

void report(BenchSection& section, const std::string& name, const CallbackFigures& found) {
    const double ratio = found.worstSeconds / found.meanSeconds;
    section.row(name, "worst " + figure(found.worstSeconds * 1e6) + " us, with 16 strikes " +
                          figure(found.struckSeconds * 1e6) + " us, mean " +
                          figure(found.meanSeconds * 1e6) + " us: " + figure(ratio) +
                          " times the mean");
    section.figures["scenes"].push_back({{"name", name},
                                         {"worst_s", found.worstSeconds},
                                         {"struck_s", found.struckSeconds},
                                         {"mean_s", found.meanSeconds},
                                         {"worst_over_mean", ratio},
                                         {"seconds", found.seconds}});
    section.goals.push_back(
        {"callback: worst over mean, " + name, ratio, BenchGoal::Kind::atMost, 2});
}

/// Returns the cost of a cell with every mode below τ, divided by that of a ringing cell.
double silenceOverSound(const std::vector<SynthesiserSlot>& slots) {
    BenchScene ringing(slots, strikesOf(slots), {});
    BenchScene silent(slots, strikesOf(slots), {});
    const std::size_t cells = cellsIn(0.1);
    ringing.render(cells);
    silent.render(cells);
    silent.synthesiser().setSettings({.tau = 1e9, .material = {}});
    for (std::size_t k = 0; k < 8; ++k) // cells: truncated modes are still fading
        silent.nextCell();
    const std::vector<Contestant> contestants{[&] { benchmark::DoNotOptimize(ringing.nextCell()); },
                                              [&] { benchmark::DoNotOptimize(silent.nextCell()); }};
    const auto seconds = leastSeconds(contestants, {.count = 20, .seconds = 1e-3});
    return seconds[1] / seconds[0];
}

} // namespace

Result<BenchSection> benchCallback(const BenchContent& content) {
    const auto bars = objectsNamed(content, "xylophone-", objectCount);
    if (!bars)
        return tl::unexpected(bars.error());
    std::vector<SynthesiserSlot> asTheyAre, longRinging;
    for (std::size_t k = 0; k < objectCount; ++k) {
        asTheyAre.push_back({(*bars)[k]});
        longRinging.push_back({longRingingObject(*bars->at(36), 100, static_cast<double>(k))});
    }
    BenchScene longScene(longRinging, strikesOf(longRinging), {});
    BenchScene barScene(asTheyAre, strikesOf(asTheyAre), {});
    const auto times =
        replayInTurn(std::array{replayOf(longScene), replayOf(barScene)}, lastCell, replays);

    BenchSection section{.name = "callback",
                         .title = "37 objects ringing, 16 of them struck in one callback of 64 "
                                  "samples; each callback the least of 20 replays"};
    report(section, "37 objects of 100 long modes", figuresOf(times[0]));
    report(section, "37 factory xylophone bars", figuresOf(times[1]));
    const double silence = silenceOverSound(longRinging);
    section.row("every mode below tau", figure(100 * silence) + " % of a ringing callback");
    section.figures["silence_over_sound"] = silence;
    section.goals.push_back(
        {"callback: every mode below tau, over ringing", silence, BenchGoal::Kind::atMost, 0.01});
    return section;
}

} // namespace idiophone
