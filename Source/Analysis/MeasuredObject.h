// A modal object from modes measured on recordings and the struck places (van den Doel, Kry & Pai
// 2001, section 4). RecordingFit measures the modes.
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

/// The struck place of a recording: a point in metres, or a distance from the z axis of a
/// rotationally symmetric object.
using StruckPlace = std::variant<std::array<double, 3>, double>;

struct MeasuredObjectSettings {
    std::string name;
    std::string source;               ///< description of the recordings for the user
    std::optional<Material> material; ///< empty: a damping law fitted to the decays
    std::optional<Mesh> mesh;         ///< in metres; empty: a surface through the places
    std::optional<double> massKg;     ///< empty: from a closed mesh of a known material, else 0.2
};

/// Every mode keeps its measured decay (`decaysPerSecond`). If an object is struck and heard at one
/// place, a mode's amplitude is the square of its shape along the normal. So the shape is the root
/// of the measured amplitude. Repeated strikes at a place give the root of their mean energy.
/// Amplitudes are interpolated between places. They are scaled to a body of the given mass: the
/// strongest mode's mean square over the places is 1/mass.
///
/// `places` has the order of the recordings and holds only points or only radii. Errors, each one
/// sentence: mixed places, a wrong number of places, no modes, a material without damping, a mesh
/// without faces.
Result<ModalObject> measuredObject(const RecordingFit& fit,
                                   std::span<const StruckPlace> places,
                                   const MeasuredObjectSettings& settings);

} // namespace idiophone
