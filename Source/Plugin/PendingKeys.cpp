#include "Plugin/PendingKeys.h"

#include "Instrument/MidiControllers.h"

#include <algorithm>
#include <utility>

namespace idiophone {

bool PendingKeys::isProgramChange(std::span<const std::uint8_t> message) const noexcept {
    return message.size() >= 2 && (message[0] & 0xf0) == 0xc0 && (message[1] & 0x7f) < programs;
}

void PendingKeys::follow(std::span<const MidiEvent> messages) noexcept {
    for (const auto& event : messages) {
        const int kind = event.bytes[0] & 0xf0;
        if (isProgramChange(event.bytes)) {
            program = event.bytes[1] & 0x7f;
            isPending = true;
            count = 0;
        }
        if (!isPending)
            continue;
        if (kind == 0x80 || kind == 0x90)
            release(event);
        if (event.isNoteOn() && count < capacity) {
            noteOns[count] = event;
            noteOns[count++].sampleOffset = 0;
        }
        const int controller = kind == 0xb0 ? event.bytes[1] & 0x7f : 0;
        if (controller == midi::allSoundOff || controller >= midi::allNotesOff)
            count = 0;
    }
}

void PendingKeys::release(const MidiEvent& event) noexcept {
    const auto kept =
        std::remove_if(noteOns.begin(), noteOns.begin() + count, [&](const auto& noteOn) {
            const int differing = noteOn.bytes[0] ^ event.bytes[0];
            return (differing & 0x0f) == 0 && noteOn.bytes[1] == event.bytes[1];
        });
    count = static_cast<std::size_t>(kept - noteOns.begin());
}

std::span<const MidiEvent> PendingKeys::take() noexcept {
    isPending = false;
    return std::span(noteOns).first(std::exchange(count, 0));
}

} // namespace idiophone
