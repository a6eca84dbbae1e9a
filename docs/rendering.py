"""What the scripts of this folder share that render with the console and keep sounds."""
import itertools
import json
import pathlib
import struct
import subprocess
import sys

import numpy as np
import soundfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
RATE = 48000
NOTE_OFF, NOTE_ON, CONTROL, PRESSURE = 0x80, 0x90, 0xB0, 0xD0


def standard_midi_file(events):
    """Bytes of one track; events are (seconds, status, data...), to the millisecond."""
    def variable_length(number):
        parts = [number & 127]
        while number := number >> 7:
            parts.insert(0, number & 127 | 128)
        return bytes(parts)

    track, last = b"\x00\xff\x51\x03" + (1_000_000).to_bytes(3, "big"), 0
    for seconds, *message in sorted(events, key=lambda event: event[0]):
        tick = round(1000 * seconds)
        track += variable_length(tick - last) + bytes(message)
        last = tick
    track += b"\x00\xff\x2f\x00"
    return (b"MThd" + struct.pack(">IHHH", 6, 0, 1, 1000) + b"MTrk" +
            struct.pack(">I", len(track)) + track)


class Console:
    """The `idiophone` command, in a folder that goes away with it, and what it always sets."""

    def __init__(self, program, folder, **always):
        self.program, self.folder, self.number = program, pathlib.Path(folder), 0
        self.always = {"limiter": 0, **always}

    def run(self, *arguments):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stderr)
        return done.stdout

    def _sound(self, *arguments, seconds, rate, parameters):
        self.number += 1
        wav = self.folder / f"{self.number}.wav"
        report = self.run(*arguments, "-o", wav, "--json", "--sample-rate", rate,
                          "--seconds", seconds,
                          *itertools.chain.from_iterable(
                              ("--set", f"{name}={value}")
                              for name, value in {**self.always, **parameters}.items()))
        samples = soundfile.read(wav, always_2d=True)[0]
        wav.unlink()
        return samples, json.loads(report)

    def render(self, preset, events, seconds, rate=RATE, **parameters):
        """Left and right, [samples, 2]; `events` or the path of a MIDI file."""
        if not isinstance(events, pathlib.Path):
            path = self.folder / "events.mid"
            path.write_bytes(standard_midi_file(events))
            events = path
        return self._sound("render", "--preset", preset, "--midi", events, seconds=seconds,
                           rate=rate, parameters=parameters)[0]

    def strike(self, thing, place, velocity, seconds, **parameters):
        """[samples, 2] and what the console says of the strike; `place` is a point in metres."""
        return self._sound("strike", thing, "--at", ",".join(map(str, place)), "--velocity",
                           velocity, seconds=seconds, rate=RATE, parameters=parameters)

    def vertex(self, thing, place):
        """The vertex that is struck at a place: its number and its point."""
        report = self.strike(thing, place, 100, 0.01)[1]
        return report["vertex"], report["point_m"]

    def relative(self, thing, place):
        """A place on a flat thing in units of its bounding box."""
        corner = self.vertex(thing, (9, 9, 0))[1]
        return [place[0] / corner[0], place[1] / corner[1], 0]

    def answer(self, thing, vertex, seconds, rate, **parameters):
        """Velocity of a point in m/s under an impulse of 1 Ns into it."""
        path, newton_seconds = self.folder / "impulse.jsonl", 1e-3
        path.write_text(json.dumps({"time": 0, "object": str(thing), "vertex": vertex,
                                    "impulse": [0, 0, -newton_seconds]}))
        sound = self._sound("render", "--impulses", path, seconds=seconds, rate=rate,
                            parameters=parameters)[0]
        return sound[:, 0] / newton_seconds

    def preset(self, base, thing, points, notes, **parameters):
        """A factory preset with another object and way over it, as a file."""
        document = json.loads((ROOT / "Presets" / base).read_text())
        document["keyMap"] = {"kind": "zones", "lowestNote": notes[0], "highestNote": notes[-1],
                              "object": str(thing), "strikePath": points, "strikeWidth": 0}
        document["parameters"].update(parameters)
        self.number += 1
        path = self.folder / f"{self.number}.json"
        path.write_text(json.dumps(document))
        return path


def write_flac(path, parts, rate=RATE):
    """Sounds one after the other as 16-bit FLAC at -3 dBFS; one channel where both are the same."""
    fade = round(0.03 * rate)
    end = np.linspace(1, 0, fade)[:, None]
    sound = np.concatenate([np.concatenate((part[:-fade], part[-fade:] * end)) for part in parts])
    if np.array_equal(sound[:, 0], sound[:, 1]):
        sound = sound[:, 0]
    sound *= 10 ** (-3 / 20) / np.abs(sound).max()
    soundfile.write(path, sound, rate, subtype="PCM_16", compression_level=1.0)
    print(f"{path.name}: {len(sound) / rate:.1f} s, {path.stat().st_size / 1000:.0f} kB")
