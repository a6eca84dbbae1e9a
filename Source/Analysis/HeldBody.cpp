#include "Analysis/HeldBody.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

using Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

/// Maps each row to its number among the free ones, −1 if it is held.
std::vector<Index> numbersOfFreeRows(const std::vector<bool>& held) {
    std::vector<Index> numbers;
    Index next = 0;
    for (const bool isHeld : held)
        numbers.push_back(isHeld ? -1 : next++);
    return numbers;
}

Sparse freePart(const Sparse& whole, const std::vector<Index>& numbers, Index free) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(whole.nonZeros()));
    for (Index column = 0; column < whole.outerSize(); ++column)
        for (Sparse::InnerIterator entry(whole, column); entry; ++entry) {
            const Index row = numbers[static_cast<std::size_t>(entry.row())];
            const Index to = numbers[static_cast<std::size_t>(column)];
            if (row >= 0 && to >= 0)
                entries.emplace_back(row, to, entry.value());
        }
    Sparse part(free, free);
    part.setFromTriplets(entries.begin(), entries.end());
    return part;
}

/// Returns the points of the model on the held part of the analysed mesh. A surface that was
/// decimated or remeshed may lie off that mesh, and so may the middles of its curved edges. Points
/// inside the body are farther away.
std::vector<Index> pointsOnHeldSurface(const BodyModel& body) {
    constexpr double vertexReach = 0.05; // of the body's diagonal
    constexpr double middleReach = 0.08; // of an edge
    const double reachMetres = vertexReach * boundingDiagonalMetres(body.surface);
    const double middleReachMetres = middleReach * meanEdgeLengthMetres(body.surface);
    const Index vertices = body.surface.vertexCount(),
                pointsPerVertex = body.model.rowsPerVertex / 3;
    std::vector<Index> points;
    for (Index vertex = 0; vertex < vertices; ++vertex)
        if (body.heldSurface->holds(body.surface.vertices.row(vertex).transpose(), reachMetres))
            points.push_back(pointsPerVertex * vertex);
    for (Index point = pointsPerVertex * vertices; point < body.pointsMetres.rows(); ++point)
        if (body.heldSurface->holds(body.pointsMetres.row(point).transpose(), middleReachMetres))
            points.push_back(point);
    return points;
}

} // namespace

Result<void> holdBody(BodyModel& body, const Mesh& mesh, const Support& support) {
    auto surface = HeldSurface::of(mesh, support);
    if (!surface)
        return tl::unexpected(surface.error());
    body.support = support;
    body.heldSurface = std::move(*surface);
    return {};
}

Result<std::vector<bool>> heldRows(const BodyModel& body) {
    const auto& support = body.support;
    if (!support.holds())
        return {};
    const auto rows = static_cast<std::size_t>(body.model.stiffness.rows());
    const auto rowsPerVertex = static_cast<std::size_t>(body.model.rowsPerVertex);
    std::vector<bool> held(rows, false);
    const auto hold = [&](Index point) {
        const std::size_t first =
            3 * static_cast<std::size_t>(point) / rowsPerVertex * rowsPerVertex;
        std::fill_n(held.begin() + static_cast<std::ptrdiff_t>(first), rowsPerVertex, true);
    };
    for (Index point = 0; point < body.pointsMetres.rows(); ++point) {
        const Eigen::Vector3d place = body.pointsMetres.row(point).transpose();
        if (isClamped(support.clamps, place) ||
            std::ranges::any_of(support.balls,
                                [&](const ClampBall& ball) { return ball.contains(place); }))
            hold(point);
    }
    const Index pointsPerVertex = body.model.rowsPerVertex / 3;
    for (const auto& ball : support.balls)
        hold(pointsPerVertex * nearestVertex(body.surface, ball.centreMetres.transpose()));
    if (body.heldSurface != nullptr)
        for (const auto point : pointsOnHeldSurface(body))
            hold(point);
    const auto count = static_cast<std::size_t>(std::ranges::count(held, true));
    if (count == 0)
        return failure("The clamps hold no point of the object; check their places, in metres.");
    if (count == rows)
        return failure("The clamps hold the whole object.");
    return held;
}

Result<Modes> solveHeldModes(const VibrationModel& model,
                             const std::vector<bool>& held,
                             const FrequencyBand& band,
                             const WorkControl& control) {
    if (held.empty())
        return solveModes(model, band, control);
    const auto numbers = numbersOfFreeRows(held);
    const auto free = static_cast<Index>(std::ranges::count(held, false));
    const VibrationModel moving{.stiffness = freePart(model.stiffness, numbers, free),
                                .mass = freePart(model.mass, numbers, free),
                                .rowsPerVertex = model.rowsPerVertex};
    auto modes = solveModes(moving, band, control);
    if (!modes)
        return modes;
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(model.stiffness.rows(), modes->shapes.cols());
    for (Index row = 0; row < whole.rows(); ++row)
        if (const Index number = numbers[static_cast<std::size_t>(row)]; number >= 0)
            whole.row(row) = modes->shapes.row(number);
    modes->shapes = std::move(whole);
    return modes;
}

Eigen::Matrix3Xd
supportForces(const VibrationModel& model, const std::vector<bool>& held, const Modes& modes) {
    const auto stiffness = model.stiffness.selfadjointView<Eigen::Lower>();
    const auto mass = model.mass.selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd ofRows =
        stiffness * modes.shapes - mass * modes.shapes * modes.eigenvalues.asDiagonal();
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, modes.shapes.cols());
    for (Index row = 0; row < ofRows.rows(); ++row)
        if (held[static_cast<std::size_t>(row)])
            forces.row(row % 3) += ofRows.row(row);
    return forces;
}

double
resistanceOf(double quality, const Eigen::Matrix3Xd& forces, const Eigen::VectorXd& eigenvalues) {
    constexpr Index lowestModes = 4;
    double resistance = 0;
    for (Index mode = 0; mode < std::min(lowestModes, eigenvalues.size()); ++mode)
        resistance = std::max(resistance, quality * forces.col(mode).squaredNorm() /
                                              std::pow(eigenvalues(mode), 1.5));
    return resistance;
}

std::vector<double> supportDecays(const Eigen::Matrix3Xd& forces,
                                  const Eigen::VectorXd& eigenvalues,
                                  double resistanceNsPerM) {
    std::vector<double> decays;
    for (Index mode = 0; mode < forces.cols(); ++mode)
        decays.push_back(forces.col(mode).squaredNorm() /
                         (2 * resistanceNsPerM * eigenvalues(mode)));
    return decays;
}

} // namespace idiophone
