#include "Sampling/SampleFigures.h"

#include "AudioFiles/AudioFileReader.h"
#include "Sampling/LoudnessMeter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace idiophone {
namespace {

Result<SampleFigures> figuresOf(const std::filesystem::path& file) {
    auto sound = readChannels(file);
    if (!sound)
        return tl::unexpected(sound.error());
    const auto channels = static_cast<std::size_t>(sound->channelCount);
    SampleFigures figures;
    figures.seconds = static_cast<double>(sound->samples.size() / channels) / sound->sampleRateHz;
    double peak = 0;
    for (const float sample : sound->samples)
        peak = std::max(peak, std::abs(static_cast<double>(sample)));
    figures.peakDecibels = 20 * std::log10(peak);
    // Silence behind a short sound gives it the 400 ms that loudness takes.
    const auto rate = static_cast<int>(sound->sampleRateHz);
    sound->samples.resize(sound->samples.size() + channels * static_cast<std::size_t>(rate) / 2);
    figures.loudestMomentLufs = loudestMomentLufs(sound->samples, sound->channelCount, rate);
    return figures;
}

} // namespace

Result<std::vector<SampleFigures>> figuresOf(std::span<const SampleJob> jobs,
                                             const WorkControl& control) {
    std::vector<SampleFigures> all;
    for (const auto& job : jobs) {
        if (control.isCancelled())
            return cancellation();
        const auto figures = figuresOf(job.file);
        if (!figures)
            return tl::unexpected(figures.error());
        all.push_back(*figures);
    }
    return all;
}

} // namespace idiophone
