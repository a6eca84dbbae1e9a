#include "Analysis/Radiation.h"

#include "Analysis/Air.h"
#include "Analysis/BoundaryElements.h"
#include "Analysis/ClosedSurface.h"
#include "Analysis/RadiationTasks.h"
#include "Object/WorkTeam.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

namespace idiophone {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Limits on the resolution of the surface pressure. Time grows with the square, later with the
/// cube of the unknowns.
struct Effort {
    int unknowns = 0;          ///< with G symmetries, each system gets 1/G, at least 1/4
    double maximumKernels = 0; ///< per frequency; finer surfaces are remeshed
    double sameFrequency = 0;  ///< modes that differ by less than this share are solved together
    /// Minimum edges per wavelength. The edge is that of a triangle with one unknown's area.
    double edgesPerWavelength = 0;
};
/// With 2.5 edges per wavelength a sphere is within 0.2 dB. With fewer than 1.8, bars and bowls
/// have larger errors.
constexpr Effort exactEffort{1800, 1.5e8, 0.002, 2.5}, quickEffort{700, 1.5e7, 0.03, 1.8},
    previewEffort{350, 5e6, 0.12, 1.8};

/// A surface is refined only if it resolves less than this share of the band.
constexpr double enoughOfBand = 0.6;
constexpr double maximumMatrixBytes = 1e9;

double waveNumberOf(double frequencyHz) {
    return 2 * std::numbers::pi * frequencyHz / speedOfSoundMetresPerSecond;
}

/// Returns the edge of `unknowns` equilateral triangles that cover the surface.
double edgeMetresOf(const Mesh& surface, double count) {
    return std::sqrt(4 / std::sqrt(3.0) * faceAreas(surface).sum() / count);
}

double servedHz(const Mesh& surface, double unknowns, const Effort& effort) {
    return speedOfSoundMetresPerSecond /
           (effort.edgesPerWavelength * edgeMetresOf(surface, unknowns));
}

/// Returns the maximum number of unknowns of one system.
Index unknownsOf(const Effort& effort, Index symmetryOrder) {
    return std::max<Index>(effort.unknowns / symmetryOrder, effort.unknowns / 4);
}

/// Returns the number of kernel evaluations for the matrices of one frequency.
double kernelsOf(const Effort& effort, double faces, Index symmetryOrder) {
    return faces *
           std::min(faces / static_cast<double>(symmetryOrder),
                    static_cast<double>(maximumCollocations * unknownsOf(effort, symmetryOrder)));
}

/// Returns a surface as fine as the band needs, within the limits of the effort.
Result<ClosedSurface> surfaceFor(const RadiatingBody& body,
                                 const Effort& effort,
                                 double bandHz,
                                 const WorkControl& control) {
    auto surface = closedSurface(body.mesh, body.thicknessMetres);
    if (!surface)
        return surface;
    const auto faces = [&] { return static_cast<double>(surface->mesh.faceCount()); };
    const Index order = surfaceSymmetry(surface->mesh).order();
    if (kernelsOf(effort, faces(), order) > effort.maximumKernels) {
        const double affordable =
            effort.maximumKernels / static_cast<double>(maximumCollocations * effort.unknowns);
        return remeshed(*surface, edgeMetresOf(surface->mesh, 0.7 * affordable), control);
    }
    while (faces() / static_cast<double>(order) < static_cast<double>(unknownsOf(effort, order)) &&
           kernelsOf(effort, 4 * faces(), order) <= effort.maximumKernels &&
           servedHz(surface->mesh, faces(), effort) < enoughOfBand * bandHz)
        surface = withFacesSplit(*surface);
    return surface;
}

/// The common input of all tasks.
struct Hearing {
    const BoundaryElements& elements;
    Eigen::MatrixXd normalShapes;     ///< [F×M]
    Eigen::MatrixXd directions;       ///< [D×3] unit
    Eigen::MatrixXd nearPointsMetres; ///< [P×3]
    Eigen::Vector3d centreMetres;
    double solvedHz = 0;
};

/// Returns whether a solution is valid. The equations have none if faces touch or cross, as in
/// meshes folded flat.
bool isSound(const Eigen::MatrixXcd& pressures, const Eigen::MatrixXd& velocities) {
    constexpr double most = 1e4; // of ρc v, far above the pressure in any cavity
    return pressures.allFinite() &&
           pressures.norm() <= most * airImpedancePaSPerM * velocities.norm();
}

/// Solves one task. If cancelled, the task has no weights.
void solve(RadiationTask& task, const Hearing& hearing, const WorkControl& control) {
    const double waveNumber = waveNumberOf(task.frequencyHz);
    const Eigen::MatrixXd velocities = hearing.normalShapes(Eigen::all, task.modes);
    const BoundaryElements& elements = hearing.elements;
    Eigen::MatrixXcd pressures = airImpedancePaSPerM * velocities.cast<Complex>();
    bool isSolved = false;
    if (task.frequencyHz <= hearing.solvedHz) {
        auto solved = elements.surfacePressures(waveNumber, velocities, control.quiet());
        if (!solved)
            return;
        isSolved = isSound(*solved, velocities);
        if (isSolved)
            pressures = std::move(*solved);
    }
    task.weights = isSolved ? elements.farField(waveNumber, hearing.directions,
                                                hearing.centreMetres, velocities, pressures)
                            : elements.shortWaveField(waveNumber, hearing.directions,
                                                      hearing.centreMetres, velocities);
    task.nearPressures =
        elements.pressuresAt(waveNumber, hearing.nearPointsMetres, velocities, pressures);
}

/// Solves on several threads; only the calling thread reports progress.
Result<void> solveAll(std::vector<RadiationTask>& tasks,
                      const Hearing& hearing,
                      WorkTeam& team,
                      const WorkControl& control) {
    // Only tasks whose surface pressure is solved take time.
    const auto isLong = [&](const RadiationTask& task) {
        return task.frequencyHz <= hearing.solvedHz;
    };
    const auto expected = std::max<std::ptrdiff_t>(1, std::ranges::count_if(tasks, isLong));
    std::atomic<std::ptrdiff_t> done = 0;
    const WorkControl quiet = control.quiet();
    team.runAll(tasks.size(), [&](std::size_t task, std::size_t worker) {
        if (control.isCancelled())
            return;
        const WorkControl& own = worker == 0 ? control : quiet;
        solve(tasks[task], hearing, own);
        done += isLong(tasks[task]) ? 1 : 0;
        own.report(static_cast<double>(done) / static_cast<double>(expected),
                   "Finding how it sounds in the air");
    });
    if (control.isCancelled())
        return cancellation();
    return {};
}

/// [points×3].
Eigen::MatrixXd rowsOf(const std::vector<Eigen::Vector3d>& points) {
    Eigen::MatrixXd rows(points.size(), 3);
    for (std::size_t row = 0; row < points.size(); ++row)
        rows.row(row) = points[row].transpose();
    return rows;
}

/// Returns the number of threads whose matrices fit into memory.
unsigned affordableThreads(const BoundaryElements& elements) {
    const auto unknowns = static_cast<double>(elements.unknownCount());
    const double bytes = 8 * unknowns * unknowns * static_cast<double>(elements.symmetryOrder());
    return static_cast<unsigned>(std::clamp(maximumMatrixBytes / bytes, 1.0, 1024.0));
}

} // namespace

std::vector<Eigen::Vector3d> stereoDirections() {
    constexpr double x = 0.33;
    std::vector<Eigen::Vector3d> directions;
    for (const double y : {0.32, 0.42})
        directions.emplace_back(x, y, std::sqrt(1 - x * x - y * y));
    return directions;
}

std::vector<Eigen::Vector3d> directionsAllAround() {
    auto directions = stereoDirections();
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0)
                    directions.push_back(Eigen::Vector3d(x, y, z).normalized());
    return directions;
}

std::vector<double> halfOctaveRatios() {
    std::vector<double> ratios;
    for (int step = -4; step <= 4; ++step)
        ratios.push_back(std::exp2(step / 2.0));
    return ratios;
}

Result<Radiation> radiationOf(const RadiatingBody& body,
                              const RadiationSettings& settings,
                              const WorkControl& control) {
    const bool isExact = settings.method == RadiationMethod::exact;
    const Effort& effort = isExact                                     ? exactEffort
                           : settings.method == RadiationMethod::quick ? quickEffort
                                                                       : previewEffort;
    const Eigen::VectorXd frequenciesHz = body.eigenvalues.cwiseSqrt() / (2 * std::numbers::pi);
    const auto surface =
        surfaceFor(body, effort, audibleHz(frequenciesHz.maxCoeff()), control.quiet());
    if (!surface)
        return failure(surface.error().message);
    auto symmetry = surfaceSymmetry(surface->mesh);
    const Index order = symmetry.order();
    const BoundaryElements elements(surface->mesh, std::move(symmetry), unknownsOf(effort, order));
    const Hearing hearing{
        .elements = elements,
        .normalShapes = surface->normalShapes(body.shapes),
        .directions = rowsOf(settings.directions).rowwise().normalized(),
        .nearPointsMetres = rowsOf(settings.nearPointsMetres),
        .centreMetres = body.centreMetres,
        .solvedHz =
            servedHz(surface->mesh, static_cast<double>(elements.unknownCount() * order), effort)};

    auto tasks = ownTasks(frequenciesHz, effort.sameFrequency);
    const std::size_t ownCount = tasks.size();
    std::ranges::move(gridTasks(frequenciesHz, settings.frequencyRatios),
                      std::back_inserter(tasks));
    WorkTeam team(settings.threads, affordableThreads(elements));
    if (const auto solved = solveAll(tasks, hearing, team, control); !solved)
        return tl::unexpected(solved.error());
    const auto own = std::span(tasks).first(ownCount);

    Radiation result{.table = tableOf(own, std::span(tasks).subspan(ownCount), frequenciesHz,
                                      settings.frequencyRatios),
                     .nearPressures =
                         Eigen::MatrixXcd(hearing.nearPointsMetres.rows(), frequenciesHz.size()),
                     .solvedHz = hearing.solvedHz,
                     .notes = {}};
    for (const auto& direction : hearing.directions.rowwise()) {
        const Eigen::RowVector3f unit = direction.cast<float>();
        result.table.directions.push_back({unit.x(), unit.y(), unit.z()});
    }
    for (const RadiationTask& task : own)
        result.nearPressures(Eigen::all, task.modes) = task.nearPressures;
    const Index above = (frequenciesHz.array() > result.solvedHz).count();
    if (isExact && above > 0)
        result.notes = "The radiation of " + std::to_string(above) + " modes above " +
                       std::to_string(std::lround(result.solvedHz)) +
                       " Hz is estimated, as that of large walls.";
    return result;
}

} // namespace idiophone
