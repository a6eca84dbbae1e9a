// Bars in tune: a beam finds the arch, finite elements confirm it and correct what the beam cannot
// know. From a specification to the object that is played and the mesh that could be cut.
#pragma once

#include "Analysis/CordSupport.h"
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
    /// Where the search starts: what the targets do not ask for stays. Length 0: estimated.
    UndercutBar shape = {};
    PartialTargets targets = {}; ///< of the partials heard, damped
    Material material = {};      ///< of wood, the grain runs along the bar, the rings face up
    BarGrid grid = {};
    double maxFrequencyHz = 20000;
    /// Empty: the material's loss was measured on an instrument, cords and all.
    std::optional<CordSupport> cords = {};
    std::optional<Tube> tube = {};
};

struct TunedBar {
    UndercutBar shape;
    /// Damped frequencies of the vertical bending modes in the band, ascending, and which modes of
    /// the object they are: the others twist, bend sideways, stretch, or bend across.
    std::vector<double> partialsHz = {};
    std::vector<Eigen::Index> bendingModes = {};
    Mesh surface = {}; ///< the whole bar, closed, in metres
    /// With the bar's outline as its mesh, whose vertices on top carry shapes.
    ModalObject object = {};
};

/// The targets' partials are met within 0.5 cent (the fundamental) and 2 cents (the others).
inline constexpr double fundamentalToleranceCents = 0.5, partialToleranceCents = 2;

/// The bar as tuned, analysed up to `maxFrequencyHz`. Errors: those of tunedArch, solveModes and
/// `validated`, named after the bar; a band that does not hold the targets; `cancelledMessage`.
Result<TunedBar> tuneBar(const BarSpecification& bar, const WorkControl& control = {});

/// Which modes of a tuned bar's object bend up and down, ascending. Of two that share a shape with
/// a tube, the one of the larger gain.
std::vector<Eigen::Index> verticalBendingModes(const ModalObject& bar);

/// What the beam needs to know of a material whose grain runs along it.
BeamMaterial beamMaterial(const Material& material);

} // namespace idiophone
