#include "Analysis/ModalAnalysis.h"
#include "Benchmarks/Benchmarks.h"
#include "Geometry/ParametricMesh.h"
#include "Synth/ModeCompression.h"

#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

struct Plate {
    double lengthMetres;
    double widthMetres;
    int vertices;
};

/// Counts groups by the discrimination curve alone, as the paper does, without beats.
std::size_t windowsOver(const std::vector<double>& frequenciesHz) {
    std::size_t windows = 0;
    double end = 0;
    for (const double hz : frequenciesHz)
        if (windows == 0 || hz > end) {
            ++windows;
            end = hz + discriminationHz(hz);
        }
    return windows;
}

/// Returns the count for a spectrum that is dense from 20 to 22000 Hz: the maximum possible.
std::size_t windowsOfDenseSpectrum() {
    std::size_t windows = 0;
    for (double hz = 20; hz < 22000; hz += discriminationHz(hz))
        ++windows;
    return windows;
}

Result<void> measure(const Plate& plate, BenchSection& section) {
    Material steel = *findMaterial("Steel");
    steel.poissonRatio = 1.0 / 3; // the value that springs produce
    const auto object = analyse(sheetMesh(plate.lengthMetres, plate.widthMetres, plate.vertices),
                                {.name = "plate",
                                 .source = "generated steel plate, 3 mm",
                                 .material = steel,
                                 .method = AnalysisMethod::twoLayer,
                                 .thicknessMetres = 0.003,
                                 .maxFrequencyHz = 22000});
    if (!object)
        return tl::unexpected(object.error());

    std::vector<std::int32_t> starts(object->modeCount() + 1);
    const std::size_t groups =
        groupModes(object->eigenvalues, PoleLaw{.damping = object->material.damping}, 1, starts);
    std::vector<double> frequencies;
    for (const double eigenvalue : object->eigenvalues)
        frequencies.push_back(std::sqrt(eigenvalue) / (2 * std::numbers::pi));
    const std::size_t windows = windowsOver(frequencies);
    const auto rows = 3.0 * static_cast<double>(object->vertexCount());
    const auto millions = [rows](double columns) { return rows * columns / 1e6; };
    const double before = millions(rows);
    const double after = millions(static_cast<double>(groups));
    const double worst = millions(static_cast<double>(windowsOfDenseSpectrum()));

    const std::string name = std::to_string(object->vertexCount()) + " vertices";
    section.row(name + ", before", figure(before) + " million entries: 3V x 3V");
    section.row(name + ", audible", figure(millions(static_cast<double>(object->modeCount()))) +
                                        " million: 3V x " + std::to_string(object->modeCount()) +
                                        " modes up to 22 kHz");
    section.row(name + ", after", figure(after) + " million: 3V x " + std::to_string(groups) +
                                      " groups (" + std::to_string(windows) +
                                      " where beats may be lost, as in the paper)");
    section.row(name + ", dense spectrum", figure(worst) + " million at most by the curve");
    section.figures["meshes"].push_back({{"vertices", object->vertexCount()},
                                         {"modes", object->modeCount()},
                                         {"groups", groups},
                                         {"windows", windows},
                                         {"before_million", before},
                                         {"after_million", after},
                                         {"dense_million", worst},
                                         {"analysis_s", object->provenance.analysisSeconds}});
    // The paper reduces 225 million entries to 15 million at 5000 vertices.
    if (plate.vertices == 5000) {
        section.goals.push_back({"memory: gain matrix after over before at 5000 vertices",
                                 after / before, BenchGoal::Kind::atMost, 15.0 / 225});
        section.goals.push_back({"memory: the same for a dense spectrum", worst / before,
                                 BenchGoal::Kind::atMost, 15.0 / 225});
    }
    return {};
}

} // namespace

Result<BenchSection> benchMemory(const BenchContent&) {
    BenchSection section{.name = "memory",
                         .title = "entries of the gain matrix of steel plates, 3 mm thick"};
    for (const Plate& plate : {Plate{0.218, 0.145, 1000}, Plate{0.486, 0.324, 5000}})
        if (auto done = measure(plate, section); !done)
            return tl::unexpected(done.error());
    return section;
}

} // namespace idiophone
