#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/Timer.h"
#include "Plugin/BlockPieces.h"
#include "Synth/CellStrikes.h"

#include <array>
#include <benchmark/benchmark.h>

namespace idiophone {
namespace {

constexpr std::size_t keys = 61, modesOfKey = 2000;
constexpr int replays = 20;
constexpr std::array<std::size_t, 2> crowds{64, 1024};

struct ResetTimes {
    double resetSeconds = 0;
    double cellSeconds = 0; ///< of the same objects ringing
};

/// Strikes all keys of a large object, renders a cell and resets them.
ResetTimes resetOfStruckKeys(const ModalObject& body) {
    std::vector<SynthesiserSlot> slots;
    for (std::size_t key = 0; key < keys; ++key)
        slots.push_back({longRingingObject(body, modesOfKey, 0.1 * static_cast<double>(key))});
    const auto strike = strikeInto(strikePointAt(*slots.front().object, {0.2, 0.3, 1}), 0.02, 0);
    Synthesiser synthesiser(slots, benchSampleRateHz);
    alignas(64) std::array<float, cellSamples> cell{};
    const CellOutput output(cell);
    const Replay replay{.restart =
                            [&] {
                                for (std::size_t key = 0; key < keys; ++key)
                                    synthesiser.strike(key, strike, 0, output);
                                synthesiser.beginCell(output);
                            },
                        .render =
                            [&](std::size_t step) {
                                if (step == 0)
                                    synthesiser.beginCell(output);
                                else
                                    synthesiser.reset();
                            }};
    synthesiser.beginCell(output);
    const auto times = replayInTurn(std::array{replay}, 2, replays).front();
    return {.resetSeconds = times.seconds[1], .cellSeconds = times.seconds[0]};
}

/// Returns the cost of one of many, divided by that of one of few.
template <class Work>
double costInCrowd(BenchSection& section, const std::string& name, Work work) {
    std::vector<Contestant> contestants;
    for (const std::size_t count : crowds)
        contestants.push_back([=] { work(count); });
    const auto seconds = leastSeconds(contestants, {.count = 20, .seconds = 2e-3});
    std::array<double, crowds.size()> eachSeconds{};
    for (std::size_t k = 0; k < crowds.size(); ++k)
        eachSeconds[k] = seconds[k] / static_cast<double>(crowds[k]);
    section.row(name, figure(eachSeconds[0] * 1e9) + " ns each of 64, " +
                          figure(eachSeconds[1] * 1e9) + " ns each of 1024");
    section.figures["crowds"].push_back({{"name", name}, {"each_s", eachSeconds}});
    return eachSeconds[1] / eachSeconds[0];
}

} // namespace

Result<BenchSection> benchCrowd(const BenchContent& content) {
    const auto bodies = objectsNamed(content, "xylophone-");
    if (!bodies)
        return tl::unexpected(bodies.error());
    BenchSection section{.name = "crowd", .title = "steps of a callback that grow with a crowd"};

    const auto reset = resetOfStruckKeys(*bodies->front());
    section.row("reset of 61 struck objects of 2000 modes",
                figure(reset.resetSeconds * 1e6) + " us; a cell of their sound " +
                    figure(reset.cellSeconds * 1e6) + " us");
    section.figures["reset_s"] = reset.resetSeconds;
    section.figures["cell_s"] = reset.cellSeconds;
    section.goals.push_back({"crowd: reset of struck objects over a cell of their sound",
                             reset.resetSeconds / reset.cellSeconds, BenchGoal::Kind::atMost, 0.1});

    CellStrikes strikes(crowds.back());
    const double pending = costInCrowd(section, "pending strikes", [&](std::size_t count) {
        for (std::size_t k = 0; k < count; ++k)
            strikes.schedule(0, {}, 0, static_cast<double>(k * 389 % count));
        benchmark::DoNotOptimize(strikes.freeSpace());
        strikes.clear();
    });
    section.goals.push_back(
        {"crowd: a pending strike of 1024 over one of 64", pending, BenchGoal::Kind::atMost, 2});

    std::array<juce::MidiBuffer, crowds.size()> blocks;
    const juce::uint8 dump[]{1, 2, 3};
    for (std::size_t k = 0; k < crowds.size(); ++k)
        for (std::size_t message = 0; message < crowds[k]; ++message)
            blocks[k].addEvent(juce::MidiMessage::createSysExMessage(dump, 3), 0);
    const auto pieces = std::make_unique<BlockPieces>();
    const double exclusive =
        costInCrowd(section, "system exclusive messages in a block", [&](std::size_t count) {
            pieces->begin(blocks[count == crowds[0] ? 0 : 1], 128);
            while (const auto piece = pieces->next())
                benchmark::DoNotOptimize(piece->length);
        });
    section.goals.push_back({"crowd: a system exclusive message of 1024 over one of 64", exclusive,
                             BenchGoal::Kind::atMost, 2});
    return section;
}

} // namespace idiophone
