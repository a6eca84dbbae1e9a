// SPDX-License-Identifier: Apache-2.0
// Finds the point where an object is struck: a vertex with shapes near a given place.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/Strike.h"

#include <array>
#include <memory>
#include <vector>

namespace idiophone {

/// Constructed off the audio thread; afterwards read-only without allocation, for any thread.
class StrikePoints {
public:
    /// `object` is not null and valid.
    explicit StrikePoints(std::shared_ptr<const ModalObject> object);

    /// Returns the nearest vertex with shapes and its outward normal. The point is in metres, in
    /// the coordinates of the object's mesh; divide it by the size of a scaled slot. Takes time
    /// proportional to the number of vertices with shapes.
    StrikePoint nearest(const std::array<double, 3>& pointMetres) const noexcept;

private:
    std::shared_ptr<const ModalObject> object;
    std::vector<float> normals; ///< [V,3]
};

} // namespace idiophone
