#include "Analysis/Eigensolver.h"

#include "Analysis/ShiftedFactor.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Spectra/SymEigsShiftSolver.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index denseUpTo = 400; ///< rows; below, LAPACK-style dense solves are quicker
constexpr double workLimitBytes = 3e9;
constexpr double countingShare = 0.05; ///< of the progress
constexpr std::string_view cannotFactorise =
    "The stiffness matrix cannot be factorised; the mesh is too badly shaped.";

/// Thrown through Spectra's iteration, which has no other way out; never leaves this file.
struct Cancelled {};

/// Beyond this a basis costs more than another factorisation, and one step of dense algebra on it
/// more than a cancelling user's patience: n k² is what both go with.
Index modesPerSlice(Index rows) {
    return std::clamp(static_cast<Index>(std::sqrt(5e8 / static_cast<double>(rows))), Index{40},
                      Index{220});
}

double lambdaOf(double frequencyHz) {
    const double omega = 2 * std::numbers::pi * frequencyHz;
    return omega * omega;
}

/// A = M^-1/2 K M^-1/2, lower triangle.
Eigen::SparseMatrix<double> massScaled(const VibrationModel& model) {
    const VectorXd scale = model.mass.cwiseSqrt().cwiseInverse();
    Eigen::SparseMatrix<double> scaled = model.stiffness;
    for (Index column = 0; column < scaled.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(scaled, column); entry; ++entry)
            entry.valueRef() *= scale(entry.row()) * scale(entry.col());
    return scaled;
}

/// The part of X (or x) that is orthogonal to the orthonormal columns of the basis, twice for
/// rounding.
template <class Block>
void projectOut(const Eigen::Ref<const MatrixXd>& basis, Block& block) {
    if (basis.cols() == 0)
        return;
    for (int pass = 0; pass < 2; ++pass)
        block -= basis * (basis.transpose() * block).eval();
}

MatrixXd orthonormalised(const MatrixXd& block) {
    const Eigen::HouseholderQR<MatrixXd> qr(block);
    return qr.householderQ() * MatrixXd::Identity(block.rows(), block.cols());
}

MatrixXd fixedRandomBlock(Index rows, Index columns, unsigned seed) {
    std::mt19937 generator(seed);
    MatrixXd block(rows, columns);
    for (double& value : block.reshaped())
        value = static_cast<double>(generator()) / 4294967296.0 - 0.5;
    return block;
}

/// Eigenvalues between `low` and `high` (in λ), `below` of them below `low`.
struct Slice {
    double low = 0, high = 0;
    Index below = 0, count = 0;
};

struct EigenBlock {
    VectorXd values;
    MatrixXd vectors; ///< orthonormal
};

class BandSolver {
public:
    BandSolver(const VibrationModel& model,
               const FrequencyBand& band,
               const AnalysisControl& control)
        : matrix_(massScaled(model)), factor_(matrix_, model.rowsPerVertex, control), band_(band),
          control_(control) {}

    Result<EigenBlock> solve();
    Index zeroModes() const { return zeroModes_; }
    Index factoriseAndCount(double lambda);

private:
    struct DeflatedInverse;

    EigenBlock solveDense();
    MatrixXd zeroSpace();
    void split(const Slice& slice, std::vector<Slice>& slices);
    EigenBlock solveSlice(const Slice& slice, const MatrixXd& deflated);
    EigenBlock rayleighRitz(const MatrixXd& basis) const;
    void checkCancelled() const;
    void countOperation();

    Eigen::SparseMatrix<double> matrix_;
    ShiftedFactor factor_;
    FrequencyBand band_;
    const AnalysisControl& control_;
    Index zeroModes_ = 0;
    double operations_ = 0, expectedOperations_ = 1, counts_ = 0;
};

struct Fault {
    std::string message;
};

/// x ↦ P (A − σI)⁻¹ P x, P leaving out the vectors already found.
struct BandSolver::DeflatedInverse {
    using Scalar = double;
    BandSolver& solver;
    const MatrixXd& found;

    Index rows() const { return solver.matrix_.rows(); }
    Index cols() const { return solver.matrix_.cols(); }
    void set_shift(double) {} // the factor stands already
    void perform_op(const double* in, double* out) const {
        solver.countOperation();
        VectorXd x = Eigen::Map<const VectorXd>(in, rows());
        projectOut(found, x);
        VectorXd y = solver.factor_.solve(x);
        projectOut(found, y);
        Eigen::Map<VectorXd>(out, rows()) = y;
    }
};

void BandSolver::checkCancelled() const {
    if (control_.isCancelled())
        throw Cancelled{};
}

void BandSolver::countOperation() {
    checkCancelled();
    if (static_cast<long>(++operations_) % 16 == 0)
        control_.report(countingShare + (0.99 - countingShare) *
                                            (1 - std::exp(-2 * operations_ / expectedOperations_)),
                        "Solving for modes");
}

Index BandSolver::factoriseAndCount(double lambda) {
    const auto outcome = factor_.factorise(lambda);
    if (outcome == ShiftedFactor::Outcome::cancelled)
        throw Cancelled{};
    if (outcome == ShiftedFactor::Outcome::failed)
        throw Fault{std::string(cannotFactorise)};
    if (operations_ == 0)
        control_.report(countingShare * (1 - std::exp(-0.1 * ++counts_)), "Counting modes");
    return factor_.eigenvaluesBelow();
}

EigenBlock BandSolver::rayleighRitz(const MatrixXd& basis) const {
    const MatrixXd image = matrix_.selfadjointView<Eigen::Lower>() * basis;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> small(basis.transpose() * image);
    return {small.eigenvalues(), basis * small.eigenvectors()};
}

EigenBlock BandSolver::solveDense() {
    const MatrixXd dense = MatrixXd(matrix_).selfadjointView<Eigen::Lower>();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(dense);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

/// An orthonormal basis of the zero modes, by subspace iteration just below zero. Their
/// shift-invert images outgrow all others by orders of magnitude, so two or three steps do; a
/// Lanczos process would find hundreds of equal eigenvalues one copy at a time.
MatrixXd BandSolver::zeroSpace() {
    if (zeroModes_ == 0)
        return MatrixXd(matrix_.rows(), 0);
    if (static_cast<double>(matrix_.rows()) * static_cast<double>(zeroModes_) * 8 > workLimitBytes)
        throw Fault{"The mesh has " + std::to_string(zeroModes_) +
                    " zero modes in this model, too many to separate; use the two-layer method."};
    const double edge = lambdaOf(band_.lowestHz);
    factoriseAndCount(-edge);
    MatrixXd basis = orthonormalised(fixedRandomBlock(matrix_.rows(), zeroModes_, 1));
    for (int step = 0; step < 60; ++step) {
        checkCancelled();
        basis = orthonormalised(factor_.solve(basis));
        const MatrixXd image = matrix_.selfadjointView<Eigen::Lower>() * basis;
        if (image.colwise().norm().maxCoeff() <= 1e-6 * edge + 1e-15 * factor_.norm())
            break;
    }
    return basis;
}

/// Cuts until a slice holds few enough, at places with no eigenvalue within a millionth, where the
/// counts on both sides leave no doubt.
void BandSolver::split(const Slice& slice, std::vector<Slice>& slices) {
    if (slice.count == 0)
        return;
    const double low = std::sqrt(std::max(slice.low, 0.0)), high = std::sqrt(slice.high);
    if (slice.count > modesPerSlice(matrix_.rows()) && high - low > 1e-3 * high)
        for (const double share : {0.5, 0.47, 0.53, 0.44, 0.56, 0.41, 0.59, 0.38, 0.62}) {
            const double cut = std::pow(low + share * (high - low), 2);
            const Index left = factoriseAndCount(cut) - slice.below;
            if (factoriseAndCount(cut * (1 + 1e-6)) - slice.below != left)
                continue;
            split({slice.low, cut, slice.below, left}, slices);
            split({cut, slice.high, slice.below + left, slice.count - left}, slices);
            return;
        }
    slices.push_back(slice);
}

EigenBlock BandSolver::solveSlice(const Slice& slice, const MatrixXd& deflated) {
    // The `count` eigenvalues nearest to the shift are exactly those of the slice: from its middle,
    // or for the lowest slice, whose zero modes are deflated, from below.
    const bool lowest = slice.below == zeroModes_;
    const double shift = lowest ? -lambdaOf(band_.lowestHz) : (slice.low + slice.high) / 2;
    factoriseAndCount(shift);
    const double sigma = factor_.shift(), n = static_cast<double>(matrix_.rows());
    MatrixXd found = deflated;
    for (unsigned pass = 0; found.cols() < deflated.cols() + slice.count; ++pass) {
        const Index missing = slice.count - (found.cols() - deflated.cols());
        const Index room = matrix_.rows() - found.cols();
        const Index basisSize = std::min(room, missing + std::max<Index>(24, missing * 7 / 10));
        if (pass > 40 || basisSize <= missing)
            throw Fault{"The eigenvalue solver did not converge."};
        if (n * static_cast<double>(basisSize + found.cols()) * 8 > workLimitBytes)
            throw Fault{"The analysis would need more than 3 GB; lower the band or the mesh."};
        DeflatedInverse inverse{*this, found};
        Spectra::SymEigsShiftSolver<DeflatedInverse> lanczos(inverse, missing, basisSize, sigma);
        VectorXd start = fixedRandomBlock(matrix_.rows(), 1, 7 + pass);
        projectOut(found, start);
        lanczos.init(start.data());
        lanczos.compute(Spectra::SortRule::LargestMagn, 60, 1e-11, Spectra::SortRule::SmallestAlge);
        // What a degenerate mode's missing copies made room for lies outside the slice.
        const VectorXd values = lanczos.eigenvalues();
        const MatrixXd vectors = lanczos.eigenvectors();
        std::vector<Index> inside;
        for (Index i = 0; i < values.size(); ++i)
            if (values(i) > slice.low * (1 - 1e-9) && values(i) < slice.high * (1 + 1e-9))
                inside.push_back(i);
        if (inside.empty())
            continue;
        MatrixXd fresh = vectors(Eigen::all, inside);
        projectOut(found, fresh);
        fresh = orthonormalised(fresh);
        const Index before = found.cols();
        found.conservativeResize(Eigen::NoChange, before + fresh.cols());
        found.rightCols(fresh.cols()) = fresh;
    }
    // One more inverse iteration damps what remains of stiff modes far outside the band.
    MatrixXd basis = factor_.solve(found.rightCols(slice.count));
    projectOut(deflated, basis);
    return rayleighRitz(orthonormalised(basis));
}

Result<EigenBlock> BandSolver::solve() {
    try {
        control_.report(0, "Counting modes");
        const double norm = factor_.norm();
        const double lowest = lambdaOf(band_.lowestHz), highest = lambdaOf(band_.highestHz);
        const double zeroEdge =
            std::min(lowest, std::max(lambdaOf(band_.lowestHz / 20), 1e-14 * norm));
        zeroModes_ = factoriseAndCount(zeroEdge);
        const double bottom = factor_.shift();
        const Index upTo = factoriseAndCount(highest);
        const double top = factor_.shift();
        const Index count = upTo - zeroModes_;
        if (count > band_.maximumModes)
            throw Fault{"The object has " + std::to_string(count) + " modes below " +
                        std::to_string(std::lround(band_.highestHz)) +
                        " Hz, more than the limit of " + std::to_string(band_.maximumModes) +
                        "; lower the highest frequency or choose a coarser mesh."};
        const Index n = matrix_.rows();
        if (n <= denseUpTo || upTo > n * 3 / 4) {
            if (n > 3000)
                throw Fault{"Nearly all modes of the mesh lie in the band; lower the highest "
                            "frequency."};
            return solveDense();
        }
        EigenBlock all{VectorXd(count), MatrixXd(n, count)};
        if (count == 0)
            return all;
        expectedOperations_ = 2.5 * static_cast<double>(count) + 60;
        std::vector<Slice> slices;
        split({bottom, top, zeroModes_, count}, slices);
        const MatrixXd zeros = zeroSpace();
        Index filled = 0;
        MatrixXd previous = zeros;
        for (const auto& slice : slices) {
            const EigenBlock block = solveSlice(slice, previous);
            all.values.segment(filled, slice.count) = block.values;
            all.vectors.middleCols(filled, slice.count) = block.vectors;
            filled += slice.count;
            // Slices further off differ enough for their vectors to be orthogonal by themselves.
            previous = block.vectors;
        }
        return all;
    } catch (const Cancelled&) {
        return failure(std::string(cancelledMessage));
    } catch (const Fault& fault) {
        return failure(fault.message);
    } catch (const std::bad_alloc&) {
        return failure("The analysis needs more memory than this machine has.");
    } catch (const std::exception& fault) {
        return failure(std::string("The eigenvalue solver failed: ") + fault.what() + ".");
    }
}

} // namespace

Result<Modes>
solveModes(const VibrationModel& model, const FrequencyBand& band, const AnalysisControl& control) {
    BandSolver solver(model, band, control);
    auto all = solver.solve();
    if (!all)
        return failure(all.error().message);
    Modes modes;
    modes.zeroModes = solver.zeroModes();
    std::vector<Index> inBand;
    for (Index i = 0; i < all->values.size(); ++i)
        if (all->values(i) >= lambdaOf(band.lowestHz) && all->values(i) <= lambdaOf(band.highestHz))
            inBand.push_back(i);
    const Index lowerThanBand = (all->values.array() < lambdaOf(band.lowestHz)).count();
    const bool holdsZeroModes = all->values.size() == model.mass.size(); // the dense solver's
    modes.belowBand = lowerThanBand - (holdsZeroModes ? modes.zeroModes : 0);
    modes.eigenvalues = all->values(inBand);
    modes.shapes = model.mass.cwiseSqrt().cwiseInverse().asDiagonal() *
                   MatrixXd(all->vectors(Eigen::all, inBand));
    for (auto shape : modes.shapes.colwise()) {
        Index largest = 0;
        shape.cwiseAbs().maxCoeff(&largest);
        if (shape(largest) < 0)
            shape = -shape;
    }
    return modes;
}

Result<Index> countModesBelow(const VibrationModel& model, double frequencyHz) {
    const Eigen::SparseMatrix<double> matrix = massScaled(model);
    const AnalysisControl control;
    ShiftedFactor factor(matrix, model.rowsPerVertex, control);
    if (factor.factorise(lambdaOf(frequencyHz)) != ShiftedFactor::Outcome::done)
        return failure(std::string(cannotFactorise));
    return factor.eigenvaluesBelow();
}

} // namespace idiophone
