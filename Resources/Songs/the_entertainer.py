#!/usr/bin/env python3
"""The Entertainer, Scott Joplin, 1902: introduction and first strain with its repeat.

Our own arrangement of the 1902 score (public domain) for one xylophone of three octaves, MIDI notes
72 (C5) to 108 (C8). Run without arguments to write TheEntertainer.mid beside this file; the same
script always writes the same bytes.

The right hand stands two octaves above the score's single notes. Where the score answers in octave
chords, the lower note of the octave stays (so that the tune runs on in one register) with the
chord's inner voice under it. The left hand is the score's bass-and-chord, folded into C5..C6. The
introduction falls through three octaves in the score; here its third bar stays in the octave of the
second, doubled below as far as the instrument reaches.

Notation, one line a bar of 2/4, lengths in sixteenths:
    E6/1        a note          G5+B5/2     notes together      -/2     a rest
    C7/2>       with an accent  C7/1~       tied to the next    p mf f  how loud from here on
"""
import pathlib
import struct

QUARTER_TICKS = 240  # with 75 quarters a minute every tick is a whole sample at 44.1, 48 and 96 kHz
SIXTEENTH_TICKS = QUARTER_TICKS // 4
QUARTER_MICROSECONDS = 800_000
LOUDNESS = {"p": 70, "mf": 82, "f": 95}
ACCENT = 14

INTRODUCTION_MELODY = """
    f  D6+D7/1> E6+E7/1 C6+C7/1 A5+A6/2> B5+B6/1 G5+G6/2>
    mf D6/1> E6/1 C6/1 A5/2> B5/1 G5/2>
    mf D5+D6/1> E5+E6/1 C5+C6/1 A5/2> B5/1 A5/1 Ab5/1
    f  G5/2> -/2 G5+B5+F6+G6/2>  p D6/1 D#6/1
"""
INTRODUCTION_ACCOMPANIMENT = """
    -/8
    -/8
    -/8
    -/8
"""

FIRST_STRAIN_MELODY = """
    p  E6/1 C7/2> E6/1 C7/2> E6/1 C7/1~>
       C7/5  f E6+C7/1 F6+D7/1 F#6+D#7/1
    f  G6+E7/1 E6+C7/1 F6+D7/1 G6+E7/2> D6+B6/1 F6+D7/2>
    f  E6+C7/6>  p D6/1 D#6/1

    p  E6/1 C7/2> E6/1 C7/2> E6/1 C7/1~>
       C7/6  f A6/1 G6/1
    f  F#6/1 A6/1 C7/1 E7/2> D7/1 C7/1 A6/1
    f  B6+D7/6>  p D6/1 D#6/1

    p  E6/1 C7/2> E6/1 C7/2> E6/1 C7/1~>
       C7/5  f E6+C7/1 F6+D7/1 F#6+D#7/1
    f  G6+E7/1 E6+C7/1 F6+D7/1 G6+E7/2> D6+B6/1 F6+D7/2>
    f  E6+C7/6>  mf C7/1 D7/1

    mf G6+E7/1> C7/1 D7/1 G6+E7/2> C7/1 D7/1 C7/1
    mf A6+E7/1> C7/1 D7/1 Ab6+E7/2> C7/1 D7/1 C7/1
    f  G6+E7/1> E6+C7/1 F6+D7/1 G6+E7/2> D6+B6/1 F6+D7/2>
"""
FIRST_STRAIN_ACCOMPANIMENT = """
    p  C5/2> E5+G5/2 E5/2> G5+Bb5/2
    mf F5/2> A5+C6/2 E5/2> G5+C6/2
    mf G5/2> E5+C6/2 D5/2> F5+B5/2
    mf C5/2> E5+G5/2 G5/2> -/2

    p  C5/2> E5+G5/2 E5/2> G5+Bb5/2
    mf F5/2> A5+C6/2 E5/2> G5+C6/2
    mf D5/2> F#5+C6/2 A5/2> F#5+C6/2
    mf G5/2> F5+B5/2 D5/2> -/2

    p  C5/2> E5+G5/2 E5/2> G5+Bb5/2
    mf F5/2> A5+C6/2 E5/2> G5+C6/2
    mf G5/2> E5+C6/2 D5/2> F5+B5/2
    mf C5/2> E5+G5/2 G5/2> E5+C6/2

    mf C5/2> E5+G5/2 E5/2> G5+Bb5/2
    mf F5/2> A5+C6/2 Ab5/2> F5+C6/2
    mf G5/2> E5+C6/2 G5/2> F5+B5/2
"""

FIRST_ENDING_MELODY = """
    f  E6+C7/6>  p D6/1 D#6/1
"""
FIRST_ENDING_ACCOMPANIMENT = """
    mf C5/2> E5+G5/2 G5/2> -/2
"""
SECOND_ENDING_MELODY = """
    f  E6+C7/4> E6+C7/2> -/2
"""
SECOND_ENDING_ACCOMPANIMENT = """
    mf C5/2> E5+G5/2 C5+G5/2> -/2
"""

MELODY = (INTRODUCTION_MELODY + FIRST_STRAIN_MELODY + FIRST_ENDING_MELODY
          + FIRST_STRAIN_MELODY + SECOND_ENDING_MELODY)
ACCOMPANIMENT = (INTRODUCTION_ACCOMPANIMENT
                 + FIRST_STRAIN_ACCOMPANIMENT + FIRST_ENDING_ACCOMPANIMENT
                 + FIRST_STRAIN_ACCOMPANIMENT + SECOND_ENDING_ACCOMPANIMENT)


def midi_note(name):
    """MIDI number of a note name, middle C being C4: "E6" is 88, "Ab5" 80."""
    letter, accidental, octave = name[0], name[1:-1], int(name[-1])
    step = {"C": 0, "D": 2, "E": 4, "F": 5, "G": 7, "A": 9, "B": 11}[letter]
    return 12 * (octave + 1) + step + {"": 0, "#": 1, "b": -1}[accidental]


def notes_of(bars, louder=0, share_held=0.9):
    """(start tick, length in ticks, MIDI note, velocity) of each note of a part, in time order."""
    notes, now, loudness, tied = [], 0, LOUDNESS["mf"], False
    for number, bar in enumerate(filter(None, map(str.strip, bars.splitlines()))):
        for word in bar.split():
            if word in LOUDNESS:
                loudness = LOUDNESS[word]
                continue
            pitch, marks = word.split("/")
            length = int(marks.rstrip(">~")) * SIXTEENTH_TICKS
            if tied:
                start, held, note, velocity = notes.pop()
                notes.append((start, held + length, note, velocity))
            elif pitch != "-":
                velocity = loudness + louder + (ACCENT if ">" in marks else 0)
                notes += [(now, length, midi_note(name), velocity) for name in pitch.split("+")]
            tied = "~" in marks
            if tied and "+" in pitch:
                raise ValueError(f"only single notes can be tied: {word}")
            now += length
        if now != (number + 1) * 8 * SIXTEENTH_TICKS:
            raise ValueError(f"bar {number + 1} is not two quarters long: {bar}")
    return [(start, max(1, round(share_held * length)), note, velocity)
            for start, length, note, velocity in notes]


def variable_length(value):
    """A number as MIDI files write delta times: seven bits a byte, all but the last with bit 7."""
    encoded = bytes([value & 0x7F])
    while value := value >> 7:
        encoded = bytes([0x80 | value & 0x7F]) + encoded
    return encoded


def meta(kind, content):
    return bytes([0xFF, kind]) + variable_length(len(content)) + content


def track(name, events):
    """A track chunk; events are (tick, bytes), sorted by tick."""
    body, before = variable_length(0) + meta(0x03, name.encode("ascii")), 0
    for tick, message in events:
        body += variable_length(tick - before) + message
        before = tick
    body += variable_length(0) + meta(0x2F, b"")
    return b"MTrk" + struct.pack(">I", len(body)) + body


def part(name, notes):
    """A track of notes on channel 1; a note's end comes before another's start at the same tick."""
    events = []
    for start, length, note, velocity in notes:
        events.append((start, bytes([0x90, note, velocity])))
        events.append((start + length, bytes([0x80, note, 64])))
    return track(name, sorted(events, key=lambda event: (event[0], event[1])))


def song():
    """The song as a standard MIDI file of format 1: a tempo track and one track a hand."""
    conductor = track("The Entertainer (Scott Joplin, 1902)", [
        (0, meta(0x51, struct.pack(">I", QUARTER_MICROSECONDS)[1:])),
        (0, meta(0x58, bytes([2, 2, 24, 8]))),  # 2/4
        (0, meta(0x59, bytes([0, 0]))),  # C major
    ])
    tracks = [conductor, part("Xylophone, melody", notes_of(MELODY)),
              part("Xylophone, accompaniment", notes_of(ACCOMPANIMENT, louder=-15, share_held=0.6))]
    header = b"MThd" + struct.pack(">IHHH", 6, 1, len(tracks), QUARTER_TICKS)
    return header + b"".join(tracks)


if __name__ == "__main__":
    pathlib.Path(__file__).with_name("TheEntertainer.mid").write_bytes(song())
