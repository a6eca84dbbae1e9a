// The window's view of the workshop that makes materials from recordings of strikes.
#pragma once

#include "Geometry/SimpleShapes.h"

#include <filesystem>
#include <optional>
#include <string>

namespace idiophone {

/// A recording, and what was struck in it.
struct RecordedStrike {
    enum class Struck {
        shown,  ///< the object that plays
        mesh,   ///< the object of a mesh file
        shape,  ///< a simple shape
        unknown ///< then only the damping is fitted
    };

    std::filesystem::path recording = {};
    std::string materialName = {}; ///< in UTF-8; empty: "Material"
    Struck struck = Struck::unknown;
    std::filesystem::path mesh = {}; ///< for Struck::mesh; its unit is guessed
    std::string shape = {};          ///< for Struck::shape, of `simpleShapeNames`
    /// For Struck::shape; those of a bowl are outer ones. The thickness is also that of a mesh
    /// which is a shell.
    ShapeSizes sizes = {};
};

struct MaterialFitStatus {
    enum class Stage {
        none,
        working, ///< the sound stays
        done, ///< the material is in the user's folder, and plays unless another sound was loaded
        failed,
        cancelled
    };

    Stage stage = Stage::none;
    double progress = 0;                 ///< 0 to 1
    std::string step = {};               ///< while working: "Solving for modes"
    std::optional<int> secondsLeft = {}; ///< while working: an estimate, once there is one
    std::string report = {}; ///< done: what was found, in sentences; failed: why, in one sentence

    bool operator==(const MaterialFitStatus&) const = default;
};

/// For the message thread. No call blocks.
class MaterialFitView {
public:
    virtual ~MaterialFitView() = default;

    // Patterns of files, separated by semicolons: "*.wav;*.flac".
    virtual std::string recordingPatterns() const = 0;
    virtual std::string meshPatterns() const = 0;

    /// Name, size and wall of the single object that plays. Empty if each key has its own object,
    /// on a stage, or if the object has no mesh of its own.
    virtual std::string shownObject() const = 0;
    /// Fits a material in the background, saves it to the user's folder under a free name, and
    /// chooses it as one step of the history. Cancels a running fit. The status shows errors.
    virtual void fitMaterial(const RecordedStrike& strike) = 0;
    virtual void cancelFit() = 0;
    virtual MaterialFitStatus fitStatus() const = 0;
};

} // namespace idiophone
