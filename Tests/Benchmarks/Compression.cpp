#include "Benchmarks/Benchmarks.h"
#include "Synth/ModeCompression.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr std::size_t placesStruck = 12;

/// Returns the level in dB of half a second after an impulse, without truncation and budget.
double levelDb(const std::shared_ptr<const ModalObject>& object,
               const Strike& strike,
               double compression) {
    BenchScene scene({{object}}, {{0, 0, strike}},
                     {.tau = 0, .modeBudget = 1e9, .compression = compression, .material = {}});
    double energy = 0;
    for (const float sample : scene.render(cellsIn(0.5)))
        energy += static_cast<double>(sample) * static_cast<double>(sample);
    return 10 * std::log10(energy);
}

struct LevelError {
    double meanDb = 0;
    double largestDb = 0;
};

/// Measures at points over the surface, in the order of its vertices.
LevelError levelError(const std::shared_ptr<const ModalObject>& object) {
    LevelError found;
    for (std::size_t k = 0; k < placesStruck; ++k) {
        const std::size_t row = (2 * k + 1) * object->shapeVertexCount() / (2 * placesStruck);
        const Strike strike = strikeInto(strikePointOfRow(*object, row), 0.01, 0);
        const double grouped = levelDb(object, strike, 1), single = levelDb(object, strike, 0);
        // Both are −∞ if every mode is beyond the band, as for a pebble.
        const double error = grouped == single ? 0 : std::abs(grouped - single);
        found.meanDb += error / placesStruck;
        found.largestDb = std::max(found.largestDb, error);
    }
    return found;
}

} // namespace

Result<BenchSection> benchCompression(const BenchContent& content) {
    BenchSection section{.name = "compression",
                         .title = "modes before and after, and how far the level of half a second "
                                  "moves, over 12 places struck"};
    double modes = 0;
    double groups = 0;
    double largest = 0;
    for (const auto& object : content.factoryObjects) {
        std::vector<std::int32_t> starts(object->modeCount() + 1);
        const std::size_t after = groupModes(
            object->eigenvalues, PoleLaw{.damping = object->material.damping}, 1, starts);
        const LevelError error = levelError(object);
        modes += static_cast<double>(object->modeCount());
        groups += static_cast<double>(after);
        largest = std::max(largest, error.largestDb);
        section.row(object->name, std::to_string(object->modeCount()) + " modes to " +
                                      std::to_string(after) + ", level off by " +
                                      figure(error.meanDb, 2) + " dB on average, " +
                                      figure(error.largestDb, 2) + " dB at most");
        section.figures["objects"].push_back({{"name", object->name},
                                              {"modes", object->modeCount()},
                                              {"groups", after},
                                              {"mean_error_db", error.meanDb},
                                              {"largest_error_db", error.largestDb}});
    }
    section.row("all", figure(modes, 4) + " modes to " + figure(groups, 4) +
                           ", level off by at most " + figure(largest, 2) + " dB");
    for (double hz = 20; hz < 22100; hz *= 1.05)
        section.figures["discrimination_curve"].push_back({hz, discriminationHz(hz)});
    return section;
}

} // namespace idiophone
