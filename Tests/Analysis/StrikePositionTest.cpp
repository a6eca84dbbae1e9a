// Tests from mesh to sound: the strike position decides which modes sound.
#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"
#include "Mesh/SurfaceQuery.h"
#include "Synth/Synthesiser.h"
#include "TestMaterials.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 44100;

struct Struck {
    Mesh mesh;
    std::shared_ptr<const ModalObject> object;
    SurfaceQuery surface;

    Struck(const Mesh& flat, const AnalysisSettings& settings)
        : mesh(flat), object(std::make_shared<const ModalObject>(analyse(flat, settings).value())),
          surface(flat) {}

    StrikePoint at(double x, double y) const {
        const SurfacePoint point = surface.nearestPoint({x, y, 0});
        StrikePoint strike;
        for (int k = 0; k < 3; ++k) {
            strike.shapeRows[static_cast<std::size_t>(k)] = mesh.faces(point.face, k);
            strike.weights[static_cast<std::size_t>(k)] = static_cast<float>(point.barycentric[k]);
        }
        strike.normal = {0, 0, 1};
        return strike;
    }

    /// Returns φ_z of a mode, linear between vertices.
    double shape(std::size_t mode, double x, double y) const {
        const StrikePoint point = at(x, y);
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            sum += static_cast<double>(point.weights[k]) *
                   static_cast<double>(object->shapesAt(
                       static_cast<std::size_t>(point.shapeRows[k]))[3 * mode + 2]);
        return sum;
    }

    double frequencyHz(std::size_t mode) const {
        return std::sqrt(object->eigenvalues[mode]) / (2 * std::numbers::pi);
    }

    /// Returns the sound of a short strike at a point. It is radiated sound only, so that only the
    /// struck point changes.
    std::vector<float> sound(double x, double y) const {
        Synthesiser synthesiser({{object, 1}}, sampleRateHz);
        SynthesisSettings settings;
        settings.tau = 0;
        settings.compression = 0;
        settings.radiation = 1;
        synthesiser.setSettings(settings);
        std::vector<float> output;
        for (int c = 0; c < 400; ++c) {
            std::array<float, cellSamples> cell{};
            synthesiser.beginCell(cell);
            if (c == 0)
                synthesiser.strike(0,
                                   {.point = at(x, y),
                                    .impulseNewtonSeconds = {0, 0, -0.05f},
                                    .durationSeconds = 0.0002},
                                   0, cell);
            output.insert(output.end(), cell.begin(), cell.end());
        }
        return output;
    }
};

double levelDb(const std::vector<float>& sound, double hz) {
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < sound.size(); ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(sound.size());
        const double hann = 0.5 * (1 - std::cos(2 * std::numbers::pi * part));
        sum += hann * static_cast<double>(sound[k]) *
               std::polar(1.0, -2 * std::numbers::pi * hz * static_cast<double>(k) / sampleRateHz);
    }
    return 20 * std::log10(std::abs(sum) + 1e-30);
}

} // namespace

TEST_CASE("A mode struck at its node, between vertices, is 60 dB below its antinode") {
    const Struck bar(sheetMesh(0.36, 0.04, 500), {.name = "bar",
                                                  .source = "test",
                                                  .material = referenceWood(),
                                                  .method = AnalysisMethod::twoLayer,
                                                  .thicknessMetres = 0.02,
                                                  .maxFrequencyHz = 6000});
    // The node of the first bending mode: 22.4 % from the end, off the vertices.
    double inside = 0, outside = 0.18;
    for (int step = 0; step < 60; ++step) {
        const double middle = (inside + outside) / 2;
        (bar.shape(0, middle, 0.003) * bar.shape(0, 0, 0.003) > 0 ? inside : outside) = middle;
    }
    CHECK(std::abs(0.5 - inside / 0.36 - 0.224) < 0.01);
    const double hz = bar.frequencyHz(0);
    const auto node = bar.sound(inside, 0.003);
    const auto antinode = bar.sound(0, 0.003);
    CHECK(levelDb(node, hz) < levelDb(antinode, hz) - 60);
}

TEST_CASE(
    "A table struck at an edge or corner sounds more modes than in the middle (CG&A, Fig. 5)") {
    const Struck table(sheetMesh(1.2, 0.8, 600), {.name = "table",
                                                  .source = "test",
                                                  .material = referenceWood(),
                                                  .thicknessMetres = 0.03,
                                                  .maxFrequencyHz = 2500});
    const auto middle = table.sound(0, 0);
    const auto [x, y] = GENERATE(std::pair(0.25, 0.4), std::pair(0.6, 0.17), std::pair(0.6, 0.4));
    const auto edge = table.sound(x, y);
    int loudInMiddle = 0, loudAtEdge = 0, silentInMiddle = 0;
    const auto loudest = [&](const std::vector<float>& sound) {
        double most = -1000;
        for (std::size_t i = 0; i < table.object->modeCount(); ++i)
            most = std::max(most, levelDb(sound, table.frequencyHz(i)));
        return most;
    };
    const double middleMost = loudest(middle), edgeMost = loudest(edge);
    for (std::size_t i = 0; i < 20; ++i) {
        const double atMiddle = levelDb(middle, table.frequencyHz(i)) - middleMost;
        const double atEdge = levelDb(edge, table.frequencyHz(i)) - edgeMost;
        loudInMiddle += atMiddle > -40 ? 1 : 0;
        loudAtEdge += atEdge > -40 ? 1 : 0;
        silentInMiddle += atMiddle < atEdge - 20 ? 1 : 0;
    }
    CAPTURE(x, y, loudInMiddle, loudAtEdge, silentInMiddle);
    CHECK(2 * loudAtEdge >= 3 * loudInMiddle);
    CHECK(silentInMiddle >= 5);
}
