#include "Plugin/PlayerCrossfade.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone {

PlayerCrossfade::~PlayerCrossfade() {
    delete current;
    delete fading;
}

void PlayerCrossfade::install(std::unique_ptr<Player> player) {
    if (player != nullptr && current != nullptr)
        player->bend().takeSetupOf(current->bend());
    delete std::exchange(current, player.release());
    delete std::exchange(fading, nullptr);
}

void PlayerCrossfade::changeTo(Player* next,
                               const ParameterValues& former,
                               float levelBefore) noexcept {
    if (next == nullptr)
        return;
    Player* previous = std::exchange(current, next);
    if (previous != nullptr)
        current->takeControllersOf(*previous);
    if (fading != nullptr) {
        fadingLevel *= levelBefore;
        handoff.retire(previous);
    } else if (previous == nullptr || previous->silent()) {
        handoff.retire(previous);
    } else {
        fading = previous;
        fadePosition = 0;
        fadingLevel = levelBefore;
        fadingValues = former;
    }
}

void PlayerCrossfade::process(std::span<const StereoSpan> outputs,
                              std::span<const MidiEvent> events,
                              const ParameterValues& values,
                              std::span<const float> input) noexcept {
    if (current != nullptr) {
        current->process(outputs, events, values, input);
    } else {
        for (const auto& output : outputs) {
            std::ranges::fill(output.left, 0.0f);
            std::ranges::fill(output.right, 0.0f);
        }
    }
    if (fading != nullptr)
        addFading(outputs);
}

void PlayerCrossfade::addFading(std::span<const StereoSpan> outputs) noexcept {
    const auto length =
        static_cast<int>(std::lround(fadeSeconds * fading->synthesiser().sampleRateHz()));
    const auto count =
        std::min(outputs.front().size(), static_cast<std::size_t>(length - fadePosition));
    const auto connected = connectedOutputs(outputs);
    const auto old = fadingMemory.first(count, connected);
    fading->process(old, {}, fadingValues);
    for (std::size_t i = 0; i < count; ++i, ++fadePosition) {
        const float gain =
            fadingLevel *
            static_cast<float>((1 + std::cos(std::numbers::pi * fadePosition / length)) / 2);
        for (std::size_t output = 0; output < outputs.size(); ++output)
            if (connected[output]) {
                outputs[output].left[i] += gain * old[output].left[i];
                outputs[output].right[i] += gain * old[output].right[i];
            }
    }
    if (fadePosition == length)
        handoff.retire(std::exchange(fading, nullptr));
}

void PlayerCrossfade::reset() noexcept {
    handoff.retire(std::exchange(fading, nullptr));
    if (current != nullptr)
        current->reset();
}

} // namespace idiophone
