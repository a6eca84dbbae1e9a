#include "Synth/Imperfection.h"
#include "ModalReference.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRate = 48000;

/// A ring's pair of modes, whose second shape has a node where the first is struck, and a single
/// mode.
ModalObject ring() {
    ModalObject object = ringingObject({440, 440, 1200}, 2);
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row)
        for (std::size_t axis = 0; axis < 3; ++axis)
            object.shapes[(row * 3 + 1) * 3 + axis] = 0;
    return object;
}

std::vector<float> struck(const ModalObject& object, double imperfection) {
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.imperfection = imperfection;
    synthesiser.setSettings(settings);
    return render(synthesiser, {{0, unitStrike()}}, 1500);
}

} // namespace

TEST_CASE("Pairs are neighbours of equal frequency, except the modes that bar and tube share") {
    const auto object = syntheticObject({100, 200, 200.05, 300, 300.1, 300.15, 400, 401});
    const auto pairs = modePairs(object, 3);
    REQUIRE(pairs.size() == 2);
    CHECK(pairs[0].first == 1);
    CHECK(pairs[1].first == 3);
    auto shared = object;
    shared.gains.assign(8, 1.0f);
    shared.gains[1] = {0.5f, 0.2f};
    CHECK(modePairs(shared, 3).size() == 1);
}

TEST_CASE("For every seed a pair splits by 0.5 to 1 times the imperfection") {
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        const auto object = syntheticObject({200, 200});
        const auto pairs = modePairs(object, seed);
        std::vector<double> eigenvalues = object.eigenvalues;
        splitPairs(pairs, 0.01, eigenvalues);
        const double parted = std::sqrt(eigenvalues[1] / eigenvalues[0]) - 1;
        CHECK(parted > 0.00499);
        CHECK(parted < 0.01011);
        CHECK(std::sqrt(eigenvalues[0] * eigenvalues[1]) ==
              Approx(object.eigenvalues[0]).epsilon(1e-4));
    }
}

TEST_CASE("Pairs of neighbouring seeds are turned by widely spread angles") {
    double aligned = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const auto pair = modePairs(syntheticObject({200, 200}), seed).front();
        aligned += static_cast<double>(pair.cosine * pair.cosine - pair.sine * pair.sine) / 100;
    }
    CHECK(std::abs(aligned) < 0.25);
}

TEST_CASE("Turning a pair of equal frequency keeps its summed sound") {
    const auto pairs = modePairs(syntheticObject({200, 200}), 7);
    std::vector<double> gains{0.3, -0.8}, weights{1.1, 0.4};
    const double before = gains[0] * weights[0] + gains[1] * weights[1];
    rotatePairs(pairs, std::span(gains));
    rotatePairs(pairs, std::span(weights));
    CHECK(gains[0] * weights[0] + gains[1] * weights[1] == Approx(before));
}

TEST_CASE("An imperfect ring beats and a perfect one does not") {
    const auto unevenness = [](const std::vector<float>& sound) {
        // The range of the level in windows of 10 ms, relative to a straight line in dB.
        double most = 0, least = 1e9;
        for (std::size_t window = 1; window < 150; ++window) {
            double energy = 0;
            for (std::size_t n = 0; n < 480; ++n)
                energy += std::pow(double(sound[window * 480 + n]), 2);
            const double level = std::sqrt(energy) * std::exp(0.01 * double(window));
            most = std::max(most, level);
            least = std::min(least, level);
        }
        return most / least;
    };
    ModalObject alone = ring();
    alone = ringingObject({440, 440, 640, 640, 900, 900, 1200, 1200}, 2, {1, 0, 1, 0, 1, 0, 1, 0});
    CHECK(unevenness(struck(alone, 0)) < 1.1);
    CHECK(unevenness(struck(alone, 0.005)) > 1.2);
}

TEST_CASE("A change of the imperfection causes no step") {
    Synthesiser synthesiser({slotOf(ring())}, sampleRate);
    SynthesisSettings settings = exactSettings();
    const auto sound = render(synthesiser, {{0, unitStrike()}}, 60, [&](int cell) {
        settings.imperfection = cell < 30 ? 0 : 0.01;
        synthesiser.setSettings(settings);
    });
    double steepest = 0;
    for (std::size_t n = 64; n < sound.size(); ++n)
        if (n != 30 * 64)
            steepest = larger(steepest, std::abs(double(sound[n]) - double(sound[n - 1])));
    CHECK(std::abs(double(sound[30 * 64]) - double(sound[30 * 64 - 1])) <= 1.01 * steepest);
}
