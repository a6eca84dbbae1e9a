#include "Analysis/RadiationSolver.h"

#include "Analysis/Air.h"
#include "Analysis/BoundaryElements.h"
#include "Analysis/ClosedSurface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <thread>
#include <utility>

namespace idiophone {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double lowestHz = 20, highestHz = 22000;
/// Edges of the triangles, or of what shares an unknown, that a wave must span: a sphere is then
/// within 0.2 dB (BoundaryElementsTest).
constexpr double edgesPerWavelength = 2.5;
/// A surface is made finer only where it serves less of the band than this.
constexpr double enoughOfBand = 0.6;
constexpr double mostMatrixBytes = 1e9;

double waveNumberOf(double frequencyHz) {
    return 2 * std::numbers::pi * frequencyHz / speedOfSoundMetresPerSecond;
}

double audible(double frequencyHz) {
    return std::clamp(frequencyHz, lowestHz, highestHz);
}

/// The edge of equilateral triangles that are so many on the surface.
double edgeMetresOf(const Mesh& surface, double count) {
    return std::sqrt(4 / std::sqrt(3.0) * faceAreas(surface).sum() / count);
}

double servedHz(const Mesh& surface, double unknowns) {
    return speedOfSoundMetresPerSecond / (edgesPerWavelength * edgeMetresOf(surface, unknowns));
}

/// As fine as the band asks for and the effort allows.
Result<ClosedSurface> surfaceFor(const RadiatingBody& body,
                                 const RadiationEffort& effort,
                                 double bandHz,
                                 const WorkControl& control) {
    auto surface = closedSurface(body.mesh, body.thicknessMetres);
    if (!surface)
        return surface;
    const auto faces = [&] { return static_cast<double>(surface->mesh.faceCount()); };
    if (faces() > effort.maximumFaces)
        return remeshed(*surface, edgeMetresOf(surface->mesh, effort.maximumFaces / 2.0), control);
    while (4 * faces() <= effort.maximumFaces &&
           servedHz(surface->mesh, faces()) < enoughOfBand * bandHz)
        surface = withFacesSplit(*surface);
    return surface;
}

/// What is solved at once: some modes at one frequency.
struct Task {
    double frequencyHz = 0;
    std::vector<Index> modes;
    Eigen::MatrixXcd weights = {}; ///< [D×modes]
};

/// Modes at their own frequencies, in Hz and ascending.
std::vector<Task> ownTasks(const Eigen::VectorXd& frequenciesHz, double sameFrequency) {
    std::vector<Task> tasks;
    for (Index mode = 0, first = 0; mode < frequenciesHz.size(); ++mode) {
        if (tasks.empty() || frequenciesHz(mode) > frequenciesHz(first) * (1 + sameFrequency)) {
            tasks.emplace_back();
            first = mode;
        }
        tasks.back().modes.push_back(mode);
        tasks.back().frequencyHz = audible(std::sqrt(frequenciesHz(first) * frequenciesHz(mode)));
    }
    return tasks;
}

/// All modes at half octaves, as far as any ratio asks for.
std::vector<Task> gridTasks(const Eigen::VectorXd& frequenciesHz,
                            const std::vector<double>& ratios) {
    const double first = audible(frequenciesHz.minCoeff() * ratios.front()),
                 last = audible(frequenciesHz.maxCoeff() * ratios.back());
    std::vector<Index> all;
    for (Index mode = 0; mode < frequenciesHz.size(); ++mode)
        all.push_back(mode);
    std::vector<Task> tasks;
    for (int step = 0;; ++step) {
        const double frequencyHz = audible(lowestHz * std::exp2(step / 2.0));
        if (frequencyHz * std::numbers::sqrt2 > first)
            tasks.push_back({frequencyHz, all});
        if (frequencyHz >= last)
            return tasks;
    }
}

/// Solves tasks on several threads, of which the caller's reports.
class TaskRun {
public:
    TaskRun(const BoundaryElements& elements,
            const Eigen::MatrixXd& normalShapes,
            const Eigen::MatrixXd& directions,
            const Eigen::Vector3d& centreMetres,
            double solvedHz,
            const WorkControl& control)
        : elements_(elements), normalShapes_(normalShapes), directions_(directions),
          centreMetres_(centreMetres), solvedHz_(solvedHz), control_(control) {}

    Result<void> solve(std::vector<Task>& tasks, unsigned threads) {
        std::vector<std::thread> others;
        for (unsigned thread = 1; thread < threads && thread < tasks.size(); ++thread)
            others.emplace_back([&] { work(tasks, control_.quiet()); });
        work(tasks, control_);
        for (auto& other : others)
            other.join();
        if (control_.isCancelled())
            return cancellation();
        return {};
    }

private:
    void work(std::vector<Task>& tasks, const WorkControl& control) {
        for (std::size_t task = next_++; task < tasks.size(); task = next_++) {
            if (control.isCancelled())
                return;
            solve(tasks[task], control);
            control.report(static_cast<double>(++done_) / static_cast<double>(tasks.size()),
                           "Computing radiation");
        }
    }

    void solve(Task& task, const WorkControl& control) const {
        const double waveNumber = waveNumberOf(task.frequencyHz);
        const Eigen::MatrixXd velocities = normalShapes_(Eigen::all, task.modes);
        if (task.frequencyHz > solvedHz_) {
            task.weights =
                elements_.shortWaveField(waveNumber, directions_, centreMetres_, velocities);
            return;
        }
        const auto pressures = elements_.surfacePressures(waveNumber, velocities, control.quiet());
        if (pressures)
            task.weights =
                elements_.farField(waveNumber, directions_, centreMetres_, velocities, *pressures);
    }

    const BoundaryElements& elements_;
    const Eigen::MatrixXd& normalShapes_;
    const Eigen::MatrixXd& directions_;
    const Eigen::Vector3d centreMetres_;
    const double solvedHz_;
    const WorkControl& control_;
    std::atomic<std::size_t> next_{0}, done_{0};
};

/// Between two weights, 0 ≤ share ≤ 1.
Complex between(Complex a, Complex b, double share) {
    const double magnitude = std::abs(a), other = std::abs(b);
    if (magnitude == 0 || other == 0)
        return (1 - share) * a + share * b;
    return a * std::polar(std::pow(other / magnitude, share), share * std::arg(b / a));
}

/// All modes' weights [D×M] on the grid, looked up for one mode.
Eigen::VectorXcd interpolated(const std::vector<Task>& grid, double frequencyHz, Index mode) {
    const auto above = std::ranges::lower_bound(grid, frequencyHz, {}, &Task::frequencyHz);
    if (above == grid.begin())
        return grid.front().weights.col(mode);
    if (above == grid.end())
        return grid.back().weights.col(mode);
    const auto below = above - 1;
    const double share = std::log(frequencyHz / below->frequencyHz) /
                         std::log(above->frequencyHz / below->frequencyHz);
    return below->weights.col(mode).binaryExpr(
        above->weights.col(mode), [&](Complex a, Complex b) { return between(a, b, share); });
}

std::string faultOf(const RadiatingBody& body, const RadiationSettings& settings) {
    if (body.shapes.rows() != 3 * body.mesh.vertexCount() ||
        body.shapes.cols() != body.eigenvalues.size() || body.shapes.cols() == 0)
        return "The mode shapes to be heard do not belong to the mesh.";
    if (settings.directions.empty() || settings.frequencyRatios.empty())
        return "Radiation needs a direction and a frequency ratio.";
    if (!(faceAreas(body.mesh).sum() > 0))
        return "The surface has no area to radiate from.";
    return {};
}

unsigned threadsFor(const BoundaryElements& elements, unsigned threads) {
    const auto unknowns = static_cast<double>(elements.unknownCount());
    const double bytes = 8 * unknowns * unknowns * static_cast<double>(elements.symmetryOrder());
    const auto most = static_cast<unsigned>(std::clamp(mostMatrixBytes / bytes, 1.0, 1024.0));
    return std::clamp(threads == 0 ? std::thread::hardware_concurrency() : threads, 1U, most);
}

} // namespace

Result<SolvedRadiation> solveRadiation(const RadiatingBody& body,
                                       const RadiationSettings& settings,
                                       const RadiationEffort& effort,
                                       const WorkControl& control,
                                       unsigned threads) {
    if (const auto fault = faultOf(body, settings); !fault.empty())
        return failure(fault);
    const Eigen::VectorXd frequenciesHz = body.eigenvalues.cwiseSqrt() / (2 * std::numbers::pi);
    const auto surface =
        surfaceFor(body, effort, audible(frequenciesHz.maxCoeff()), control.quiet());
    if (!surface)
        return failure(surface.error().message);
    auto symmetry = surfaceSymmetry(surface->mesh);
    const Index order = symmetry.order();
    const BoundaryElements elements(surface->mesh, std::move(symmetry),
                                    std::max<Index>(effort.unknowns / order, effort.unknowns / 4));

    SolvedRadiation result{.directions = {},
                           .frequencyRatios = settings.frequencyRatios,
                           .weights = {},
                           .solvedHz = 0,
                           .notes = {}};
    result.solvedHz = servedHz(surface->mesh, static_cast<double>(elements.unknownCount() * order));
    Eigen::MatrixXd directions(static_cast<Index>(settings.directions.size()), 3);
    for (const auto& direction : settings.directions) {
        const Eigen::Vector3d unit = direction.normalized();
        directions.row(static_cast<Index>(result.directions.size())) = unit.transpose();
        const Eigen::Vector3f single = unit.cast<float>();
        result.directions.push_back({single.x(), single.y(), single.z()});
    }

    const Eigen::MatrixXd normalShapes = surface->normalShapes(body.shapes);
    auto tasks = ownTasks(frequenciesHz, effort.sameFrequency);
    const auto ownCount = static_cast<std::ptrdiff_t>(tasks.size());
    std::ranges::move(gridTasks(frequenciesHz, settings.frequencyRatios),
                      std::back_inserter(tasks));
    TaskRun run(elements, normalShapes, directions, body.centreMetres, result.solvedHz, control);
    if (const auto solved = run.solve(tasks, threadsFor(elements, threads)); !solved)
        return tl::unexpected(solved.error());
    const std::vector<Task> grid(std::make_move_iterator(tasks.begin() + ownCount),
                                 std::make_move_iterator(tasks.end()));
    tasks.resize(static_cast<std::size_t>(ownCount));

    const Index modes = frequenciesHz.size();
    const auto ratios = static_cast<Index>(settings.frequencyRatios.size());
    result.weights.resize(static_cast<std::size_t>(directions.rows() * ratios * modes));
    const auto store = [&](Index ratio, Index mode, const Eigen::VectorXcd& weights) {
        for (Index direction = 0; direction < directions.rows(); ++direction)
            result.weights[static_cast<std::size_t>((direction * ratios + ratio) * modes + mode)] =
                std::complex<float>(weights(direction));
    };
    for (Index ratio = 0; ratio < ratios; ++ratio) {
        const double value = settings.frequencyRatios[static_cast<std::size_t>(ratio)];
        if (std::abs(value - 1) < 1e-9) {
            for (const Task& task : tasks)
                for (std::size_t k = 0; k < task.modes.size(); ++k)
                    store(ratio, task.modes[k], task.weights.col(static_cast<Index>(k)));
            continue;
        }
        for (Index mode = 0; mode < modes; ++mode)
            store(ratio, mode, interpolated(grid, audible(value * frequenciesHz(mode)), mode));
    }
    const Index above = (frequenciesHz.array() > result.solvedHz).count();
    if (above > 0)
        result.notes = "The radiation of " + std::to_string(above) + " modes above " +
                       std::to_string(std::lround(result.solvedHz)) + " Hz is that of large walls.";
    return result;
}

} // namespace idiophone
