#include "Analysis/Eigensolver.h"

#include "Analysis/BlockLanczos.h"
#include "Analysis/MassSpace.h"
#include "Analysis/ShiftedFactor.h"
#include "Object/WorkTeam.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index denseUpTo = 400; ///< rows; dense solves are faster below
constexpr double workLimitBytes = 3e9;
constexpr unsigned usefulThreads = 8;  ///< more would wait for the memory and for the last fronts
constexpr double countingShare = 0.25; ///< share of the counting phase in the progress
/// A slice costs about three factorisations, and about 7 n products per mode for each mode in its
/// basis. Fewer than 60 modes would waste work on modes outside the slice. More than 220 would make
/// one dense step too long to cancel.
Index modesPerSlice(Index rows, double factorisationProducts) {
    return std::clamp(
        static_cast<Index>(std::sqrt(3 * factorisationProducts / (7 * static_cast<double>(rows)))),
        Index{60}, Index{220});
}

double lambdaOf(double frequencyHz) {
    const double omega = 2 * std::numbers::pi * frequencyHz;
    return omega * omega;
}

/// Thrown by iterations, caught in this file.
struct Fault {
    std::string message;
};

/// A range of λ with `count` eigenvalues; `below` more lie under `low`.
struct Slice {
    double low = 0, high = 0;
    Index below = 0, count = 0;
};

EigenBlock solveDense(const VibrationModel& model) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(MatrixXd(model.stiffness),
                                                                    MatrixXd(model.mass));
    if (solver.info() != Eigen::Success)
        throw Fault{"The modes of the mesh were not found in a reasonable time; simplify it."};
    return {solver.eigenvalues(), solver.eigenvectors()};
}

class BandSolver {
public:
    BandSolver(const VibrationModel& model, const FrequencyBand& band, const WorkControl& control)
        : model_(model), space_(model.mass), team_(band.threads, usefulThreads),
          factor_(model, control, &team_), band_(band), control_(control) {}

    EigenBlock solve();
    Index zeroModes() const { return zeroModes_; }
    Index factoriseAndCount(double lambda);

private:
    Vectors zeroSpace();
    void split(const Slice& slice, std::vector<Slice>& slices);
    EigenBlock solveSlice(const Slice& slice, const Vectors& deflated, const Vectors& before);
    void orthonormalise(Vectors& block) const {
        Vectors image;
        if (space_.orthonormalise(block, image).size() != block.cols() * block.cols())
            throw Fault{"The modes of the mesh cannot be told apart; simplify or remesh it."};
    }
    void checkCancelled() const {
        if (control_.isCancelled())
            throw Fault{std::string(cancelledMessage)};
    }
    void countOperation() {
        checkCancelled();
        control_.report(countingShare +
                            (0.99 - countingShare) *
                                (1 - std::exp(-2 * ++operations_ / expectedOperations_)),
                        "Finding its modes");
    }

    const VibrationModel& model_;
    MassSpace space_;
    WorkTeam team_;
    ShiftedFactor factor_;
    FrequencyBand band_;
    const WorkControl& control_;
    Index zeroModes_ = 0;
    double operations_ = 0, expectedOperations_ = 1, counts_ = 0;
};

Index BandSolver::factoriseAndCount(double lambda) {
    if (!factor_.factorise(lambda)) {
        checkCancelled();
        throw Fault{"The triangles of the mesh are too badly shaped to find its modes; remesh it."};
    }
    if (operations_ == 0)
        control_.report(countingShare * (1 - std::exp(-0.1 * ++counts_)), "Counting modes");
    return factor_.eigenvaluesBelow();
}

/// Returns an orthonormal basis of the zero modes, by subspace iteration with a shift just below
/// zero. Their shift-invert images exceed all others by orders of magnitude, so two or three steps
/// suffice. A Lanczos process would find hundreds of equal eigenvalues one copy at a time.
Vectors BandSolver::zeroSpace() {
    if (zeroModes_ == 0)
        return Vectors(space_.rows(), 0);
    if (static_cast<double>(space_.rows()) * static_cast<double>(zeroModes_) * 8 > workLimitBytes)
        throw Fault{"The mesh has " + std::to_string(zeroModes_) +
                    " zero modes in this model, too many to separate; use the two-layer method."};
    const double edge = lambdaOf(band_.lowestHz);
    factoriseAndCount(-edge);
    Vectors basis = fixedRandomBlock(space_.rows(), zeroModes_, 1);
    orthonormalise(basis);
    const VectorXd perRootMass = model_.mass.diagonal().cwiseSqrt().cwiseInverse();
    for (int step = 0; step < 60; ++step) {
        checkCancelled();
        basis = factor_.solve(space_.times(basis));
        orthonormalise(basis);
        const Vectors image = perRootMass.asDiagonal() * symmetricTimes(model_.stiffness, basis);
        if (image.colwise().norm().maxCoeff() <= 1e-6 * edge + 1e-15 * factor_.norm())
            break;
    }
    return basis;
}

/// Divides a slice until the parts have few enough modes. Cuts only where no eigenvalue lies within
/// a millionth, so that the counts on both sides are certain.
void BandSolver::split(const Slice& slice, std::vector<Slice>& slices) {
    if (slice.count == 0)
        return;
    const double low = std::sqrt(std::max(slice.low, 0.0)), high = std::sqrt(slice.high);
    if (slice.count > 3 * modesPerSlice(space_.rows(), factor_.products()) / 2 &&
        high - low > 1e-3 * high)
        for (const double share : {0.5, 0.47, 0.53, 0.44, 0.56, 0.41, 0.59, 0.38, 0.62}) {
            const double cut = std::pow(low + share * (high - low), 2);
            const Index left = factoriseAndCount(cut) - slice.below;
            if (factor_.shift() != cut || left < 0 || left > slice.count) // by rounding
                continue;
            const double above = cut * (1 + 1e-6), middle = (cut + above) / 2;
            if (factoriseAndCount(above) - slice.below != left || factor_.shift() != above)
                continue;
            split({slice.low, middle, slice.below, left}, slices);
            split({middle, slice.high, slice.below + left, slice.count - left}, slices);
            return;
        }
    slices.push_back(slice);
}

EigenBlock
BandSolver::solveSlice(const Slice& slice, const Vectors& deflated, const Vectors& before) {
    // The `count` eigenvalues nearest to the shift are exactly those of the slice. The shift is the
    // middle of the slice, but lies below the lowest slice, whose zero modes are deflated.
    factoriseAndCount(slice.below == zeroModes_ ? -lambdaOf(band_.lowestHz)
                                                : (slice.low + slice.high) / 2);
    Vectors found = deflated;
    int pass = 0, stalls = 0;
    for (; found.cols() < deflated.cols() + slice.count; ++pass) {
        const Index missing = slice.count - (found.cols() - deflated.cols());
        if (pass > 40)
            throw Fault{"The modes of the mesh were not found in a reasonable time; simplify it."};
        if (static_cast<double>(space_.rows()) *
                static_cast<double>(largestBasis(missing) + found.cols()) * 8 >
            workLimitBytes)
            throw Fault{"The analysis would need more than 3 GB; simplify the mesh."};
        auto fresh = nearestModes(factor_, space_, found,
                                  {.low = slice.low,
                                   .high = slice.high,
                                   .wanted = missing,
                                   .seed = 7u + pass,
                                   .step = [&] { countOperation(); }});
        if (fresh.values.size() == 0) {
            // The modes are too far from the shift. Move it nearer to the ends of the slice in
            // turn.
            ++stalls;
            const double inward = std::exp2(-(stalls / 2 + 1)) * (slice.high - slice.low);
            factoriseAndCount(stalls % 2 == 1 ? slice.high - inward : slice.low + inward);
            continue;
        }
        space_.projectOut(found, fresh.vectors);
        space_.projectOut(before, fresh.vectors);
        orthonormalise(fresh.vectors);
        const Index had = found.cols(), more = std::min(fresh.vectors.cols(), missing);
        found.conservativeResize(Eigen::NoChange, had + more);
        found.rightCols(more) = fresh.vectors.leftCols(more);
    }
    Vectors vectors = found.rightCols(slice.count);
    const Vectors image = symmetricTimes(model_.stiffness, vectors);
    if (pass <= 1)
        return {vectors.cwiseProduct(image).colwise().sum(), std::move(vectors)};
    // Close modes from different passes are slightly mixed: separate them in their common space.
    const Eigen::SelfAdjointEigenSolver<MatrixXd> small(innerProducts(vectors, image));
    Vectors mixed = Vectors::Zero(space_.rows(), slice.count);
    addCombinations(mixed, 1, vectors, small.eigenvectors());
    return {small.eigenvalues(), std::move(mixed)};
}

EigenBlock BandSolver::solve() {
    control_.report(0, "Counting modes");
    const double zeroEdge =
        std::clamp(1e-14 * factor_.norm(), lambdaOf(band_.lowestHz / 20), lambdaOf(band_.lowestHz));
    zeroModes_ = factoriseAndCount(zeroEdge);
    const double bottom = factor_.shift();
    const Index upTo = factoriseAndCount(lambdaOf(band_.highestHz));
    const double top = factor_.shift();
    const Index count = upTo - zeroModes_, n = space_.rows();
    if (count < 0)
        throw Fault{"The modes of the mesh cannot be counted in this band; check its size, its "
                    "unit and its proportions."};
    if (count > band_.maximumModes)
        throw Fault{"The object has " + std::to_string(count) + " modes below " +
                    std::to_string(std::lround(band_.highestHz)) + " Hz, more than the limit of " +
                    std::to_string(band_.maximumModes) +
                    "; make it smaller or thicker, or lower the highest frequency."};
    if (n <= denseUpTo || upTo > n * 3 / 4) {
        if (n > 3000)
            throw Fault{"The mesh is too coarse for so many modes; use a finer one, or lower the "
                        "highest frequency."};
        return solveDense(model_);
    }
    EigenBlock all{VectorXd(count), Vectors(n, count)};
    if (count == 0)
        return all;
    expectedOperations_ = 0.6 * static_cast<double>(count) + 10; // blocks of vectors
    std::vector<Slice> slices;
    split({bottom, top, zeroModes_, count}, slices);
    const Vectors zeros = zeroSpace();
    Index filled = 0, previous = 0;
    for (const auto& slice : slices) {
        // Project out the previous slice's modes, which are near enough to leave a visible part.
        // Modes farther away are orthogonal anyway.
        const EigenBlock block = solveSlice(slice, filled == 0 ? zeros : Vectors(n, 0),
                                            all.vectors.middleCols(filled - previous, previous));
        all.values.segment(filled, slice.count) = block.values;
        all.vectors.middleCols(filled, slice.count) = block.vectors;
        filled += slice.count;
        previous = slice.count;
    }
    return all;
}

Modes modesInBand(const VibrationModel& model,
                  const FrequencyBand& band,
                  const WorkControl& control) {
    BandSolver solver(model, band, control);
    const EigenBlock all = solver.solve();
    Modes modes;
    modes.zeroModes = solver.zeroModes();
    std::vector<Index> inBand;
    for (Index i = 0; i < all.values.size(); ++i)
        if (all.values(i) >= lambdaOf(band.lowestHz) && all.values(i) <= lambdaOf(band.highestHz))
            inBand.push_back(i);
    // Equal modes have separate Rayleigh quotients; rounding may leave them in any order.
    std::ranges::stable_sort(inBand, {}, [&](Index i) { return all.values(i); });
    const Index lowerThanBand = (all.values.array() < lambdaOf(band.lowestHz)).count();
    const bool holdsZeroModes = all.values.size() == model.mass.rows(); // true for the dense solver
    modes.belowBand = lowerThanBand - (holdsZeroModes ? modes.zeroModes : 0);
    modes.eigenvalues = all.values(inBand);
    modes.shapes = all.vectors(Eigen::all, inBand);
    for (auto shape : modes.shapes.colwise()) {
        Index largest = 0;
        shape.cwiseAbs().maxCoeff(&largest);
        if (shape(largest) < 0)
            shape = -shape;
    }
    return modes;
}

/// Runs `work` and turns a Fault into an error.
template <class Work>
auto resultOf(const Work& work) -> Result<decltype(work())> {
    try {
        return work();
    } catch (const Fault& fault) {
        return failure(fault.message);
    }
}

} // namespace

Result<Modes>
solveModes(const VibrationModel& model, const FrequencyBand& band, const WorkControl& control) {
    return resultOf([&] { return modesInBand(model, band, control); });
}

Result<Index> countModesBelow(const VibrationModel& model, double frequencyHz) {
    const WorkControl control;
    return resultOf(
        [&] { return BandSolver(model, {}, control).factoriseAndCount(lambdaOf(frequencyHz)); });
}

} // namespace idiophone
