// Tunes a bar to its partials. A beam model finds the arch, then finite elements check it and
// correct the errors of the beam model. The result is a modal object and a mesh for manufacture.
#pragma once

#include "Analysis/CordSupport.h"
#include "Analysis/HeldEnd.h"
#include "Analysis/Pitch.h"
#include "Analysis/SolidBar.h"
#include "Analysis/Tube.h"
#include "Analysis/UndercutBar.h"
#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <optional>

namespace idiophone {

struct BarSpecification {
    std::string name = {};
    std::string source = {}; ///< for the object's provenance
    /// The start of the search. Dimensions without a target are kept. A length of 0 is estimated.
    UndercutBar shape = {};
    PartialTargets targets = {}; ///< for the damped partials
    Material material = {};      ///< in wood, the grain runs along the bar and the rings face up
    double maxFrequencyHz = 20000;
    /// Empty if the material's loss was measured on an instrument and includes the cords.
    std::optional<CordSupport> cords = {};
    std::optional<Tube> tube = {};
    /// Empty for a free bar. A held bar is uniform, and only its fundamental has a target.
    std::optional<HeldEnd> held = {};
};

struct TunedBar {
    UndercutBar shape;
    /// Damped frequencies of the vertical bending modes in the band, ascending, and their mode
    /// indices in the object. The other modes twist, bend sideways, stretch, or bend across the
    /// width.
    std::vector<double> partialsHz = {};
    std::vector<Eigen::Index> bendingModes = {};
    Mesh surface = {}; ///< the whole bar, closed, in metres
    /// The object's mesh is the bar's outline. The outline's top vertices carry the shapes.
    ModalObject object = {};
};

/// Tolerances for the fundamental and for the other target partials.
inline constexpr double fundamentalToleranceCents = 0.5, partialToleranceCents = 2;

/// Tunes the bar and analyses it up to `maxFrequencyHz`. Errors: those of tunedArch, solveModes and
/// `validated`, with the bar's name; targets outside the band; `cancelledMessage`.
Result<TunedBar> tuneBar(const BarSpecification& bar, const WorkControl& control = {});

/// Returns the modes of a tuned bar that bend vertically, ascending. If a bar mode and a tube mode
/// share a shape, only the one with the larger gain counts.
std::vector<Eigen::Index> verticalBendingModes(const ModalObject& bar);

/// Returns the beam's constants for a material whose grain runs along the bar.
BeamMaterial beamMaterial(const Material& material);

} // namespace idiophone
