// Makes objects from files on its own thread: reads, makes a preview, then analyses in full. It
// does not know the processor, which fetches the results.
#pragma once

#include "Editor/WorkshopView.h"
#include "Geometry/LengthUnit.h"
#include "Mesh/Mesh.h"
#include "Object/ModalObject.h"
#include "Object/Result.h"
#include "Plugin/HeldParts.h"
#include "Plugin/ImportChoices.h"
#include "Plugin/RemainingTime.h"
#include "Plugin/WorkThread.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace idiophone {

/// Threads: call every member function from one thread at a time, not the audio thread (the message
/// thread calls them). The worker runs from the first job to the destructor. Both sides share the
/// job, the status and the product under `mutex`, and hold it only for a copy. Cancelling is an
/// atomic flag of the job. A product not fetched is replaced by the next and blocks nothing.
class ObjectWorkshop {
public:
    /// The result of a job: first the preview, if there is one, then the whole object.
    struct Product {
        std::shared_ptr<const ModalObject> object;
        std::string objectName; ///< unique among all objects, for states and the library
        bool isPreview = false;
        bool isFirst = false;   ///< first product of its job
        bool isNewFile = false; ///< from a newly opened file, not another analysis of a known mesh
    };

    ObjectWorkshop() = default;
    ObjectWorkshop(const ObjectWorkshop&) = delete;
    ObjectWorkshop& operator=(const ObjectWorkshop&) = delete;
    /// Cancels, and waits until the worker has stopped.
    ~ObjectWorkshop();

    /// Starts a job for a file. Replaces any running or pending job.
    void open(const std::filesystem::path& file, const ImportSettings& settings);
    /// Starts a job for the mesh opened last, if there is one.
    void analyseAgain(const ImportSettings& settings);
    /// Starts a job for the mesh of an object, which keeps its name.
    void analyse(const ModalObject& object, const ImportSettings& settings);
    void cancel();

    /// Returns whether a mesh is loaded that `analyseAgain` can use.
    bool hasMesh() const;

    /// Returns the status, without `followsSettings`.
    ImportStatus status() const;
    /// Returns a product of the latest job made since the last call. Returns nothing of earlier or
    /// cancelled jobs.
    std::optional<Product> takeProduct();

private:
    struct Source {
        std::string name; ///< file name, or the name given
        Mesh mesh;
        UnitSource unit = UnitSource::unknown;
        std::string notes = {}; ///< on the file; may be empty
        HoldableParts parts = {};
        std::vector<std::string> groups = {}; ///< `namesOfGroups` of the parts
    };
    struct Job {
        std::filesystem::path file;
        std::shared_ptr<const Source> source; ///< null: read `file`
        ImportSettings settings;
        std::atomic<bool> cancelled{false};
        bool isFetched = false; ///< one of its products was fetched
    };
    enum class Finish { preview, whole };

    void start(std::shared_ptr<Job> job);

    // Called on the worker.
    void work(const Job& job);
    Result<void> make(const Job& job);
    Result<void> makeFromMesh(const Job& job, const Source& source);
    Result<void> makeFinished(const Job& job);
    void report(const Job& job, double progress, std::string_view step);
    void deliver(const Job& job, ModalObject object, const UnitGuess& unit, Finish finish);
    void fail(const Job& job, const std::string& sentence);

    mutable std::mutex mutex;
    std::shared_ptr<Job> current;       ///< the latest job
    std::shared_ptr<const Source> mesh; ///< mesh of the latest job that had one
    ImportStatus shown;
    RemainingTime remaining; ///< of the whole analysis
    std::optional<Product> product;
    WorkThread worker; ///< last, so that it ends first
};

} // namespace idiophone
