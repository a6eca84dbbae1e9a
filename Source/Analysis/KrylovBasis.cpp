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
    const auto addProduct = denseKernels().addProduct;
    const Index w = block.cols();
    Vectors shares = Vectors::Zero(size_, w);
    forStrips(block.rows(), [&](Index row, Index rows) {
        double* share = shares.data();
        for (const auto& own : blocks_) {
            const Index m = own.cols();
            addProduct(m, w, rows, 1, own.data() + row * m, 1, m, image.data() + row * w, w, share,
                       w);
            share += m * w;
        }
    });
    forStrips(block.rows(), [&](Index row, Index rows) {
        const double* share = shares.data();
        for (const auto& own : blocks_) {
            const Index m = own.cols();
            addProduct(rows, w, m, -1, own.data() + row * m, m, 1, share, w, block.data() + row * w,
                       w);
            share += m * w;
        }
    });
}

Vectors KrylovBasis::combinations(const Vectors& coefficients) const {
    const Index n = blocks_.front().rows(), count = coefficients.cols();
    Vectors sums = Vectors::Zero(n, count);
    forStrips(n, [&](Index row, Index rows) {
        const double* coefficient = coefficients.data();
        for (const auto& own : blocks_) {
            const Index m = own.cols();
            denseKernels().addProduct(rows, count, m, 1, own.data() + row * m, m, 1, coefficient,
                                      count, sums.data() + row * count, count);
            coefficient += m * count;
        }
    });
    return sums;
}

} // namespace idiophone
