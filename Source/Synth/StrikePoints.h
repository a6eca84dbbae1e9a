// Where an object can be struck: its vertices with shapes, to be found by their place.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/Strike.h"

#include <array>
#include <memory>
#include <vector>

namespace idiophone {

/// Constructed off the audio thread; from then on read-only and without allocation, for any thread.
class StrikePoints {
public:
    /// `object` is not null and valid.
    explicit StrikePoints(std::shared_ptr<const ModalObject> object);

    /// The vertex with shapes that is nearest to a point, with its outward normal. The point is in
    /// metres, in the coordinates of the object's mesh: of a scaled slot divided by its size. Takes
    /// time with the number of such vertices.
    StrikePoint nearest(const std::array<double, 3>& pointMetres) const noexcept;

private:
    std::shared_ptr<const ModalObject> object;
    std::vector<float> normals; ///< [V,3]
};

} // namespace idiophone
