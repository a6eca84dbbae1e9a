#include "Analysis/KrylovBasis.h"

#include "Analysis/DenseKernels.h"

#include <algorithm>

namespace idiophone {
namespace {

using Eigen::Index;

constexpr Index stripRows = 128; ///< rows of all blocks per step; the other operand stays cached

template <class Step>
void forStrips(Index rows, const Step& step) {
    for (Index row = 0; row < rows; row += stripRows)
        step(row, std::min(stripRows, rows - row));
}

} // namespace

void KrylovBasis::append(Vectors block) {
    size_ += block.cols();
    blocks_.push_back(std::move(block));
}

void KrylovBasis::projectOut(const Vectors& image, Vectors& block) const {
    const Index w = block.cols();
    Vectors shares = Vectors::Zero(size_, w);
    forStrips(block.rows(), [&](Index row, Index rows) {
        double* share = shares.data();
        for (const auto& own : blocks_) {
            const Index m = own.cols();
            addProduct(
                {m, w, rows, 1, own.data() + row * m, 1, m, image.data() + row * w, w, share, w});
            share += m * w;
        }
    });
    addTo(block, -1, shares);
}

Vectors KrylovBasis::combinations(const Vectors& coefficients) const {
    Vectors sums = Vectors::Zero(blocks_.front().rows(), coefficients.cols());
    addTo(sums, 1, coefficients);
    return sums;
}

void KrylovBasis::addTo(Vectors& sums, double factor, const Vectors& coefficients) const {
    const Index w = sums.cols();
    forStrips(sums.rows(), [&](Index row, Index rows) {
        const double* coefficient = coefficients.data();
        for (const auto& own : blocks_) {
            const Index m = own.cols();
            addProduct({rows, w, m, factor, own.data() + row * m, m, 1, coefficient, w,
                        sums.data() + row * w, w});
            coefficient += m * w;
        }
    });
}

} // namespace idiophone
