// The material of a recorded object, from the modes of its recording (after Ren, Yeh & Lin 2013,
// "Example-guided physically based modal sound synthesis"). RecordingFit measures the modes.
#pragma once

#include "Analysis/ModalAnalysis.h"
#include "Analysis/RecordingFit.h"

#include <optional>
#include <span>
#include <string>

namespace idiophone {

/// How the modes of an object lie over measured ones.
struct ModeMatch {
    double score = 0; ///< in nats: how much better than chance the object explains the modes
    double frequencyRatio = 1;        ///< of a measured mode to the object's
    std::vector<std::size_t> matched; ///< indices of measured modes within some per cent
    std::optional<double> other;      ///< another ratio that explains the modes nearly as well
};

/// Finds the ratio from 0.04 to 4 at which the object's frequencies (Hz, ascending, complete up to
/// the last) explain the measured ones best. A match counts by how unlikely it is by chance: more
/// where the object's modes lie far apart. Weak measured modes count less. Returns nothing if no
/// ratio explains two modes.
std::optional<ModeMatch> matchModes(std::span<const MeasuredMode> measured,
                                    std::span<const double> objectHz);

struct MaterialFit {
    /// Modes do not show the density and the figures of contacts. They are those of the library
    /// material that it resembles most.
    Material material;
    std::string resembles;            ///< name of that library material
    std::size_t matched = 0;          ///< measured modes that are modes of the object
    std::optional<double> otherRatio; ///< Y/ρ of another reading over that of `material`
};

/// Fits the damping law alone. Young's modulus is that of the library material with the most
/// similar damping. The error is a sentence: no modes.
Result<MaterialFit> fitDampingOnly(std::span<const MeasuredMode> measured);

/// Fits Y/ρ and the damping law, given the mesh (in metres) of the recorded object. Analyses it
/// with steel at three Poisson's ratios. Reads name, method and thickness from the settings.
/// Returns nothing if the modes are not those of the mesh. The error is one of `analyse`. Any
/// thread but the audio thread may call it.
Result<std::optional<MaterialFit>> fitMaterial(std::span<const MeasuredMode> measured,
                                               const Mesh& mesh,
                                               AnalysisSettings settings,
                                               const WorkControl& control = {});

} // namespace idiophone
