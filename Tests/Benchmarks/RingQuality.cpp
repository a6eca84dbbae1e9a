#include "Benchmarks/RingQuality.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr double unlimited = 1e9;

double energyOf(std::span<const float> signal) {
    double sum = 0;
    for (const float sample : signal)
        sum += static_cast<double>(sample) * static_cast<double>(sample);
    return sum;
}

struct JudgedObject {
    std::size_t slot = 0;
    double energy = 0;
    std::vector<float> unscaled;
};

class Judge {
public:
    Judge(const RingScene& judgedScene, const SynthesisSettings& judgedSettings, std::size_t length)
        : scene(judgedScene), settings(judgedSettings), cells(length) {
        for (std::size_t slot = 0; slot < scene.slots.size(); ++slot)
            loudest.push_back(alone(slot));
        std::sort(loudest.begin(), loudest.end(),
                  [](const auto& a, const auto& b) { return a.energy > b.energy; });
        loudest.resize(std::min(loudest.size(), loudestJudged));
    }

    std::vector<float> mix(double budget, const std::vector<SceneStrike>& strikes) const {
        SynthesisSettings budgeted = settings;
        budgeted.modeBudget = budget;
        return BenchScene(scene.slots, strikes, budgeted).render(cells);
    }

    /// Returns the maximum error of the judged objects. An object's part of a mix is half the
    /// difference from the same mix with the object's impulses negated. Negation keeps amplitudes,
    /// ranks and shares.
    double worstErrorDb(double budget) const {
        const auto together = mix(budget, scene.strikes);
        double worst = 0;
        for (const JudgedObject& object : loudest) {
            auto turned = scene.strikes;
            for (SceneStrike& strike : turned)
                if (strike.slot == object.slot)
                    for (float& part : strike.strike.impulseNewtonSeconds)
                        part = -part;
            auto difference = mix(budget, turned);
            for (std::size_t n = 0; n < difference.size(); ++n)
                difference[n] = (together[n] - difference[n]) / 2 - object.unscaled[n];
            worst = std::max(worst, energyOf(difference) / object.energy);
        }
        return 10 * std::log10(worst + 1e-30);
    }

private:
    JudgedObject alone(std::size_t slot) const {
        std::vector<SceneStrike> own;
        for (SceneStrike strike : scene.strikes)
            if (strike.slot == slot) {
                strike.slot = 0;
                own.push_back(strike);
            }
        SynthesisSettings unscaled = settings;
        unscaled.modeBudget = unlimited;
        JudgedObject object{
            .slot = slot, .unscaled = BenchScene({scene.slots[slot]}, own, unscaled).render(cells)};
        object.energy = energyOf(object.unscaled);
        return object;
    }

    const RingScene& scene;
    SynthesisSettings settings;
    std::size_t cells;
    std::vector<JudgedObject> loudest;
};

} // namespace

FixedQuality
findFixedQuality(const RingScene& scene, const SynthesisSettings& settings, std::size_t cells) {
    const Judge judge(scene, settings, cells);
    FixedQuality found;
    for (const float sample : judge.mix(unlimited, scene.strikes))
        found.mixPeak = std::max(found.mixPeak, std::abs(static_cast<double>(sample)));

    double tooFew = 1;
    double enough = 0;
    for (const SynthesiserSlot& slot : scene.slots)
        enough += static_cast<double>(slot.object->modeCount());
    found.worstErrorDb = judge.worstErrorDb(enough);
    while (enough / tooFew > 1.02) {
        const double budget = std::sqrt(tooFew * enough);
        const double error = judge.worstErrorDb(budget);
        if (error <= fixedQualityDb) {
            enough = budget;
            found.worstErrorDb = error;
        } else {
            tooFew = budget;
        }
    }
    found.modeBudget = enough;
    return found;
}

} // namespace idiophone
