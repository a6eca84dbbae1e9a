// Makes objects from files on a thread of its own: reading, a preview, the whole analysis. It knows
// nothing of the processor, which comes for what is finished.
#pragma once

#include "Editor/WorkshopView.h"
#include "Geometry/LengthUnit.h"
#include "Geometry/Mesh.h"
#include "Object/ModalObject.h"
#include "Object/Result.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace idiophone {

/// Threads: every member function is for one side, which is any thread but the audio thread, one at
/// a time (the message thread). The worker runs from the first job to the destructor. They share a
/// job on its way in, a status, and a product on its way out, under `mutex`, which either holds for
/// no longer than a copy takes; the wish to cancel is an atomic flag of the job. A product that
/// nobody fetches is replaced by the next and stops nothing.
class ObjectWorkshop {
public:
    /// What became of a job: first the preview, if there is one, then the object itself.
    struct Product {
        std::shared_ptr<const ModalObject> object;
        std::string objectName; ///< of its own among all objects, for states and the library
        bool isPreview = false;
        bool isFirst = false;   ///< of its job
        bool isNewFile = false; ///< rather than another analysis of what was there
    };

    ObjectWorkshop() = default;
    ObjectWorkshop(const ObjectWorkshop&) = delete;
    ObjectWorkshop& operator=(const ObjectWorkshop&) = delete;
    /// Cancels, and waits the moment that takes.
    ~ObjectWorkshop();

    /// A job of its own for a file, instead of whatever is under way or waits.
    void open(const std::filesystem::path& file, const ImportSettings& settings);
    /// Another for the mesh opened last, if there is one.
    void analyseAgain(const ImportSettings& settings);
    /// Another for this mesh, which goes by that name.
    void analyse(Mesh meshMetres, const std::string& name, const ImportSettings& settings);
    void cancel();

    /// Whether the mesh of a file opened before is there to be analysed again.
    bool hasMesh() const;

    /// But for `followsSettings`.
    ImportStatus status() const;
    /// What the job asked for last has made since this was asked; nothing of those before it, or
    /// once cancelled.
    std::optional<Product> takeProduct();

private:
    struct Source {
        std::string name; ///< of the file
        Mesh mesh;
        bool isMetres = false; ///< or in units of the file
    };
    struct Job {
        std::filesystem::path file;
        std::shared_ptr<const Source> source; ///< or nothing, for the file to be read
        ImportSettings settings;
        std::atomic<bool> cancelled{false};
        bool isFetched = false; ///< some product of it
    };
    enum class Finish { preview, whole };

    void start(std::shared_ptr<Job> job);

    // The worker's.
    void run();
    Result<void> make(const Job& job);
    Result<void> makeFromMesh(const Job& job, const Source& source);
    Result<void> makeFromModal(const Job& job);
    static UnitGuess unitOf(const Source& source, const ImportSettings& settings);
    void report(const Job& job, double progress, std::string_view step);
    void deliver(const Job& job, ModalObject object, const UnitGuess& unit, Finish finish);
    void fail(const Job& job, const std::string& sentence);

    mutable std::mutex mutex;
    std::condition_variable wake;
    std::shared_ptr<Job> waiting, current; ///< current: asked for last
    std::shared_ptr<const Source> mesh;    ///< read last
    ImportStatus shown;
    std::optional<Product> product;
    bool ending = false;
    std::thread worker;
};

} // namespace idiophone
