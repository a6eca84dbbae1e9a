// Makes a material from the recording of a struck object, and says in words what was found.
#pragma once

#include "Analysis/MaterialFit.h"

#include <optional>
#include <string>

namespace idiophone {

/// The object that was struck.
struct StruckObject {
    std::string name; ///< used in errors: "its modes are not those of cup.obj"
    Mesh mesh;        ///< in metres
    std::optional<AnalysisMethod> method = {}; ///< empty: the one that suits it
    double thicknessMetres = 0.005;            ///< shells only; the default of AnalysisSettings
    std::string notes = {};                    ///< sentences on the mesh, which the report repeats
};

struct RecordedMaterial {
    MaterialFit fit; ///< its material has a name and a source
    std::string
        findings;      ///< "like Glass, speed of sound 5290 m/s; rings (T60) 1.2 s at 440 Hz, ..."
    std::string notes; ///< sentences: matched modes, assumed figures, remarks on the recording
};

/// Fits a material of that name to the recording. Without an object fits the damping alone. The
/// error is one sentence that names the recording or the object, or a cancellation. Takes seconds;
/// any thread but the audio thread.
Result<RecordedMaterial> materialOfRecording(const StrikeRecording& recording,
                                             const std::string& name,
                                             const std::optional<StruckObject>& object,
                                             const WorkControl& control = {});

} // namespace idiophone
