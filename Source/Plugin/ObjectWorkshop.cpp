#include "Plugin/ObjectWorkshop.h"

#include "Analysis/BodyModel.h"
#include "Analysis/FewerShapes.h"
#include "Analysis/ModalAnalysis.h"
#include "Editor/Utf8.h"
#include "Geometry/LengthUnit.h"
#include "Geometry/MeshReader.h"
#include "Gltf/ObjectFile.h"
#include "Mesh/ObjectMesh.h"
#include "Plugin/FileKinds.h"
#include "Plugin/FinishedObject.h"
#include "Plugin/ImportChoices.h"
#include "Plugin/ImportSummary.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <system_error>
#include <utility>

namespace idiophone {
namespace {

// Shares of the progress bar.
constexpr double readShare = 0.03, previewShare = 0.12;

/// Maximum shapes times modes that an object keeps: 4 MB in half precision in every project.
constexpr std::size_t maximumShapes = 700'000, minimumRows = 300;

} // namespace

ObjectWorkshop::~ObjectWorkshop() {
    cancel();
}

void ObjectWorkshop::open(const std::filesystem::path& file, const ImportSettings& settings) {
    auto job = std::make_shared<Job>();
    job->file = file;
    job->settings = settings;
    start(job);
}

void ObjectWorkshop::analyseAgain(const ImportSettings& settings) {
    auto job = std::make_shared<Job>();
    {
        const std::scoped_lock lock(mutex);
        job->source = mesh;
    }
    job->settings = settings;
    if (job->source != nullptr)
        start(job);
}

void ObjectWorkshop::analyse(const ModalObject& object, const ImportSettings& settings) {
    auto job = std::make_shared<Job>();
    job->source = std::make_shared<const Source>(
        Source{.name = object.name.empty() ? "Object" : object.name,
               .mesh = objectMesh(object),
               .unit = UnitSource::object,
               .parts = {.clampedVertices = object.clampedVertices}});
    job->settings = settings;
    start(job);
}

void ObjectWorkshop::start(std::shared_ptr<Job> job) {
    ImportStatus status;
    status.stage = ImportStatus::Stage::working;
    status.fileName = job->source != nullptr ? job->source->name : fileNameOf(job->file);
    status.settings = job->settings;
    status.step = "Waiting";
    auto formerMesh = job->source;
    std::optional<Product> former; // destroyed without the mutex, like `formerMesh`
    {
        const std::scoped_lock lock(mutex);
        if (current != nullptr)
            current->cancelled = true;
        former.swap(product);
        mesh.swap(formerMesh);
        shown = std::move(status);
        remaining = {};
        current = job;
    }
    try {
        worker.start([this, job = std::move(job)] { work(*job); });
    } catch (const std::system_error& fault) {
        shown.stage = ImportStatus::Stage::failed; // without a lock, because no worker runs
        shown.error = sentenceOf(fault, shown.fileName);
        shown.step.clear();
    }
}

void ObjectWorkshop::cancel() {
    std::optional<Product> former; // destroyed without the mutex
    const std::scoped_lock lock(mutex);
    former.swap(product);
    if (current == nullptr || !shown.isWorking())
        return;
    current->cancelled = true;
    shown.stage = ImportStatus::Stage::cancelled;
    shown.step.clear();
}

bool ObjectWorkshop::hasMesh() const {
    const std::scoped_lock lock(mutex);
    return mesh != nullptr;
}

ImportStatus ObjectWorkshop::status() const {
    const std::scoped_lock lock(mutex);
    auto status = shown;
    if (mesh != nullptr) {
        status.groups = mesh->groups;
        status.wasHeld = !mesh->parts.clampedVertices.empty();
    }
    if (status.isWorking())
        status.secondsLeft = remaining.seconds(std::chrono::steady_clock::now());
    return status;
}

std::optional<ObjectWorkshop::Product> ObjectWorkshop::takeProduct() {
    const std::scoped_lock lock(mutex);
    if (product)
        current->isFetched = true;
    return std::exchange(product, std::nullopt);
}

// The worker thread.

void ObjectWorkshop::work(const Job& job) {
    if (job.cancelled)
        return;
    try {
        if (const auto made = make(job); !made)
            fail(job, withoutFolder(made.error().message, job.file));
    } catch (const std::exception& fault) {
        fail(job, fileNameOf(job.file) + ": it cannot be made an object: " + fault.what() + ".");
    }
}

Result<void> ObjectWorkshop::make(const Job& job) {
    if (job.source != nullptr)
        return makeFromMesh(job, *job.source);
    if (matches(job.file, modalFiles) || matches(job.file, recordingFiles) ||
        hasModalModel(job.file))
        return makeFinished(job);
    report(job, 0, "Reading");
    auto read = readMeshFile(job.file);
    if (!read)
        return tl::unexpected(read.error());
    Source made{.name = fileNameOf(job.file),
                .mesh = std::move(read->mesh),
                .unit = read->isInMetres ? UnitSource::format : UnitSource::unknown,
                .notes = std::move(read->notes),
                .parts = {.groups = std::move(read->groups)}};
    made.groups = namesOfGroups(made.parts, made.mesh);
    const auto source = std::make_shared<const Source>(std::move(made));
    {
        const std::scoped_lock lock(mutex);
        if (!job.cancelled)
            mesh = source; // `start` has left it empty
    }
    return makeFromMesh(job, *source);
}

Result<void> ObjectWorkshop::makeFromMesh(const Job& job, const Source& source) {
    const auto refuse = [&](const Error& error) {
        return failure(source.name + ": " + joinedSentences({error.message, source.notes}));
    };
    const auto choices = choicesOf(job.settings);
    if (!choices)
        return refuse(choices.error());
    const auto unit = unitOf(source.mesh, source.unit, job.settings);
    Mesh metres = source.mesh;
    metres.vertices *= unit.unit.metresPerUnit;
    auto support = supportOf(job.settings.held, source.parts, metres);
    if (!support)
        return refuse(support.error());
    const AnalysisSettings settings{.name =
                                        textOf(pathOf(fromUtf8(source.name)).stem()).toStdString(),
                                    .source = source.name,
                                    .material = choices->material,
                                    .method = choices->method,
                                    .thicknessMetres = job.settings.thicknessMetres,
                                    .support = std::move(*support)};
    const auto control = [&](double from, double to, std::string_view prefix) {
        return WorkControl{.progress =
                               [=, this, &job](double share, std::string_view step) {
                                   report(job, from + (to - from) * share,
                                          std::string(prefix) + std::string(step));
                               },
                           .cancelled = &job.cancelled};
    };
    auto preview = analysePreview(metres, settings, control(readShare, previewShare, "Preview: "));
    const auto addNotes = [&](ModalObject& object) {
        object.provenance.notes = joinedSentences({source.notes, object.provenance.notes});
    };
    if (preview)
        addNotes(*preview);
    if (preview)
        deliver(job, withFewerShapes(std::move(*preview), minimumRows), unit, Finish::preview);
    if (job.cancelled)
        return {};
    {
        const std::scoped_lock lock(mutex);
        remaining.start(std::chrono::steady_clock::now());
    }
    auto object = idiophone::analyse(metres, settings, control(previewShare, 1, ""));
    if (!object)
        return refuse(
            {joinedSentences({object.error().message, unit.isSure ? "" : unit.sentence})});
    addNotes(*object);
    const auto rows = std::max(minimumRows, maximumShapes / object->modeCount());
    deliver(job, withFewerShapes(std::move(*object), rows), unit, Finish::whole);
    return {};
}

Result<void> ObjectWorkshop::makeFinished(const Job& job) {
    auto object = finishedObject(
        job.file,
        {.progress = [&](double share, std::string_view step) { report(job, share, step); },
         .cancelled = &job.cancelled});
    if (!object)
        return tl::unexpected(object.error());
    deliver(job, std::move(*object), {}, Finish::whole);
    return {};
}

void ObjectWorkshop::report(const Job& job, double progress, std::string_view step) {
    const std::scoped_lock lock(mutex);
    if (current.get() != &job || job.cancelled)
        return;
    shown.progress = std::max(shown.progress, progress);
    shown.step = step;
    remaining.report((shown.progress - previewShare) / (1 - previewShare),
                     std::chrono::steady_clock::now());
}

void ObjectWorkshop::deliver(const Job& job,
                             ModalObject object,
                             const UnitGuess& unit,
                             Finish finish) {
    const bool isPreview = finish == Finish::preview;
    auto name = uniqueName(object);
    const auto shared = std::make_shared<const ModalObject>(std::move(object));
    auto summary = summaryOf(*shared);
    auto notes = notesOf(*shared, unit.sentence);
    std::optional<Product> made = Product{.object = shared,
                                          .objectName = std::move(name),
                                          .isPreview = isPreview,
                                          .isNewFile = job.source == nullptr};
    const std::scoped_lock lock(mutex); // released before the replaced product is destroyed
    if (current.get() != &job || job.cancelled)
        return;
    shown.stage = isPreview ? ImportStatus::Stage::previewed : ImportStatus::Stage::done;
    shown.summary = std::move(summary);
    shown.sidesMetres = sidesMetresOf(*shared);
    shown.massKg = shared->mass.massKg;
    shown.notes = std::move(notes);
    shown.unit = unit.unit.symbol;
    shown.method = shared->method;
    if (!isPreview) {
        shown.progress = 1;
        shown.step.clear();
    }
    made->isFirst = !current->isFetched;
    product.swap(made);
}

void ObjectWorkshop::fail(const Job& job, const std::string& sentence) {
    const std::scoped_lock lock(mutex);
    if (current.get() != &job || job.cancelled)
        return;
    shown.stage = ImportStatus::Stage::failed;
    shown.error = sentence;
    shown.step.clear();
}

} // namespace idiophone
