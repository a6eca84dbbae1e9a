#include "Analysis/KrylovBasis.h"

#include "Analysis/DenseKernels.h"
#include "Object/WorkTeam.h"

#include <algorithm>

namespace idiophone {
namespace {

using Eigen::Index;

constexpr Index stripRows = 128; ///< rows of all blocks per step; the other operand stays cached
constexpr Index chunkRows = 32 * stripRows; ///< a task of a thread

/// Calls `step(chunk, row, rows)` for each strip of each chunk of rows.
template <class Step>
void forStrips(Index rows, WorkTeam* team, const Step& step) {
    shareItems(team, static_cast<std::size_t>((rows + chunkRows - 1) / chunkRows),
               [&](std::size_t chunk, std::size_t) {
                   const Index first = static_cast<Index>(chunk) * chunkRows;
                   const Index end = std::min(rows, first + chunkRows);
                   for (Index row = first; row < end; row += stripRows)
                       step(chunk, row, std::min(stripRows, end - row));
               });
}

} // namespace

void KrylovBasis::append(Vectors block) {
    size_ += block.cols();
    blocks_.push_back(std::move(block));
}

void KrylovBasis::projectOut(const Vectors& image, Vectors& block) const {
    const Index w = block.cols();
    std::vector<Vectors> ofChunks(
        static_cast<std::size_t>((block.rows() + chunkRows - 1) / chunkRows));
    forStrips(block.rows(), team_, [&](std::size_t chunk, Index row, Index rows) {
        if (ofChunks[chunk].size() == 0)
            ofChunks[chunk].setZero(size_, w);
        double* share = ofChunks[chunk].data();
        for (const auto& own : blocks_) {
            const Index m = own.cols();
            addProduct(
                {m, w, rows, 1, own.data() + row * m, 1, m, image.data() + row * w, w, share, w});
            share += m * w;
        }
    });
    Vectors shares = Vectors::Zero(size_, w);
    for (const Vectors& own : ofChunks)
        shares += own;
    addTo(block, -1, shares);
}

Vectors KrylovBasis::combinations(const Vectors& coefficients) const {
    Vectors sums = Vectors::Zero(blocks_.front().rows(), coefficients.cols());
    addTo(sums, 1, coefficients);
    return sums;
}

void KrylovBasis::addTo(Vectors& sums, double factor, const Vectors& coefficients) const {
    const Index w = sums.cols();
    forStrips(sums.rows(), team_, [&](std::size_t, Index row, Index rows) {
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
