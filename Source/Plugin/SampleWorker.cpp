#include "Plugin/SampleWorker.h"

#include "Object/WorkTeam.h"
#include "Plugin/WithinMemory.h"
#include "Sampling/SampleEstimate.h"
#include "Sampling/SampleFolder.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>

namespace idiophone {
namespace {

using SampleStage = SampleStatus::Stage;

unsigned halfOfCores() {
    return std::max(std::thread::hardware_concurrency() / 2, 1u);
}

SampleStatus notDone(const SampleOrder& order, const Error& error) {
    SampleStatus status{.folder = order.folder};
    if (isCancellation(error)) {
        status.stage = order.folder.empty() ? SampleStage::none : SampleStage::stopped;
    } else {
        status.stage = order.folder.empty() ? SampleStage::refused : SampleStage::failed;
        status.sentence = error.message;
    }
    return status;
}

} // namespace

SampleWorker::~SampleWorker() {
    stop();
}

void SampleWorker::start(SampleOrder order) {
    auto job = std::make_shared<Job>();
    job->order = std::move(order);
    {
        const std::scoped_lock lock(mutex);
        if (current != nullptr)
            current->cancelled = true;
        shown = {.stage =
                     job->order.folder.empty() ? SampleStage::estimating : SampleStage::exporting,
                 .folder = job->order.folder};
        remaining = {};
        remaining.start(std::chrono::steady_clock::now());
        current = job;
    }
    try {
        thread.start([this, job] { run(job); });
    } catch (const std::system_error& fault) {
        shown = notDone(job->order, {sentenceOf(fault, "The export") + "."}); // no thread runs
    }
}

void SampleWorker::stop() {
    const std::scoped_lock lock(mutex);
    if (current == nullptr || (shown.stage != SampleStage::estimating && !shown.isExporting()))
        return;
    current->cancelled = true;
    shown = notDone(current->order, cancellation().value());
}

SampleStatus SampleWorker::status() const {
    const std::scoped_lock lock(mutex);
    auto status = shown;
    if (status.isExporting())
        status.secondsLeft = remaining.seconds(std::chrono::steady_clock::now());
    return status;
}

// The thread.

void SampleWorker::run(const std::shared_ptr<Job>& job) {
    auto status = made(*job);
    const std::scoped_lock lock(mutex);
    if (current != job)
        return;
    if (!job->cancelled)
        shown = std::move(status);
    current.reset(); // it holds an instrument
}

SampleStatus SampleWorker::made(const Job& job) {
    try {
        const auto task = taskOf(job.order);
        if (!task)
            return notDone(job.order, task.error());
        return job.order.folder.empty() ? estimated(job, *task) : exported(job, *task);
    } catch (const std::bad_alloc&) {
        return notDone(job.order, {"The samples take more memory than this machine has."});
    } catch (const std::exception& fault) {
        return notDone(job.order,
                       {std::string("The samples cannot be made: ") + fault.what() + "."});
    }
}

SampleStatus SampleWorker::estimated(const Job& job, const SampleTask& task) {
    const auto estimate = estimateSamples(task, exportSettingsOf(job.order),
                                          {.progress = {}, .cancelled = &job.cancelled});
    if (!estimate)
        return notDone(job.order,
                       {"These strikes cannot be sampled: " + estimate.error().message + "."});
    return {.stage = SampleStage::estimated,
            .samples = estimate->samples,
            .seconds = estimate->seconds,
            .megabytes = estimate->bytes / 1e6};
}

SampleStatus SampleWorker::exported(const Job& job, const SampleTask& task) {
    WorkTeam team(halfOfCores());
    const auto made =
        exportTask(task, exportSettingsOf(job.order), team,
                   {.progress = [&](double progress, std::string_view) { report(job, progress); },
                    .cancelled = &job.cancelled});
    if (!made && isCancellation(made.error()))
        return notDone(job.order, made.error());
    if (!made)
        return notDone(job.order, {"The samples are not complete: " + made.error().message + "."});
    return {.stage = SampleStage::done,
            .samples = std::max(task.keys.size(), task.places.size()),
            .progress = 1,
            .folder = job.order.folder};
}

void SampleWorker::report(const Job& job, double progress) {
    const std::scoped_lock lock(mutex);
    if (current.get() != &job || job.cancelled)
        return;
    shown.progress = progress;
    remaining.report(progress, std::chrono::steady_clock::now());
}

} // namespace idiophone
