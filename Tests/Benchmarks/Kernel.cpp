#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/NaiveBank.h"
#include "Benchmarks/Peak.h"
#include "Benchmarks/Timer.h"
#include "Synth/ModalBank.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <optional>

namespace idiophone {
namespace {

struct Size {
    const char* name;
    std::size_t banks;
    std::size_t modes; ///< of each bank
};

constexpr std::array sizes{Size{"64", 1, 64}, Size{"500", 1, 500}, Size{"1000", 1, 1000},
                           Size{"10000", 1, 10000}, Size{"37x100", 37, 100}};

/// Returns λ of modes from 50 Hz to 18 kHz. The spacing is slightly uneven, so that no mode is a
/// multiple of another.
std::vector<double> spreadEigenvalues(std::size_t modes) {
    std::vector<double> values(modes);
    for (std::size_t i = 0; i < modes; ++i) {
        const double place =
            (static_cast<double>(i) + 0.3 * std::sin(7.0 * static_cast<double>(i))) /
            static_cast<double>(modes);
        values[i] = std::pow(2 * std::numbers::pi * std::lerp(50.0, 18000.0, std::abs(place)), 2);
    }
    return values;
}

/// One bank as the synthesiser renders it: all blocks, one run, mono.
class FullBank {
public:
    FullBank(std::span<const double> eigenvalues, const PoleLaw& law)
        : bank(eigenvalues.size(), 1, benchSampleRateHz),
          blocks(bank.blockCount()), runs{{0, static_cast<std::int32_t>(eigenvalues.size())}} {
        std::iota(blocks.begin(), blocks.end(), 0);
        bank.movePoles(eigenvalues, law, 20, benchSampleRateHz / 2);
        const double amplitude = 1 / static_cast<double>(eigenvalues.size());
        for (std::size_t g = 0; g < eigenvalues.size(); ++g)
            bank.setState(g, {amplitude, 0});
    }

    void render(std::span<float, cellSamples> cell) {
        bank.render(blocks, runs, 1, {cell.data(), nullptr});
    }
    ModalPole pole(std::size_t g) const { return bank.pole(g); }

private:
    ModalBank bank;
    std::vector<std::int32_t> blocks;
    std::vector<ModeRun> runs;
};

using Cell = std::array<float, cellSamples>;

/// Both contestants of one size. Their modes never decay, because the timing takes many decay
/// times.
struct SizeContest {
    std::vector<FullBank> ours;
    std::vector<NaiveBank> naive;
    alignas(64) Cell cell{};

    explicit SizeContest(const Size& size) {
        const auto eigenvalues = spreadEigenvalues(size.modes);
        const PoleLaw undamped;
        std::vector<ModalPole> poles;
        for (const double eigenvalue : eigenvalues)
            poles.push_back(undamped.pole(eigenvalue));
        for (std::size_t k = 0; k < size.banks; ++k) {
            ours.emplace_back(eigenvalues, undamped);
            naive.emplace_back(poles, benchSampleRateHz).excite();
        }
    }

    void renderOurs() {
        cell.fill(0);
        for (FullBank& bank : ours)
            bank.render(cell);
        benchmark::DoNotOptimize(cell);
    }
    void renderNaive() {
        cell.fill(0);
        for (NaiveBank& bank : naive)
            bank.render(cell);
        benchmark::DoNotOptimize(cell);
    }
};

/// Returns the maximum difference from double-precision exponentials in the tenth second, in dB
/// relative to the maximum there. The damping is so light that the sound is still audible.
double errorAfterTenSecondsDb(std::size_t modes) {
    const auto eigenvalues = spreadEigenvalues(modes);
    const PoleLaw law{.eigenvalueRatio = 1, .damping = {.fluidPerSecond = 0.3}};
    FullBank bank(eigenvalues, law);
    const std::size_t cells = cellsIn(10);
    constexpr std::size_t compared = 16;
    double error = 0;
    double largest = 0;
    alignas(64) Cell cell{};
    for (std::size_t k = 0; k < cells; ++k) {
        cell.fill(0);
        bank.render(cell);
        if (k + compared < cells)
            continue;
        for (std::size_t n = 0; n < cellSamples; ++n) {
            const double seconds = static_cast<double>(k * cellSamples + n) / benchSampleRateHz;
            double exact = 0;
            for (std::size_t g = 0; g < modes; ++g) {
                const ModalPole pole = bank.pole(g);
                exact += std::exp(-pole.damping / 2 * seconds) *
                         std::cos(dampedFrequency(pole) * seconds);
            }
            exact /= static_cast<double>(modes);
            largest = std::max(largest, std::abs(exact));
            error = std::max(error, std::abs(static_cast<double>(cell[n]) - exact));
        }
    }
    return 20 * std::log10(error / largest);
}

/// Returns the goal for the share of the peak, if the project sets one for this SIMD target.
std::optional<double> peakGoal() {
    const std::string target = simdTarget();
    if (target.starts_with("AVX3"))
        return 0.70;
    if (target == "AVX2")
        return 0.60;
    return std::nullopt;
}

struct SizeFigures {
    double shareOfPeak = 0;
    double naiveShareOfPeak = 0;
    double timesNaive = 0;
    double modesInRealTime = 0;
    double shareOfCore = 0; ///< work of eq. 12 for one second, in seconds
};

void report(BenchSection& section, const Size& size, const SizeFigures& found) {
    const std::string label = std::string(size.name) + " modes";
    section.row(label, figure(100 * found.shareOfPeak) + " % of the FMA peak (the paper's loop " +
                           figure(100 * found.naiveShareOfPeak, 2) + " %), " +
                           figure(found.timesNaive) + " times the paper's loop, " +
                           figure(found.modesInRealTime / 1000) + " thousand modes in real time");
    section.figures["sizes"].push_back({{"modes", size.name},
                                        {"share_of_peak", found.shareOfPeak},
                                        {"naive_share_of_peak", found.naiveShareOfPeak},
                                        {"times_naive", found.timesNaive},
                                        {"modes_in_real_time", found.modesInRealTime},
                                        {"share_of_core", found.shareOfCore}});
    if (const auto goal = peakGoal();
        goal && size.banks == 1 && (size.modes == 500 || size.modes == 1000))
        section.goals.push_back({"kernel: share of the " + simdTarget() + " FMA peak at " + label,
                                 found.shareOfPeak, BenchGoal::Kind::atLeast, *goal});
}

} // namespace

Result<BenchSection> benchKernel(const BenchContent&) {
    constexpr std::size_t peakSteps = 1000;
    std::vector<std::unique_ptr<SizeContest>> contests;
    std::vector<Contestant> contestants{[] { benchmark::DoNotOptimize(fmaLoop(peakSteps, 0.5f)); }};
    for (const Size& size : sizes) {
        auto* contest = contests.emplace_back(std::make_unique<SizeContest>(size)).get();
        contestants.push_back([contest] { contest->renderOurs(); });
        contestants.push_back([contest] { contest->renderNaive(); });
    }
    const auto seconds = leastSeconds(contestants);
    const double peak = static_cast<double>(fmasPerStep() * peakSteps) / seconds[0];

    BenchSection section{.name = "kernel",
                         .title = "cells of 64 samples, mono; 100 % = 2 multiply-adds a mode and "
                                  "sample on " +
                                  simdTarget() + ", which is eq. 12's 4 FLOP"};
    section.row("peak", figure(peak / 1e9) + " thousand million multiply-adds a second");
    section.figures["peak_fma_per_second"] = peak;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        const double ours = seconds[2 * k + 1];
        const double naive = seconds[2 * k + 2];
        const auto modes = static_cast<double>(sizes[k].banks * sizes[k].modes);
        const double work = 2 * modes * cellSamples / peak;
        report(section, sizes[k],
               {.shareOfPeak = work / ours,
                .naiveShareOfPeak = work / naive,
                .timesNaive = naive / ours,
                .modesInRealTime = modes * cellSeconds / ours,
                .shareOfCore = ours / cellSeconds});
    }

    // Eq. 12: 3N × 4 × 44100 FLOP a second for N = 5000 vertices.
    const double paperModes = 3 * 5000;
    const double sustained =
        4 * section.figures["sizes"][3]["modes_in_real_time"].get<double>() * benchSampleRateHz;
    const double paperFlops = paperModes * 4 * benchSampleRateHz;
    section.row("eq. 12, N = 5000", figure(paperFlops / 1e6, 4) + " MFLOP a second of sound, of " +
                                        figure(sustained / 1e6, 4) + " MFLOP/s: " +
                                        figure(100 * paperFlops / sustained) + " % of a core");
    section.figures["eq12"] = {{"flop_per_second_of_sound", paperFlops},
                               {"flop_per_second_sustained", sustained},
                               {"share_of_core", paperFlops / sustained}};
    for (const std::size_t modes : {500, 1000}) {
        const double error = errorAfterTenSecondsDb(modes);
        const std::string name = "error after 10 s at " + std::to_string(modes) + " modes";
        section.row(name, figure(error, 4) + " dB of the peak there");
        section.figures["error_after_10_s_db"][std::to_string(modes)] = error;
        section.goals.push_back(
            {"kernel: " + name + " in dB", error, BenchGoal::Kind::atMost, -110});
    }
    return section;
}

} // namespace idiophone
