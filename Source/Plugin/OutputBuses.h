// The buses on which the host hears the plugin's outputs, each behind a last stage of its own.
#pragma once

#include "Output/OutputStage.h"
#include "Plugin/OutputMemory.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// The functions that are not marked are for the audio thread and neither allocate, lock nor throw.
class OutputBuses {
public:
    /// The host's channels of each output; none if it is not connected.
    using Channels = std::array<std::span<float* const>, maximumOutputs>;

    /// [message side] Call while no callback runs. Later only the main output and these can
    /// sound. The others take no memory.
    void prepare(double sampleRateHz, OutputSet outputs);

    /// Each does for all outputs what `OutputStage` does for one.
    void reset() noexcept;
    float changeSound(const ParameterValues& values, double fadeSeconds) noexcept;
    void hush(std::size_t unanswered) noexcept;
    bool silent() const noexcept;

    /// Returns memory for a player's next `count` samples, at most `BlockPieces::maximumSamples`.
    std::span<const StereoSpan> memory(std::size_t count) noexcept {
        return rendered.first(count, connected);
    }
    /// Sends what is in this memory through the stages to the host. Outputs that were not prepared
    /// are silent. Returns false if the sound of one was not finite.
    bool process(std::span<const StereoSpan> sounds,
                 const Channels& channels,
                 const ParameterValues& values) noexcept;

    /// Returns the sum of all outputs in as many channels as the main one has, valid until the next
    /// `process`.
    std::span<const float* const> sum(const Channels& channels, std::size_t count) noexcept;

private:
    OutputSet connected{1};
    OutputSet hasSounded{1}; ///< since the last reset; the main one is always processed
    std::array<OutputStage, maximumOutputs> stages;
    OutputMemory rendered;
    std::array<std::array<float, BlockPieces::maximumSamples>, 2> summed{};
    std::array<const float*, 2> summedChannels{};
};

} // namespace idiophone
