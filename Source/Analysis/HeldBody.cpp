#include "Analysis/HeldBody.h"

#include <algorithm>
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

} // namespace

Result<std::vector<bool>> heldRows(const BodyModel& body) {
    if (body.support.clamps.empty())
        return {};
    const auto rows = static_cast<std::size_t>(body.model.stiffness.rows());
    const auto rowsPerVertex = static_cast<std::size_t>(body.model.rowsPerVertex);
    std::vector<bool> held(rows, false);
    for (Index point = 0; point < body.pointsMetres.rows(); ++point)
        if (isClamped(body.support.clamps, body.pointsMetres.row(point).transpose())) {
            const std::size_t first =
                3 * static_cast<std::size_t>(point) / rowsPerVertex * rowsPerVertex;
            std::fill_n(held.begin() + static_cast<std::ptrdiff_t>(first), rowsPerVertex, true);
        }
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
