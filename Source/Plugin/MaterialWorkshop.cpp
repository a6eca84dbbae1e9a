#include "Plugin/MaterialWorkshop.h"

#include "AudioFiles/AudioFileReader.h"
#include "Plugin/FileKinds.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace idiophone {
namespace {

using FitStage = MaterialFitStatus::Stage;
using Clock = std::chrono::steady_clock;

} // namespace

void MaterialWorkshop::start(Task task) {
    auto job = std::make_shared<Job>();
    job->task = std::move(task);
    const auto name = fileNameOf(job->task.recording);
    {
        const std::scoped_lock lock(mutex);
        if (current != nullptr)
            current->cancelled = true;
        current = job;
        product.reset();
        shown = {.stage = FitStage::working, .step = "Waiting"};
        remaining.start(Clock::now());
    }
    try {
        worker.start([this, job = std::move(job)] { work(*job); });
    } catch (const std::system_error& fault) { // without a lock, because no worker runs
        shown = {.stage = FitStage::failed, .report = sentenceOf(fault, name)};
    }
}

void MaterialWorkshop::cancel() {
    const std::scoped_lock lock(mutex);
    product.reset();
    if (current == nullptr || shown.stage != FitStage::working)
        return;
    current->cancelled = true;
    shown = {.stage = FitStage::cancelled};
}

MaterialFitStatus MaterialWorkshop::status() const {
    const std::scoped_lock lock(mutex);
    auto status = shown;
    if (status.stage == FitStage::working)
        status.secondsLeft = remaining.seconds(Clock::now());
    return status;
}

std::optional<RecordedMaterial> MaterialWorkshop::takeProduct() {
    const std::scoped_lock lock(mutex);
    if (product)
        shown = {};
    return std::exchange(product, std::nullopt);
}

// The worker thread.

void MaterialWorkshop::work(const Job& job) {
    if (job.cancelled)
        return;
    const auto name = fileNameOf(job.task.recording);
    try {
        finish(job, withinMemory([&] { return make(job); }, name));
    } catch (const std::exception& fault) {
        finish(job, failure(name + ": no material can be made of it: " + fault.what() + "."));
    }
}

Result<RecordedMaterial> MaterialWorkshop::make(const Job& job) {
    report(job, 0, "Reading");
    const auto& file = job.task.recording;
    const auto recording = readRecording(file);
    if (!recording)
        return failure(withoutFolder(recording.error().message, file));
    const auto object = job.task.struckObject();
    if (!object)
        return tl::unexpected(object.error());
    return materialOfRecording(
        {.name = fileNameOf(file),
         .samples = recording->samples,
         .sampleRateHz = recording->sampleRateHz},
        job.task.materialName, *object,
        {.progress = [&](double share, std::string_view step) { report(job, share, step); },
         .cancelled = &job.cancelled});
}

void MaterialWorkshop::report(const Job& job, double progress, std::string_view step) {
    const std::scoped_lock lock(mutex);
    if (job.cancelled)
        return;
    shown.progress = std::max(shown.progress, progress);
    shown.step = step;
    remaining.report(shown.progress, Clock::now());
}

void MaterialWorkshop::finish(const Job& job, Result<RecordedMaterial> made) {
    const std::scoped_lock lock(mutex);
    if (job.cancelled)
        return;
    if (made)
        product = std::move(*made);
    else
        shown = {.stage = FitStage::failed, .report = made.error().message};
}

} // namespace idiophone
