#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/NaiveBank.h"
#include "Benchmarks/RingQuality.h"
#include "Benchmarks/RingScene.h"
#include "Benchmarks/Timer.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <limits>
#include <tuple>

namespace idiophone {
namespace {

constexpr double sceneSeconds = 2;
constexpr int replays = 5;

// The threshold at which the paper reports no audible loss.
constexpr double tau = 2;

const SynthesisSettings everyMode{.tau = 0, .modeBudget = 1e9, .compression = 0, .material = {}};
const SynthesisSettings reduced{.tau = tau, .modeBudget = 1e9, .compression = 1, .material = {}};

using PolesOf = std::vector<ModalPole> (*)(const ModalObject&);

/// The paper's loop over every mode of all objects that have been struck.
class NaiveScene {
public:
    NaiveScene(const RingScene& scene, PolesOf poles)
        : firstCells(scene.slots.size(), std::numeric_limits<std::size_t>::max()) {
        for (const SynthesiserSlot& slot : scene.slots)
            banks.emplace_back(poles(*slot.object), benchSampleRateHz);
        for (const SceneStrike& strike : scene.strikes) {
            const auto at = static_cast<std::size_t>(strike.seconds / cellSeconds);
            firstCells[strike.slot] = std::min(firstCells[strike.slot], at);
        }
    }

    void restart() {
        for (NaiveBank& bank : banks)
            bank.excite();
    }

    void render(std::size_t cellIndex) {
        cell.fill(0);
        for (std::size_t slot = 0; slot < banks.size(); ++slot)
            if (firstCells[slot] <= cellIndex)
                banks[slot].render(cell);
        benchmark::DoNotOptimize(cell);
    }

    std::size_t modeCount() const {
        std::size_t sum = 0;
        for (const NaiveBank& bank : banks)
            sum += bank.size();
        return sum;
    }

private:
    std::vector<NaiveBank> banks;
    std::vector<std::size_t> firstCells;
    alignas(64) std::array<float, cellSamples> cell{};
};

/// Returns audio frames of 1/100 s per second of computing, for each frame of the scene.
std::vector<double> framesPerSecond(std::span<const double> cellCosts, double frameSeconds = 0.01) {
    std::vector<double> rates;
    std::size_t cell = 0;
    for (int frame = 1; cell < cellCosts.size(); ++frame) {
        double cost = 0;
        const std::size_t first = cell;
        while (cell < cellCosts.size() &&
               static_cast<double>(cell) * cellSeconds < frame * frameSeconds - 1e-9)
            cost += cellCosts[cell++];
        rates.push_back(static_cast<double>(cell - first) * cellSeconds / 0.01 / cost);
    }
    return rates;
}

/// Returns the slowest tenth of a second divided by the mean, from the third one to the last
/// strike.
double flatness(std::span<const double> cellCosts) {
    const auto tenths = framesPerSecond(cellCosts.first(cellsIn(ringStrikeSeconds) - 1), 0.1);
    const std::vector<double> judged(tenths.begin() + 2, tenths.begin() + 10);
    double mean = 0;
    for (const double rate : judged)
        mean += rate / static_cast<double>(judged.size());
    return *std::min_element(judged.begin(), judged.end()) / mean;
}

enum Step { everyPaperMode, paperLoop, kernelStep, cutStep, scaledStep };

struct Curve {
    const char* name;
    CellTimes times = {};
    double modesMixed = 0; ///< mean
};

double whole(const Curve& curve) {
    return curve.times.sum();
}

double striking(const Curve& curve) {
    return curve.times.sum(0, cellsIn(ringStrikeSeconds));
}

void reportCurves(BenchSection& section, std::span<const Curve> curves) {
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const double rate = sceneSeconds * 100 / whole(curves[k]);
        const double factor = k == 0 ? 1 : whole(curves[k - 1]) / whole(curves[k]);
        section.row(curves[k].name,
                    figure(rate) + " audio frames a second, " +
                        figure(100 * striking(curves[k]) / ringStrikeSeconds) +
                        " % of a core while strikes come" +
                        (k == 0 ? std::string() : "; a factor of " + figure(factor)));
        section.figures["curves"].push_back(
            {{"name", curves[k].name},
             {"frames_per_second", framesPerSecond(curves[k].times.seconds)},
             {"mean_frames_per_second", rate},
             {"modes_mixed_mean", curves[k].modesMixed},
             {"factor", factor}});
    }
}

void reportGoals(BenchSection& section, std::span<const Curve> curves) {
    const Curve& last = curves[scaledStep];
    const double flat = flatness(last.times.seconds);
    for (const auto& [step, name, key] :
         {std::tuple(everyPaperMode, "all 3N modes of eq. 12", "every_mode_over_everything"),
          std::tuple(paperLoop, "audible modes only", "naive_over_everything")}) {
        const double ratio = whole(curves[step]) / whole(last);
        section.row(std::string("the paper's loop over everything, ") + name,
                    figure(ratio) + " over two seconds, " +
                        figure(striking(curves[step]) / striking(last)) + " while strikes come");
        section.figures[key] = ratio;
        section.goals.push_back({std::string("rings: the paper's loop over everything, ") + name,
                                 ratio, BenchGoal::Kind::atLeast, 100});
    }
    section.figures["slowest_tenth_over_mean"] = flat;
    section.goals.push_back({"rings: quality scaling at fixed quality",
                             whole(curves[cutStep]) / whole(last), BenchGoal::Kind::atLeast, 1.5});
    section.goals.push_back(
        {"rings: slowest tenth over the mean", flat, BenchGoal::Kind::atLeast, 0.85});
}

BenchSection sectionOf(const RingScene& scene,
                       const FixedQuality& quality,
                       std::size_t everyModes,
                       std::size_t audibleModes,
                       std::span<const Curve> curves) {
    BenchSection section{.name = "rings",
                         .title = std::to_string(ringCount) + " rings of " +
                                  std::to_string(scene.ringVertices) + " vertices on a table of " +
                                  std::to_string(scene.tableVertices) + ", " +
                                  std::to_string(scene.strikes.size()) +
                                  " strikes within a second, two seconds rendered"};
    section.row("modes",
                std::to_string(everyModes) + " (3N), " + std::to_string(audibleModes) +
                    " audible, " + figure(curves[cutStep].modesMixed) +
                    " mixed on average after compression and truncation; the mix peaks at " +
                    figure(quality.mixPeak / pascalsPerTau) +
                    " 16-bit steps, tau = " + figure(tau, 1));
    section.row("fixed quality", "a budget of " + figure(quality.modeBudget) +
                                     " modes leaves the ten loudest objects within " +
                                     figure(quality.worstErrorDb) + " dB");
    section.figures["modes_3n"] = everyModes;
    section.figures["modes_audible"] = audibleModes;
    section.figures["strikes"] = scene.strikes.size();
    section.figures["peak_steps"] = quality.mixPeak / pascalsPerTau;
    section.figures["tau"] = tau;
    section.figures["mode_budget"] = quality.modeBudget;
    section.figures["worst_error_db"] = quality.worstErrorDb;
    return section;
}

} // namespace

Result<BenchSection> benchRings(const BenchContent&) {
    const auto made = makeRingScene();
    if (!made)
        return tl::unexpected(made.error());
    const RingScene& scene = *made;
    const std::size_t cells = cellsIn(sceneSeconds);
    const FixedQuality quality = findFixedQuality(scene, reduced, cells);
    SynthesisSettings everything = reduced;
    everything.modeBudget = quality.modeBudget;

    NaiveScene everyMode3N(scene, polesOfEveryMode);
    NaiveScene audible(scene, audiblePoles);
    BenchScene kernel(scene.undampedSlots, scene.strikes, everyMode);
    BenchScene cut(scene.slots, scene.strikes, reduced);
    BenchScene scaled(scene.slots, scene.strikes, everything);
    std::array<Curve, 5> curves{
        Curve{"the paper's loop, all 3N modes"}, Curve{"the paper's loop, audible modes"},
        Curve{"our kernel, the same modes"}, Curve{"with compression and truncation"},
        Curve{"with quality scaling"}};
    const auto naive = [](NaiveScene& played) {
        return Replay{[&] { played.restart(); }, [&](std::size_t cell) { played.render(cell); }};
    };
    auto times = replayInTurn(std::array{naive(everyMode3N), naive(audible), replayOf(kernel),
                                         replayOf(cut), replayOf(scaled)},
                              cells, replays);
    for (std::size_t k = 0; k < curves.size(); ++k)
        curves[k].times = std::move(times[k]);
    curves[kernelStep].modesMixed = meanOf(kernel.modesMixed(cells));
    curves[cutStep].modesMixed = meanOf(cut.modesMixed(cells));
    curves[scaledStep].modesMixed = meanOf(scaled.modesMixed(cells));

    BenchSection section =
        sectionOf(scene, quality, everyMode3N.modeCount(), audible.modeCount(), curves);
    reportCurves(section, curves);
    reportGoals(section, curves);
    return section;
}

} // namespace idiophone
