#include "Plugin/SoundRecorder.h"
#include "Object/FileBytes.h"

#include <array>
#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

namespace idiophone {

Result<void> SoundRecorder::start(std::shared_ptr<const RollingSound> from,
                                  const std::filesystem::path& to) {
    stop();
    auto made =
        AudioFileWriter::create(to, static_cast<int>(std::lround(from->sampleRateHz())), 2, 32);
    if (!made)
        return tl::unexpected(made.error());
    writer = std::move(*made);
    sound = std::move(from);
    file = to;
    first = next = sound->end();
    hasLost = stops = false;
    shown.isRunning = true;
    shown.seconds = 0;
    try {
        thread = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        shown.isRunning = false;
        writer.reset();
        return failure("this machine has no thread left for it");
    }
    return {};
}

void SoundRecorder::stop() {
    {
        const std::scoped_lock lock(mutex);
        stops = true;
    }
    wake.notify_all();
    if (thread.joinable())
        thread.join();
}

RecorderView::Recording SoundRecorder::state() const {
    const std::scoped_lock lock(mutex);
    return shown;
}

std::string SoundRecorder::takeError() {
    const std::scoped_lock lock(mutex);
    return std::exchange(error, {});
}

void SoundRecorder::run() {
    Result<void> written;
    std::string reason;
    try {
        for (bool isLast = false; !isLast && written && reason.empty();) {
            isLast = waitForStop();
            const bool isRetired = sound->isRetired(); // asked first: then no frame follows
            written = writeNext();
            if (!isLast)
                reason = isRetired ? "the sample rate has changed" : reasonToEnd();
        }
        if (written)
            written = writer->finish();
    } catch (const std::exception& fault) { // such as a lack of memory
        written = failure(nameOf(file) + ": " + fault.what());
    }
    writer.reset();
    end(written, reason);
}

/// Waits a while. Returns whether to stop.
bool SoundRecorder::waitForStop() {
    constexpr std::chrono::milliseconds pause(100);
    std::unique_lock lock(mutex);
    return wake.wait_for(lock, pause, [this] { return stops; });
}

Result<void> SoundRecorder::writeNext() {
    const auto piece = sound->read(next);
    hasLost = piece.first > next;
    if (hasLost || piece.left.empty())
        return {};
    const std::array<const float*, 2> channels{piece.left.data(), piece.right.data()};
    auto written = writer->write(channels.data(), static_cast<int>(piece.left.size()));
    next = piece.end();
    const std::scoped_lock lock(mutex);
    shown.seconds = static_cast<double>(next - first) / sound->sampleRateHz();
    return written;
}

/// Returns why no more can be recorded, or nothing.
std::string SoundRecorder::reasonToEnd() const {
    if (hasLost)
        return "the disk is too slow";
    std::error_code unknown;
    const auto disk = std::filesystem::space(file.parent_path(), unknown);
    return !unknown && disk.available < freeBytes ? "the disk is almost full" : "";
}

void SoundRecorder::end(const Result<void>& finished, const std::string& reason) {
    const std::scoped_lock lock(mutex);
    shown.isRunning = false;
    if (!finished)
        error = "The recording is lost: " + finished.error().message + ".";
    else
        shown.file = file;
    if (finished && !reason.empty())
        error = "The recording has ended, because " + reason + ".";
}

} // namespace idiophone
