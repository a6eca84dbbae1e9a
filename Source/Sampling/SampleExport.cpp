#include "Sampling/SampleExport.h"

#include "AudioFiles/AudioFileWriter.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"
#include "Object/WorkTeam.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <juce_audio_basics/juce_audio_basics.h>
#include <mutex>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

namespace idiophone {
namespace {

constexpr double attackSeconds = 0.25; // struck objects are loudest before
constexpr double attackShare = 0.02;   // of the progress

/// Handles items on the team. Returns the error of the first item that failed. The owner's thread
/// reports progress.
Result<void> shareWork(WorkTeam& team,
                       std::size_t count,
                       const WorkControl& control,
                       const std::function<Result<void>(std::size_t)>& handle) {
    std::mutex turn;
    std::optional<std::pair<std::size_t, Error>> first;
    std::atomic<std::size_t> done{0};
    std::atomic<bool> hasFailed{false};
    team.runAll(count, [&](std::size_t item, std::size_t thread) {
        if (hasFailed)
            return;
        if (const auto result = handle(item); !result) {
            const std::scoped_lock lock(turn);
            hasFailed = true;
            if (!first || item < first->first)
                first.emplace(item, result.error());
        }
        const auto finished = ++done;
        if (thread == 0)
            control.report(static_cast<double>(finished) / static_cast<double>(count),
                           std::to_string(finished) + " of " + std::to_string(count));
    });
    if (first)
        return tl::unexpected(first->second);
    return {};
}

/// Returns the gain at which the loudest velocity's attacks reach the headroom, in tenths of a
/// decibel.
Result<double> gainFor(const SampledInstrument& sampled,
                       std::span<const SampleJob> jobs,
                       WorkTeam& team,
                       const WorkControl& control) {
    int velocity = 0;
    for (const auto& job : jobs)
        velocity = std::max(velocity, job.strike.velocity());
    std::vector<const SampledStrike*> loudest;
    for (const auto& job : jobs)
        if (job.strike.velocity() == velocity && job.strike.turn == jobs.front().strike.turn)
            loudest.push_back(&job.strike);
    std::vector<float> peaks(loudest.size());
    const auto done = shareWork(team, loudest.size(), control, [&](std::size_t item) {
        return sampleStrike(sampled, *loudest[item], headroomDecibels, attackSeconds, control)
            .map([&](const StereoSamples& attack) { peaks[item] = attack.peak(); });
    });
    if (!done)
        return tl::unexpected(done.error());
    const double peak = static_cast<double>(std::ranges::max(peaks));
    if (peak == 0)
        return failure("nothing sounds");
    return std::floor(10 * (headroomDecibels - 20 * std::log10(peak))) / 10;
}

/// Returns the slot that the jobs strike by hand, or 0 if they strike keys.
std::size_t slotOf(std::span<const SampleJob> jobs) {
    const auto* surface = std::get_if<SurfaceStrike>(&jobs.front().strike.by);
    return surface != nullptr ? surface->slot : 0;
}

/// Writes the record of the settings. Fails if the folder has a different one.
Result<void> keepRecord(const SampledInstrument& sampled,
                        std::size_t slot,
                        const SampleExportSettings& settings,
                        double gainDecibels) {
    auto preset = sampled.preset;
    preset.parameters = sampled.values;
    nlohmann::ordered_json record{{"format", "idiophone-samples"},
                                  {"sample_rate_hz", sampled.sampleRateHz},
                                  {"bit_depth", settings.bitDepth},
                                  {"gain_db", gainDecibels},
                                  {"tail_db", settings.tailDecibels},
                                  {"longest_s", settings.longestSeconds},
                                  {"preset", nlohmann::ordered_json::parse(encodePreset(preset))}};
    if (slot > 0)
        record["slot"] = slot;
    if (sampled.tuning != KeyTuning())
        record["tuning"] = {{"semitones_from_equal", sampled.tuning.semitonesFromEqual},
                            {"unmapped", sampled.tuning.unmapped.to_string()}};
    const auto file = settings.folder / sampleRecordName;
    const auto text = record.dump(4) + "\n";
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return writeTextFile(file, text);
    const auto kept = readTextFile(file);
    if (!kept)
        return tl::unexpected(kept.error());
    if (*kept != text)
        return failure(nameOf(settings.folder) +
                       ": it holds samples with other settings; choose another folder");
    return {};
}

/// Returns whether the samples clip.
Result<bool> writeSample(const StereoSamples& samples,
                         const std::filesystem::path& file,
                         double sampleRateHz,
                         int bitDepth) {
    auto writer = AudioFileWriter::create(file, static_cast<int>(sampleRateHz), 2, bitDepth);
    if (!writer)
        return tl::unexpected(writer.error());
    const std::array<const float*, 2> channels{samples.left.data(), samples.right.data()};
    return (*writer)
        ->write(channels.data(), static_cast<int>(samples.left.size()))
        .and_then([&] { return (*writer)->finish(); })
        .map([&] { return samples.peak() > 1; });
}

} // namespace

Result<ExportedSamples> exportSamples(const SampledInstrument& sampled,
                                      std::span<const SampleJob> jobs,
                                      const SampleExportSettings& settings,
                                      WorkTeam& team,
                                      const WorkControl& control) {
    const juce::ScopedNoDenormals asInTheAudioCallback; // on the team's threads, too
    ExportedSamples exported;
    const auto measuring = control.part(0, attackShare), rendering = control.part(attackShare, 1);
    const auto gain = settings.gainDecibels ? Result<double>(*settings.gainDecibels)
                                            : gainFor(sampled, jobs, team, measuring);
    if (!gain)
        return tl::unexpected(gain.error());
    exported.gainDecibels = *gain;
    if (auto kept = keepRecord(sampled, slotOf(jobs), settings, *gain); !kept)
        return tl::unexpected(kept.error());
    std::vector<const SampleJob*> missing;
    std::error_code ignored;
    for (const auto& job : jobs)
        if (!std::filesystem::exists(job.file, ignored))
            missing.push_back(&job);
    exported.rendered = missing.size();
    const auto factor = static_cast<float>(std::pow(10, *gain / 20));
    std::atomic<std::size_t> clipped{0};
    const auto render = [&](std::size_t item) -> Result<void> {
        auto samples = sampleStrike(sampled, missing[item]->strike, settings.tailDecibels,
                                    settings.longestSeconds, control);
        if (!samples)
            return tl::unexpected(samples.error());
        samples->cutTail(settings.tailDecibels, sampled.sampleRateHz);
        for (auto* channel : {&samples->left, &samples->right})
            for (float& sample : *channel)
                sample *= factor;
        return writeSample(*samples, missing[item]->file, sampled.sampleRateHz, settings.bitDepth)
            .map([&](bool clips) { clipped += clips ? 1 : 0; });
    };
    return shareWork(team, missing.size(), rendering, render).map([&] {
        exported.clipped = clipped;
        return exported;
    });
}

} // namespace idiophone
