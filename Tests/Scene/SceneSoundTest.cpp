// Tests the sound of scenes.
#include "Instrument/ObjectLibrary.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneSimulation.h"
#include "Scene/SilentBody.h"
#include "Synth/AlignedVector.h"
#include "World/HeardBodies.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinRel;

namespace {

constexpr double rateHz = 48000;

/// The sound of a simulation on a synthesiser of its own.
class Rig {
public:
    Rig(const SceneAssets& assets, const SceneSimulation& motion)
        : synth(motion.slots(), rateHz, 1),
          sound(synth.slotCount(), assets.surfaces(), assets.scene().listener, rateHz),
          slotSamples(synth.slotCount() * cellSamples), cells(cellsOfSlotsIn(slotSamples)) {}

    double cellStartSeconds() const {
        return static_cast<double>(cellIndex) * cellSamples / rateHz;
    }
    void beginCell() {
        ++cellIndex;
        synth.beginCell(cells);
    }
    bool strike(const SceneImpact& impact) {
        return sound.strike(impact.slot, impact.strike,
                            (impact.seconds - cellStartSeconds()) * rateHz,
                            {synth, cells, cellIndex});
    }
    /// Appends the cell at the left ear to `samples`.
    void finishCell(const SceneSimulation& motion, std::vector<float>& samples) {
        const BegunCell cell{synth, cells, cellIndex};
        for (std::size_t voice = 0; voice < motion.touches().size(); ++voice)
            sound.contacts.press(voice, motion.touches()[voice], cell);
        sound.crowded.strikeBefore(cellSamples, cell);
        sound.hear(cells, motion.places(), {left, right});
        samples.insert(samples.end(), left.begin(), left.end());
    }

private:
    Synthesiser synth;
    HeardBodies sound;
    AlignedVector<float> slotSamples;
    std::vector<CellOutput> cells;
    std::int64_t cellIndex = -1;
    alignas(64) std::array<float, cellSamples> left{}, right{};
};

/// A scene's sound at the left ear, and the count of refused impacts.
struct Performance {
    std::vector<float> samples;
    std::vector<float> withoutImpacts; ///< with sliding and rolling only
    int leftOut = 0;
    double touched = 0; ///< maximum contact force in newtons
};

Performance perform(const Scene& scene, double seconds) {
    const auto assets = SceneAssets::make(scene, ObjectLibrary::shared()).value();
    SceneSimulation motion(assets);
    Rig sound(*assets, motion), touchesAlone(*assets, motion);
    Performance result;
    while (static_cast<double>(result.samples.size()) < seconds * rateHz) {
        sound.beginCell();
        touchesAlone.beginCell();
        const double end = sound.cellStartSeconds() + cellSamples / rateHz;
        motion.advanceTo(end);
        while (const auto impact = motion.takeImpact(end))
            result.leftOut += sound.strike(*impact) ? 0 : 1;
        sound.finishCell(motion, result.samples);
        touchesAlone.finishCell(motion, result.withoutImpacts);
        for (const auto& state : motion.touches())
            result.touched = std::max(result.touched, state.forceNewtons);
    }
    return result;
}

Performance perform(const char* name, double seconds) {
    return perform(*findFactoryScene(name), seconds);
}

/// Returns a scene in which a ball rolls evenly over a plate for a second.
Scene rollingBall(double radiusMetres, double metresPerSecond) {
    Scene scene;
    scene.kinds = {{.name = "plate",
                    .object = "plate",
                    .form = BodyForm::ground,
                    .isFixed = true,
                    .rollingFrictionMetres = 0},
                   {.name = "ball",
                    .object = "",
                    .given = silentBall(radiusMetres, *findMaterial("Steel")),
                    .form = BodyForm::sphere,
                    .rollingFrictionMetres = 0}};
    Release ball;
    ball.kind = 1;
    ball.positionMetres.mean = {-metresPerSecond / 2, 0, radiusMetres};
    ball.velocityMetresPerSecond.mean = {metresPerSecond, 0, 0};
    ball.spinTurnsPerSecond.mean = {0, metresPerSecond / (2 * std::numbers::pi * radiusMetres), 0};
    scene.releases = {Release(), ball};
    return scene;
}

bool isFinite(const std::vector<float>& samples) {
    return std::ranges::all_of(samples, [](float x) { return std::isfinite(x); });
}

double rms(const std::vector<float>& samples, double fromSeconds, double toSeconds) {
    double sum = 0;
    const auto from = static_cast<std::size_t>(fromSeconds * rateHz);
    const auto to = std::min(static_cast<std::size_t>(toSeconds * rateHz), samples.size());
    for (std::size_t i = from; i < to; ++i)
        sum += static_cast<double>(samples[i]) * static_cast<double>(samples[i]);
    return std::sqrt(sum / static_cast<double>(to - from));
}

} // namespace

TEST_CASE("A scene sounds from the sample of its first impact, the same each time") {
    const auto assets =
        SceneAssets::make(*findFactoryScene("Pebble in a wok"), ObjectLibrary::shared()).value();
    SceneSimulation motion(assets);
    motion.advanceTo(1);
    const auto first = motion.takeImpact(1);
    REQUIRE(first);

    const auto once = perform("Pebble in a wok", 1);
    CHECK(isFinite(once.samples));
    CHECK(once.leftOut == 0);
    const auto heard = std::ranges::find_if(once.samples, [](float x) { return x != 0; });
    const double samples = static_cast<double>(heard - once.samples.begin());
    const double late = samples - first->seconds * rateHz; // by the path around the head
    CHECK(late > -1);
    CHECK(late < HeadModel::longestDelaySeconds * rateHz + 3);
    CHECK(perform("Pebble in a wok", 1).samples == once.samples);
}

TEST_CASE("Any number of simultaneous impacts on one body sounds") {
    const auto assets =
        SceneAssets::make(*findFactoryScene("Pebble in a wok"), ObjectLibrary::shared()).value();
    SceneSimulation motion(assets);
    motion.advanceTo(1);
    auto impact = motion.takeImpact(1).value();
    impact.seconds = 0;
    const auto playedAtOnce = [&](int count) {
        Rig sound(*assets, motion);
        std::vector<float> samples;
        for (int k = 0; k < 400; ++k) {
            sound.beginCell();
            for (int struck = 0; k == 0 && struck < count; ++struck)
                CHECK(sound.strike(impact));
            sound.finishCell(motion, samples);
        }
        return rms(samples, 0.1, 0.5);
    };
    const double one = playedAtOnce(1), many = playedAtOnce(200);
    CHECK(many > 0.95 * 200 * one);
    CHECK(many < 1.3 * 200 * one); // as impulses, whose spectrum extends further
}

TEST_CASE("The rolling of a ball over ribs is 34 to 46 dB quieter than its impacts") {
    // Whether the ball rolls or hops at a time is chance. Average over starts 2 mm apart.
    double touched = 0, wholePower = 0, rolledPower = 0;
    for (int place = -4; place <= 4; ++place) {
        auto scene = *findFactoryScene("Ball on a washboard");
        scene.releases.back().positionMetres.mean.x() += 0.002 * place;
        const auto played = perform(scene, 3);
        REQUIRE(isFinite(played.samples));
        touched = std::max(touched, played.touched);
        wholePower += std::pow(rms(played.samples, 1, 3), 2);
        rolledPower += std::pow(rms(played.withoutImpacts, 1, 3), 2);
    }
    CHECK(touched > 0.05); // of its weight of 1.1 N
    const double rolledDb = 10 * std::log10(rolledPower / wholePower);
    CAPTURE(rolledDb);
    CHECK(rolledDb > -46);
    CHECK(rolledDb < -34);
}

TEST_CASE("Rolling sound grows with the square root of the weight") {
    const auto light = perform(rollingBall(0.01, 0.3), 1),
               heavy = perform(rollingBall(0.02, 0.3), 1);
    CHECK_THAT(heavy.touched / light.touched, WithinRel(8.0, 0.001));
    const double heard = rms(light.samples, 0.1, 0.9);
    CHECK(heard > 0);
    CHECK_THAT(rms(heavy.samples, 0.1, 0.9) / heard, WithinRel(std::sqrt(8.0), 0.005));
}
