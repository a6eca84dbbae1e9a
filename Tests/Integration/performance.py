"""Notes at whole samples, and comparisons of two renders."""
import dataclasses
import math

import mido
import numpy

PRESET = "Rosewood Xylophone"
SAMPLE_RATE = 48000
# Notes are a quarter of a sample late, so that hosts find the intended sample whether they round or
# truncate times in seconds.
SAFELY_INSIDE = 0.25
IDENTICAL = -math.inf  # for assert_equal_sound


@dataclasses.dataclass(frozen=True)
class Note:
    start: int  # sample
    end: int  # sample
    key: int
    velocity: int


def seconds(sample):
    return (sample + SAFELY_INSIDE) / SAMPLE_RATE


class Performance:
    """Notes in the order of their strikes. Simultaneous notes keep the file's order, because each
    strike draws a random position on the bar."""

    def __init__(self, notes):
        self.notes = sorted(notes, key=lambda note: note.start)

    @classmethod
    def from_midi_file(cls, path):
        """Returns the notes of a MIDI file. Every event must lie on a whole sample at 48 kHz."""
        file, now, microseconds_per_quarter = mido.MidiFile(path), 0, 500_000
        sounding, notes = {}, []
        for message in mido.merge_tracks(file.tracks):
            step = message.time * microseconds_per_quarter * SAMPLE_RATE
            assert step % (file.ticks_per_beat * 1_000_000) == 0, "an event between two samples"
            now += step // (file.ticks_per_beat * 1_000_000)
            if message.type == "set_tempo":
                microseconds_per_quarter = message.tempo
            elif message.type == "note_on" and message.velocity > 0:
                assert message.note not in sounding, "a key struck while it is down"
                sounding[message.note] = len(notes)
                notes.append(Note(now, now, message.note, message.velocity))
            elif message.type in ("note_on", "note_off"):
                struck = sounding.pop(message.note)
                notes[struck] = dataclasses.replace(notes[struck], end=now)
        assert not sounding, "a key that never goes up"
        return cls(notes)

    @classmethod
    def scale(cls, start=0):
        """Returns eight notes over the three octaves, within a second."""
        return cls([Note(start + 5000 * i + 37, start + 5000 * i + 4037, key, 50 + 10 * i)
                    for i, key in enumerate((72, 79, 84, 88, 91, 96, 103, 108))])

    def midi_events(self):
        """Returns (sample, MIDI bytes) in time order."""
        events = [(note.start, bytes([0x90, note.key, note.velocity])) for note in self.notes]
        events += [(note.end, bytes([0x80, note.key, 0])) for note in self.notes]
        return sorted(events, key=lambda event: event[0])


def assert_sounds(audio):
    assert numpy.isfinite(audio).all(), "not every sample is a number"
    assert numpy.abs(audio).max() > 1e-3, "silence"


def level(audio):
    """Returns the mean power in decibels."""
    return 10 * math.log10(numpy.mean(numpy.square(audio, dtype=numpy.float64)))


def within(events, start, end):
    """Returns the events in [start, end), with samples counted from the start."""
    return [(sample - start, message) for sample, message in events if start <= sample < end]


def onset(audio):
    """Returns the first sample with sound in any channel."""
    assert_sounds(audio)
    return int(numpy.flatnonzero(audio.any(axis=0))[0])


def assert_equal_sound(audio, reference, decibels=-100):
    """Asserts that no sample differs by more than `decibels` relative to the reference's peak."""
    assert audio.shape == reference.shape
    assert_sounds(reference)
    difference = numpy.abs(audio.astype(numpy.float64) - reference).max()
    relative = difference / numpy.abs(reference).max()
    level = 20 * math.log10(relative) if relative > 0 else -math.inf
    print(f"largest difference {level:.1f} dB of the peak")
    assert level <= decibels, f"the largest difference is {level:.1f} dB of the peak"


def strongest_hz(audio):
    """Returns the frequency of the highest peak in the spectrum."""
    spectrum = numpy.abs(numpy.fft.rfft(audio.mean(axis=0)))
    return numpy.argmax(spectrum) * SAMPLE_RATE / audio.shape[1]
