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
    delete std::exchange(current, player.release());
    delete std::exchange(fading, nullptr);
    controllers = {pedalUp, wheelAtRest};
}

void PlayerCrossfade::changeTo(Player* next, const ParameterValues& values) noexcept {
    if (next == nullptr)
        return;
    Player* previous = std::exchange(current, next);
    if (fading != nullptr || previous == nullptr || previous->silent()) {
        handoff.retire(previous);
    } else {
        fading = previous;
        fadePosition = 0;
        fadingValues = lastValues;
    }
    current->process({}, controllers, values);
}

void PlayerCrossfade::process(std::span<float> output,
                              std::span<const MidiEvent> events,
                              const ParameterValues& values) noexcept {
    followControllers(events);
    if (current == nullptr)
        std::ranges::fill(output, 0.0f);
    else
        current->process(output, events, values);
    if (fading != nullptr)
        addFading(output);
    lastValues = values;
}

void PlayerCrossfade::followControllers(std::span<const MidiEvent> events) noexcept {
    constexpr std::uint8_t sustain = 64, resetControllers = 121;
    for (const auto& event : events) {
        const int kind = event.bytes[0] & 0xf0;
        if (kind == 0xb0 && event.bytes[1] == sustain)
            controllers[0].bytes = event.bytes;
        else if (kind == 0xe0)
            controllers[1].bytes = event.bytes;
        else if (kind == 0xb0 && event.bytes[1] == resetControllers)
            controllers = {pedalUp, wheelAtRest};
    }
}

void PlayerCrossfade::addFading(std::span<float> output) noexcept {
    const auto length =
        static_cast<int>(std::lround(fadeSeconds * fading->synthesiser().sampleRateHz()));
    const auto count = std::min(output.size(), static_cast<std::size_t>(length - fadePosition));
    const auto old = std::span(fadingOutput).first(count);
    fading->process(old, {}, fadingValues);
    for (std::size_t i = 0; i < count; ++i, ++fadePosition) {
        const double gain = (1 + std::cos(std::numbers::pi * fadePosition / length)) / 2;
        output[i] += static_cast<float>(gain) * old[i];
    }
    if (fadePosition == length)
        handoff.retire(std::exchange(fading, nullptr));
}

void PlayerCrossfade::reset() noexcept {
    handoff.retire(std::exchange(fading, nullptr));
    if (current != nullptr)
        current->reset();
    controllers = {pedalUp, wheelAtRest};
}

} // namespace idiophone
