// SPDX-License-Identifier: Apache-2.0
// Moments of inertia as glTF's extensions write them: along principal axes, with a turn.
#pragma once

#include <array>

namespace idiophone {

struct PrincipalInertia {
    std::array<double, 3> diagonalKgM2{};          ///< about the principal axes
    std::array<double, 4> orientation{0, 0, 0, 1}; ///< (x, y, z, w) from these axes to the body's
};

/// Returns the matrix [3,3], row by row.
std::array<double, 9> inertiaMatrix(const PrincipalInertia& inertia);

/// `matrix` is symmetric. Negative moments, which no body has, become 0.
PrincipalInertia principalInertia(const std::array<double, 9>& matrix);

} // namespace idiophone
