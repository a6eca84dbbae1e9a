import array
import cmath
import json
import math
import random
import struct

from console import ConsoleTest

RATE = 44100


def transform(values):
    """Returns the sums of values[k] e^(2 pi i k n / N), N a power of two."""
    n = len(values)
    if n == 1:
        return values
    even, odd = transform(values[::2]), transform(values[1::2])
    turned = [cmath.exp(2j * math.pi * k / n) * odd[k] for k in range(n // 2)]
    return ([e + t for e, t in zip(even, turned)] + [e - t for e, t in zip(even, turned)])


def scrape(exponent, frequency, damping, count=1 << 16):
    """Returns noise of power ~ f^exponent through a reson filter in direct form, peak 0.5."""
    random.seed(12)
    spectrum = [0j] * count
    for k in range(40, count // 2):
        spectrum[k] = cmath.rect(k ** (exponent / 2), random.uniform(0, 2 * math.pi))
    radius, angle = math.exp(-damping / RATE), 2 * math.pi * frequency / RATE
    one, two, result = 0.0, 0.0, []
    for value in transform(spectrum):
        one, two = value.real + 2 * radius * math.cos(angle) * one - radius ** 2 * two, one
        result.append(one)
    peak = max(map(abs, result))
    return [0.5 * value / peak for value in result]


def riff(*chunks):
    """Writes a WAV file of chunks (name, content) or (name, content, length in the header)."""
    body = b"WAVE" + b"".join(name + struct.pack("<I", *(promised or [len(content)])) + content
                              for name, content, *promised in chunks)
    return b"RIFF" + struct.pack("<I", len(body)) + body


def wav_format(kind=3, channels=1, bits=32):
    frame = bits // 8 * channels
    return b"fmt ", struct.pack("<HHIIHH", kind, channels, RATE, frame * RATE, frame, bits)


def wav(samples, channels=1, frames_promised=None):
    """Writes a WAV file of 32-bit floats."""
    data = array.array("f", samples).tobytes()
    size = len(data) if frames_promised is None else 4 * channels * frames_promised
    return riff(wav_format(channels=channels), (b"data", data, size))


class Surfaces(ConsoleTest):
    def test_the_fit_of_a_known_scrape_finds_its_figures_and_saves_them(self):
        recording = self.write("slate.wav", wav(scrape(-1.4, 900, 500)))
        saved = self.folder / "slate surface.json"
        told = self.json("surface", recording, "--speed", 0.4, "-o", saved)
        surface = json.loads(saved.read_text())
        self.assertEqual(surface["format"], "idiophone-surface")
        self.assertEqual(surface["name"], "slate surface")
        self.assertAlmostEqual(surface["spectrum_exponent"], -1.4, delta=0.1)
        self.assertAlmostEqual(surface["reson_frequency_hz"], 900, delta=45)
        self.assertAlmostEqual(surface["reson_damping_per_s"], 500, delta=100)
        self.assertEqual(surface["reference_speed_m_per_s"], 0.4)
        self.assertAlmostEqual(told["fractal_dimension"],
                               surface["spectrum_exponent"] / 2 + 2, places=9)
        for key, value in surface.items():
            self.assertEqual(told[key], value)

    def test_stereo_is_mixed_and_the_report_reads_as_a_sentence(self):
        mono = scrape(-1.0, 2000, 900)
        recording = self.write("two.wav", wav([s for sample in mono for s in (sample, 0)], 2))
        text = self.succeed("surface", recording).stdout
        self.assertIn("two.wav: spectrum exponent -", text)
        self.assertEqual(text.count("\n"), 1)
        self.assertAlmostEqual(self.json("surface", recording)["reson_frequency_hz"], 2000,
                               delta=100)

    def test_a_scrape_without_a_resonance_is_fitted_within_the_ranges_with_a_warning(self):
        random.seed(7)
        noise = self.write("noise.wav", wav([random.gauss(0, 0.1) for _ in range(RATE)]))
        result = self.succeed("surface", noise, "--json")
        self.assertIn("noise.wav: it is no scrape with a clear resonance", result.stderr)
        told = json.loads(result.stdout)
        self.assertEqual(told["reson_damping_per_s"], 1e5)
        self.assertAlmostEqual(told["spectrum_exponent"], 0, delta=0.2)

    def test_bad_recordings_get_one_sentence(self):
        sound = scrape(-1, 900, 500, 1 << 14)
        for name, content, saying in (
                ("silence.wav", wav([0] * RATE), "silent"),
                ("offset.wav", wav([0.25] * RATE), "silent"),
                ("short.wav", wav(sound[:4000]), "shorter than a quarter"),
                ("empty.wav", wav([]), "shorter than a quarter"),
                ("nan.wav", wav(sound + [math.nan]), "not numbers"),
                ("promise.wav", wav(sound, frames_promised=10 ** 8), "header says"),
                ("text.wav", "RIFF, but not really", "not a WAV, FLAC or AIFF file"),
                ("zeros.wav", riff(wav_format(1, bits=0), (b"data", bytes(8 * RATE))),
                 "cannot be read"),
                ("nothing.wav", b"", "not a WAV, FLAC or AIFF file")):
            path = self.write(name, content)
            self.refuse("surface", path, "-o", self.folder / "out.json", naming=name,
                        saying=saying)
        self.refuse("surface", self.folder / "missing.wav", naming="missing.wav",
                    saying="cannot be opened")
        self.refuse("surface", self.folder, naming=self.folder.name, saying="directory")

    def test_other_chunks_of_a_recording_change_nothing(self):
        sound = b"data", array.array("f", scrape(-1, 900, 500, 1 << 14)).tobytes()
        files = [self.write(f"{number}.wav", riff(wav_format(), *chunks)) for number, chunks in enumerate((
            [sound],
            [(b"LIST", b"INFOINAM\4\0\0\0rock"), (b"axml", b"\xc9<\xc9&"), sound, (b"smpl", b"\0" * 36)],
            [sound, (b"smpl", b"", 2 ** 32 - 1)],
            [sound, (b"LIST", b"adtl", 1000)]))]
        figures = [self.json("surface", file) for file in files]
        for each in figures:
            each.pop("name")
            self.assertEqual(each, figures[0])

    def test_bad_options_get_one_sentence(self):
        recording = self.write("good.wav", wav(scrape(-1, 900, 500, 1 << 14)))
        for speed in ("0", "-1", "nan", "1e9", "fast"):
            self.refuse("surface", recording, "--speed", speed, naming="--speed")
        self.refuse("surface", recording, "-o", self.folder / "no" / "out.json",
                    naming="out.json", saying="cannot be written")
        self.refuse("surface", naming="RECORDING")
