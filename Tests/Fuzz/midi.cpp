// Standard MIDI Files, as `idiophone render` plays them.
#include "Console/MidiSong.h"
#include "Fuzz/FuzzTarget.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    const auto song = readMidiSong(scratchFile(bytes, "fuzz.mid"));
    if (!song)
        return claimSentence(song.error());
    claim(std::ranges::any_of(*song, &SongEvent::isNoteOn), "a song has notes");
    claim(std::ranges::is_sorted(*song, {}, &SongEvent::seconds), "events are in order of time");
    for (const auto& event : *song) {
        claim(event.seconds >= 0 && event.seconds <= 36000, "a song lasts 10 hours at most");
        claim(event.bytes[0] >= 0x80 && event.bytes[0] < 0xf0, "events are channel messages");
        claim(event.bytes[1] < 0x80 && event.bytes[2] < 0x80, "data bytes have seven bits");
    }
}
