// The window's view of the workshop, which makes objects from files, and of how keys play them.
#pragma once

#include "Editor/HeldSettings.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

struct ImportSettings {
    std::string unit = {};          ///< "m", "cm", "mm", "in", "ft"; empty: guess from the size
    std::string material = "Steel"; ///< name of a material of the library or the user
    double thicknessMetres = 0.002; ///< thickness of a shell; 1e-5 to 1
    /// "fem", "two-layer", "spring-mass" or "van-gelder"; empty: chosen for the mesh.
    std::string method = {};
    /// The longest side of the mesh's bounding box, to which it is scaled, 0.001 to 20; 0: as the
    /// unit says.
    double longestMetres = 0;
    HeldSettings held = {};

    bool operator==(const ImportSettings&) const = default;
};

/// The state of the last import job, as long as no other sound is loaded.
struct ImportStatus {
    enum class Stage {
        none,      ///< the current sound was not imported here
        working,   ///< the previous sound still plays
        previewed, ///< still working; a preview of the object plays
        done,      ///< the object plays
        failed,    ///< `error` gives the reason; a preview, if any, still plays
        cancelled  ///< a preview, if any, still plays
    };

    Stage stage = Stage::none;
    /// Without its folder. After a failure, the name of the object that still plays.
    std::string fileName;
    /// True if the last mesh is in memory and nothing else was loaded since.
    bool followsSettings = false;
    /// The settings in effect: those that were set, or those of a single object that was not
    /// imported.
    ImportSettings settings;
    double progress = 0; ///< 0 to 1
    std::string step;    ///< current step, such as "Solving for modes"
    std::string error;   ///< one sentence
    /// While working: an estimate, once there is one.
    std::optional<int> secondsLeft;
    /// Sides of the bounding box, and the mass, of the last object made, or of a single object that
    /// was not imported; 0 before.
    std::array<double, 3> sidesMetres{};
    double massKg = 0;
    // About the last object made; empty before.
    std::string summary; ///< such as "171 modes from 412 Hz to 44.0 kHz; 1.60 kg of Steel, ..."
    std::string notes;   ///< choices of repair and analysis with reasons, in sentences
    std::string unit;    ///< symbol of the chosen unit
    std::string method;  ///< the chosen method
    std::vector<std::string> groups; ///< names of the mesh's parts that can be held
    bool wasHeld = false;            ///< whether the mesh is that of an object that was held

    bool isWorking() const { return stage == Stage::working || stage == Stage::previewed; }
    bool operator==(const ImportStatus&) const = default;
};

/// How keys play a single object.
enum class KeyLayout {
    scaled, ///< resized to each key's pitch
    zones   ///< at its own size, struck further along a path by higher keys
};

/// For the message thread. No call blocks.
class WorkshopView {
public:
    virtual ~WorkshopView() = default;

    /// Whether files with this extension, in upper or lower case, can be read.
    virtual bool canOpen(const std::filesystem::path& file) const = 0;
    /// The patterns of these files, separated by semicolons: "*.obj;*.modal".
    virtual std::string openPatterns() const = 0;
    /// Makes an object from the file in the background, with the current settings, and plays it
    /// when it is ready. Cancels a running job. The status shows errors.
    virtual void openFile(const std::filesystem::path& file) = 0;
    /// Does so for one key, 0 to 127: the sound that plays becomes a kit, in which the object also
    /// sounds on that key.
    virtual void openFileOnKey(const std::filesystem::path& file, int midiNote) = 0;
    /// Sets the settings for later files. If `ImportStatus::followsSettings`, also makes the object
    /// again. The status shows errors for settings out of range.
    virtual void setImportSettings(const ImportSettings& settings) = 0;
    /// Whether the current sound has a mesh to analyse again: one opened in this session, or the
    /// mesh of a single object.
    virtual bool canAnalyseAgain() const = 0;
    /// Analyses the current object again with the current settings.
    virtual void analyseAgain() = 0;
    virtual void cancelImport() = 0;
    virtual ImportStatus importStatus() const = 0;
    /// Whether a mesh is being analysed and its preview plays.
    virtual bool playsPreview() const = 0;

    /// Nothing if the instrument has an object for each key.
    virtual std::optional<KeyLayout> keyLayout() const = 0;
    /// Sets the layout. The sound crossfades without a click.
    virtual void setKeyLayout(KeyLayout layout) = 0;

    /// Sets the path along which keys strike an object, in metres of its mesh, from the lowest
    /// key's end. Keys strike the surface points nearest to the path. On a keyboard the path
    /// applies to all objects, scaled to their proportions. At most 1000 points are kept, evenly
    /// spaced. A path without a finite point changes nothing.
    virtual void setStrikePath(std::size_t index,
                               const std::vector<std::array<double, 3>>& pathMetres) = 0;
};

} // namespace idiophone
