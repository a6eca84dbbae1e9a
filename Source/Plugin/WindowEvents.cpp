#include "Plugin/WindowEvents.h"

#include "Instrument/MidiControllers.h"

namespace idiophone {

const MidiEvent WindowEvents::allSoundOff{.sampleOffset = 0, .bytes = {0xb0, midi::allSoundOff, 0}};

bool WindowEvent::releases() const noexcept {
    if (const auto* note = std::get_if<MidiEvent>(&played))
        return note->isNoteOff();
    if (const auto* strike = std::get_if<SurfaceStrike>(&played))
        return strike->velocity <= 0;
    return !(std::get_if<SurfaceTouch>(&played)->pressure > 0);
}

bool WindowEvents::push(const WindowEvent& event) noexcept {
    if (queue.push(event))
        return true;
    if (event.releases())
        releaseLost = true;
    return false;
}

bool WindowEvents::pushNote(int note, int velocity) noexcept {
    return push({.instrument = 0, .played = noteEvent(note, velocity)});
}

MidiEvent WindowEvents::noteEvent(int note, int velocity) noexcept {
    const bool isRelease = velocity <= 0;
    return {.sampleOffset = 0,
            .bytes = {static_cast<std::uint8_t>(isRelease ? 0x80 : 0x90),
                      static_cast<std::uint8_t>(note & 127),
                      static_cast<std::uint8_t>(isRelease ? 0 : velocity & 127)}};
}

void WindowEvents::playHand(const WindowEvent& event, Player& player) noexcept {
    if (player.instrument().serialNumber() != event.instrument)
        return;
    if (const auto* strike = std::get_if<SurfaceStrike>(&event.played))
        player.strikeSurface(*strike);
    else
        player.scrapeSurface(*std::get_if<SurfaceTouch>(&event.played));
}

void WindowEvents::clear() noexcept {
    queue.consume_all([](const WindowEvent&) {});
    releaseLost = silenceAsked = false;
    held.reset();
}

} // namespace idiophone
