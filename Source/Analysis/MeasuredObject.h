// A modal object from modes measured on recordings and from where those were struck (van den Doel,
// Kry & Pai 2001, section 4). How the modes are measured is RecordingFit's.
#pragma once

#include "Analysis/RecordingFit.h"
#include "Geometry/PointCarrier.h"
#include "Object/ModalObject.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace idiophone {

/// Where a recording was struck: a point in metres, or a distance from the z axis of something that
/// is the same all around it.
using StruckPlace = std::variant<std::array<double, 3>, double>;

struct MeasuredObjectSettings {
    std::string name;
    std::string source;               ///< the recordings, for people
    std::optional<Material> material; ///< what it is made of; nothing: a law fitted to the decays
    std::optional<Mesh> mesh;         ///< in metres; nothing: a surface through the places
    std::optional<double> massKg;     ///< nothing: of a closed mesh of a known material, else 0.2
};

/// γ and η ≥ 0 of α = (γ + η ω²)/2 that fit the measured decays best, by their relative errors.
DampingLaw fittedDamping(std::span<const MeasuredMode> modes);

/// Every mode keeps its measured decay (`decaysPerSecond`). Struck and heard at a place, a mode of
/// an object sounds by the square of its shape along the normal; so the shape is the root of the
/// amplitude measured there (places struck more than once: the root of the mean energy), and
/// amplitudes are what is interpolated between places. Their scale is that of a body of the given
/// mass: the strongest mode's mean square over the places is 1/mass.
///
/// Recordings and `places` come in the same order; places are all points or all radii. Fails, in
/// one sentence, where they are not, or are not as many, where there are no modes, or the material
/// has no damping or the mesh no faces.
Result<ModalObject> measuredObject(const RecordingFit& fit,
                                   std::span<const StruckPlace> places,
                                   const MeasuredObjectSettings& settings);

} // namespace idiophone
