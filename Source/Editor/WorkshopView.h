// What the window needs of the workshop, where objects are made from files, and of how the keys
// play the object that came of it.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// How a mesh is made an object.
struct ImportSettings {
    std::string unit = {};          ///< "m", "cm", "mm", "in", "ft"; empty: guessed from the size
    std::string material = "Steel"; ///< the library's or the user's own
    double thicknessMetres = 0.002; ///< of a shell; 1e-5 to 1
    /// "fem", "two-layer", "spring-mass", "van-gelder"; empty: what suits the mesh.
    std::string method = {};

    bool operator==(const ImportSettings&) const = default;
};

/// How the job stands that was asked for last, while nothing else plays than before it or what came
/// of it.
struct ImportStatus {
    enum class Stage {
        none,      ///< what plays did not come from a file here
        working,   ///< the sound is as it was
        previewed, ///< working, and a preview of the object plays
        done,      ///< the object plays
        failed,    ///< `error` says why; a preview that came before plays on
        cancelled  ///< likewise
    };

    Stage stage = Stage::none;
    std::string fileName; ///< without its folder
    /// The mesh opened last is in memory, and nothing else was loaded since.
    bool followsSettings = false;
    ImportSettings
        settings;        ///< in force: those given, or what a single object is that came otherwise
    double progress = 0; ///< 0 to 1
    std::string step;    ///< what is being done, such as "Solving for modes"
    std::string error;   ///< a sentence
    // Of the object made last, empty before.
    std::string summary; ///< such as "171 modes from 412 Hz to 44.0 kHz; 1.60 kg of Steel, ..."
    std::string notes;   ///< what repair and analysis chose and why, in sentences
    std::string unit;    ///< symbol of the unit taken
    std::string method;  ///< the method taken

    bool isWorking() const { return stage == Stage::working || stage == Stage::previewed; }
    bool operator==(const ImportStatus&) const = default;
};

/// How the keys play a single object.
enum class KeyLayout {
    scaled, ///< resized for each key to its pitch
    zones   ///< at its own size, struck along a path as the keys go up
};

/// For the message thread; nothing waits.
class WorkshopView {
public:
    virtual ~WorkshopView() = default;

    /// Whether the extension is one of those read, in any case.
    virtual bool canOpen(const std::filesystem::path& file) const = 0;
    /// Of these files, separated by semicolons: "*.obj;*.modal".
    virtual std::string openPatterns() const = 0;
    /// Makes an object of the file with the settings in force, in the background, and plays it as
    /// soon as it sounds. What was under way is cancelled. What goes wrong is in the status.
    virtual void openFile(const std::filesystem::path& file) = 0;
    /// For what is opened from now on; and where `ImportStatus::followsSettings`, the object is
    /// made anew. Settings out of range fail in the status.
    virtual void setImportSettings(const ImportSettings& settings) = 0;
    /// Whether what plays has a mesh to be analysed anew: it came from one in this session, or is a
    /// single object, whose own is taken.
    virtual bool canAnalyseAgain() const = 0;
    /// Makes the object that plays anew with the settings in force.
    virtual void analyseAgain() = 0;
    virtual void cancelImport() = 0;
    virtual ImportStatus importStatus() const = 0;

    /// Nothing where the instrument has an object for each key.
    virtual std::optional<KeyLayout> keyLayout() const = 0;
    /// What plays fades into the other without a click.
    virtual void setKeyLayout(KeyLayout layout) = 0;

    /// The path along which keys strike one of `ProcessorView::playedObjects`, in metres of its own
    /// mesh, from the lowest key's end: the places on the surface nearest to it are struck. Of a
    /// keyboard the path of one object is that of all, to the proportions of each. At most 1000
    /// points are kept, evenly; a path without a finite point changes nothing.
    virtual void setStrikePath(std::size_t index,
                               const std::vector<std::array<double, 3>>& pathMetres) = 0;
};

} // namespace idiophone
