// SPDX-License-Identifier: Apache-2.0
// Stands in place of libigl's parallel_for.h, which needs threads. CMake includes it first.
#pragma once

#include <cstddef>

#define IGL_PARALLEL_FOR_H

namespace igl {

template <class Index, class Body>
bool parallel_for(Index count, const Body& body, std::size_t = 0) {
    for (Index k = 0; k < count; ++k)
        body(k);
    return false;
}

} // namespace igl
