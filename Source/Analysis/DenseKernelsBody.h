// The code of DenseKernels, compiled once per instruction set. Each including file gives Eigen and
// the namespace `kernels` names of its own. Use only code that is certainly inlined: the linker
// would keep one copy of anything else, for an arbitrary instruction set.
#pragma once

#include "Analysis/DenseKernels.h"

#include <Eigen/Core>

namespace idiophone::kernels {

using Index = DenseProduct::Index;
using Packet = Eigen::internal::find_best_packet<double, 8>::type;
constexpr int packetSize = Eigen::internal::unpacket_traits<Packet>::size;
constexpr int tileSums = 8; ///< packets: many hide the latency of sums, few fit the registers

template <int rows, int packets>
EIGEN_ALWAYS_INLINE void tile(const DenseProduct& o, const double* a, const double* b, double* c) {
    using namespace Eigen::internal;
    Packet sum[rows][packets];
    for (auto& row : sum)
        for (Packet& value : row)
            value = pset1<Packet>(0.0);
    for (Index k = 0; k < o.inner; ++k, a += o.aColumn, b += o.bRow) {
        Packet right[packets];
        for (int p = 0; p < packets; ++p)
            right[p] = ploadu<Packet>(b + p * packetSize);
        for (int r = 0; r < rows; ++r) {
            const Packet left = pset1<Packet>(a[r * o.aRow]);
            for (int p = 0; p < packets; ++p)
                sum[r][p] = pmadd(left, right[p], sum[r][p]);
        }
    }
    const Packet factor = pset1<Packet>(o.factor);
    for (int r = 0; r < rows; ++r)
        for (int p = 0; p < packets; ++p) {
            double* out = c + r * o.cRow + p * packetSize;
            pstoreu(out, pmadd(factor, sum[r][p], ploadu<Packet>(out)));
        }
}

template <int packets>
EIGEN_DONT_INLINE void columnTile(const DenseProduct& o, Index column) {
    constexpr int tileRows = tileSums / packets;
    const double* b = o.b + column;
    Index row = 0;
    for (; row + tileRows <= o.rows; row += tileRows)
        tile<tileRows, packets>(o, o.a + row * o.aRow, b, o.c + row * o.cRow + column);
    if constexpr (tileRows > 4)
        for (; row + 4 <= o.rows; row += 4)
            tile<4, packets>(o, o.a + row * o.aRow, b, o.c + row * o.cRow + column);
    for (; row < o.rows; ++row)
        tile<1, packets>(o, o.a + row * o.aRow, b, o.c + row * o.cRow + column);
}

inline void singleColumn(const DenseProduct& o, Index column) {
    for (Index row = 0; row < o.rows; ++row) {
        double sum = 0;
        for (Index k = 0; k < o.inner; ++k)
            sum += o.a[row * o.aRow + k * o.aColumn] * o.b[k * o.bRow + column];
        o.c[row * o.cRow + column] += o.factor * sum;
    }
}

inline void addProduct(const DenseProduct& o) {
    Index column = 0;
    for (; column + 8 <= o.columns; column += 8)
        columnTile<8 / packetSize>(o, column);
    if constexpr (packetSize <= 4)
        for (; column + 4 <= o.columns; column += 4)
            columnTile<4 / packetSize>(o, column);
    for (; column < o.columns; ++column)
        singleColumn(o, column);
}

} // namespace idiophone::kernels
