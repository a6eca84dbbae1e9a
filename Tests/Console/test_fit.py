import array
import json
import math
import random
import struct

from console import OBJECTS, ConsoleTest, Wave

BAR = OBJECTS / "stones-72.modal"  # no tube: modes that share a tube are too close for a fit
PLACES = ("0,0,0", "0.02,0.01,0", "0.035,0,0", "0.06,0.015,0", "0.09,0,0")
# A hard, light mallet excites all modes.
HARD = ("--set", "mallet_hardness=100000", "--set", "mallet_mass=1", "--set", "tau=0.001")


def wav(channels, rate=48000, bits=32):
    """Writes a WAV file of 16- or 24-bit integers or 32-bit floats, full scale 1."""
    frames = [sample for frame in zip(*channels) for sample in frame]
    if bits == 32:
        data = array.array("f", frames).tobytes()
    else:
        data = b"".join(round(x * (2 ** (bits - 1) - 1)).to_bytes(bits // 8, "little", signed=True)
                        for x in frames)
    size = bits // 8 * len(channels)
    head = struct.pack("<4sIHHIIHH4sI", b"fmt ", 16, 3 if bits == 32 else 1, len(channels), rate,
                       size * rate, size, bits, b"data", len(data))
    return b"RIFF" + struct.pack("<I", 4 + len(head) + len(data)) + b"WAVE" + head + data


def partials(modes, rate=48000, seconds=0.6):
    """Returns damped cosines of (frequency, decay, gain) after 50 ms of silence."""
    return [0.0] * (rate // 20) + [
        sum(gain * math.exp(-decay * n / rate) * math.cos(2 * math.pi * hz * n / rate)
            for hz, decay, gain in modes) for n in range(int(rate * seconds))]


def cents(a, b):
    return 1200 * math.log2(a / b)


class Fit(ConsoleTest):
    def strike(self, obj, place, name, *options):
        output = self.folder / name
        report = self.json("strike", obj, "-o", output, "--at", place, *options)
        return report, Wave(output)

    def recordings_of_the_bar(self):
        """Makes strikes at different levels and onsets, with noise."""
        random.seed(4)
        arguments = []
        for number, place in enumerate(PLACES):
            report, wave = self.strike(BAR, place, "raw.wav", "--seconds", 0.8, *HARD)
            gain = random.uniform(0.2, 0.9)
            peak = wave.peak()
            before = [0.0] * random.randrange(100, 5000)
            samples = [gain * (x / peak + 1e-3 * random.gauss(0, 1))
                       for x in before + list(wave.left)]
            path = self.write(f"strike {number}.wav", wav([samples]))
            arguments.append("{}@{},{},{}".format(path, *report["point_m"]))
        return arguments

    def test_the_fit_of_five_strikes_on_a_bar_finds_its_modes(self):
        recordings = self.recordings_of_the_bar()
        fitted = self.folder / "fitted.modal"
        told = self.json("fit", *recordings, "-o", fitted)
        true = self.json("info", BAR)["modes"]
        found = self.json("info", fitted)["modes"]
        strongest = max(max(mode["amplitudes"]) for mode in told["modes"])
        loud = 0
        for mode in told["modes"]:
            if max(mode["amplitudes"]) < strongest * 10 ** (-40 / 20) or mode["t60_s"] < 0.02:
                continue
            loud += 1
            nearest = min(true, key=lambda m: abs(cents(m["frequency_hz"], mode["frequency_hz"])))
            with self.subTest(hz=mode["frequency_hz"], true=nearest["frequency_hz"]):
                self.assertLess(abs(cents(mode["frequency_hz"], nearest["frequency_hz"])), 2)
                self.assertAlmostEqual(mode["t60_s"] / nearest["t60_s"], 1, delta=0.1)
                stored = min(found, key=lambda m: abs(m["frequency_hz"] - mode["frequency_hz"]))
                self.assertAlmostEqual(stored["frequency_hz"], mode["frequency_hz"], places=6)
                self.assertAlmostEqual(stored["t60_s"] / mode["t60_s"], 1, places=9)
        self.assertGreaterEqual(loud, 9)
        # No mode that is loud at a struck point is missing.
        report, _ = self.strike(BAR, PLACES[3], "loud.wav", "--seconds", 0.1, *HARD)
        for mode in report["loudest_modes"]:
            if min(true, key=lambda m: abs(m["frequency_hz"] - mode["frequency_hz"]))[
                    "t60_s"] < 0.02:
                continue
            self.assertLess(min(abs(cents(m["frequency_hz"], mode["frequency_hz"]))
                                for m in found), 2)

    def test_the_fitted_object_sounds_like_the_one_recorded(self):
        recordings = self.recordings_of_the_bar()
        fitted = self.folder / "fitted.modal"
        self.succeed("fit", *recordings, "-o", fitted)
        modes = [m["frequency_hz"] for m in self.json("info", BAR)["modes"]
                 if m["frequency_hz"] < 8000]
        for place in PLACES[1:4]:
            report, real = self.strike(BAR, place, "real.wav", "--seconds", 0.3, *HARD)
            exact = "{},{},{}".format(*report["point_m"])
            _, made = self.strike(fitted, exact, "made.wav", "--seconds", 0.3, *HARD)
            loud = {hz: real.level_at(hz, 0, 12000) for hz in modes}
            levels = [20 * math.log10(made.level_at(hz, 0, 12000) / level)
                      for hz, level in loud.items() if level > max(loud.values()) / 100]
            self.assertGreater(len(levels), 2)
            with self.subTest(place=place, levels=levels):
                self.assertLess(max(levels) - min(levels), 1.8)

    def test_any_wav_format_can_be_fitted(self):
        modes = ((300, 9, 0.4), (811, 15, 0.3), (2200, 30, 0.2))
        for rate, bits, stereo in ((44100, 16, True), (48000, 24, False), (96000, 32, True)):
            samples = partials(modes, rate)
            path = self.write("r.wav", wav([samples, [0.5 * x for x in samples]]
                                           if stereo else [samples], rate, bits))
            told = self.json("fit", f"{path}@0.1", "-o", self.folder / "r.modal")
            with self.subTest(rate=rate, bits=bits):
                self.assertEqual(told["mode_count"], 3)
                for mode, (hz, decay, _) in zip(told["modes"], modes):
                    self.assertLess(abs(cents(mode["frequency_hz"], hz)), 0.5)
                    self.assertAlmostEqual(mode["t60_s"] * decay / math.log(1000), 1, delta=0.02)

    def test_radii_make_a_disc_and_assumptions_are_reported(self):
        path = self.write("r.wav", wav([partials(((300, 9, 0.4), (811, 15, 0.3)))]))
        output = self.folder / "wok.modal"
        text = self.succeed("fit", f"{path}@0.05", f"{path}@0.1", "-o", output).stdout
        for word in ("2 modes", "gamma", "steel", "mass"):
            self.assertIn(word, text)
        info = self.json("info", output)
        self.assertEqual(info["name"], "wok")
        self.assertEqual(info["method"], "measured")
        self.assertTrue(info["measured_decays"])
        self.assertEqual(info["vertices"], 49)
        self.assertIn("r.wav", info["provenance"]["source"])
        glass = self.json("fit", f"{path}@0.05", "-o", output, "--material", "glass", "--mass", 2)
        self.assertEqual(glass["material"]["name"], "Glass")
        self.assertEqual(glass["mass_kg"], 2)

    def test_another_material_keeps_the_decay_of_a_mode_relative_to_its_material(self):
        path = self.write("r.wav", wav([partials(((300, 9, 0.4), (811, 15, 0.3)))]))
        output = self.folder / "r.modal"
        self.succeed("fit", f"{path}@0.05", "-o", output, "--material", "Steel")
        _, own = self.strike(output, "0,0,0", "own.wav", "--seconds", 0.5)
        _, live = self.strike(output, "0,0,0", "live.wav", "--seconds", 0.5,
                              "--set", "material=Steel")
        self.assertLess(max(abs(a - b) for a, b in zip(own.left, live.left)), 1e-5 * own.peak())
        _, given = self.strike(output, "0,0,0", "given.wav", "--seconds", 0.5,
                               "--material", "Glass")
        _, live = self.strike(output, "0,0,0", "live.wav", "--seconds", 0.5,
                              "--set", "material=Glass")
        self.assertLess(max(abs(a - b) for a, b in zip(given.left, live.left)),
                        1e-4 * given.peak())

    def test_a_mesh_carries_the_gains(self):
        mesh = self.folder / "bar.obj"
        self.succeed("mesh", "bar", "-o", mesh, "--length", 0.3, "--width", 0.04)
        path = self.write("r.wav", wav([partials(((300, 9, 0.4), (811, 15, 0.3)))]))
        other = self.write("s.wav", wav([partials(((300, 9, 0.1), (811, 15, 0.4)))]))
        output = self.folder / "r.modal"
        told = self.json("fit", f"{path}@0,0,0", f"{other}@0.15,0,0", "-o", output,
                         "--mesh", mesh)
        self.assertGreater(told["vertices"], 50)
        middle, _ = self.strike(output, "0,0,0", "m.wav", "--seconds", 0.1, *HARD)
        end, _ = self.strike(output, "0.15,0,0", "e.wav", "--seconds", 0.1, *HARD)
        self.assertAlmostEqual(middle["loudest_modes"][0]["frequency_hz"], 300, delta=0.1)
        self.assertAlmostEqual(end["loudest_modes"][0]["frequency_hz"], 811, delta=0.2)

    def test_what_is_odd_in_a_mesh_is_reported(self):
        mesh = self.write("crossed.obj", "v 0 0 0\nv 0.4 0 0\nv 0.4 0.1 0\nv 0 0.3 0\n"
                                         "f 1 2 3\nf 1 3 2 4\n")
        path = self.write("r.wav", wav([partials(((300, 9, 0.4), (811, 15, 0.3)))]))
        told = self.json("fit", f"{path}@0,0,0", "-o", self.folder / "r.modal", "--mesh", mesh)
        self.assertIn("One polygon crosses itself", told["notes"])

    def test_bad_recordings_get_one_sentence(self):
        good = self.write("good.wav", wav([partials(((300, 9, 0.4),))]))
        output = self.folder / "out.modal"
        for name, content, saying in (
                ("silence.wav", wav([[0.0] * 20000]), "silent"),
                ("short.wav", wav([[0.5] * 100]), "shorter"),
                ("text.wav", "RIFF, but not really", "not a WAV, FLAC or AIFF file")):
            path = self.write(name, content)
            self.refuse("fit", f"{good}@0", f"{path}@0.1", "-o", output, naming=name,
                        saying=saying)
        self.refuse("fit", f"{self.folder / 'missing.wav'}@0", "-o", output,
                    naming="missing.wav", saying="cannot be opened")

    def test_the_resynthesis_is_the_recording_without_its_noise(self):
        random.seed(9)
        clean = partials(((300, 9, 0.4), (811, 15, 0.3), (2200, 30, 0.2)))
        path = self.write("r.wav", wav([[x + 0.005 * random.gauss(0, 1) for x in clean]]))
        made = self.folder / "made.wav"
        told = self.json("fit", f"{path}@0", "-o", self.folder / "r.modal",
                         "--resynthesis", made)
        self.assertGreater(told["rests"][0]["modes"], 0.95)
        left = Wave(made).left
        self.assertEqual(len(left), len(clean))
        free = 48000 // 20 + 48  # from 1 ms after the strike
        energy = sum(x * x for x in clean[free:])
        difference = sum((a - b) ** 2 for a, b in zip(left[free:], clean[free:]))
        self.assertLess(10 * math.log10(difference / energy), -25)
        flac = self.folder / "made.flac"
        text = self.succeed("fit", f"{path}@0", "-o", self.folder / "r.modal",
                            "--resynthesis", flac).stdout
        self.assertIn("The modes hold", text)
        self.assertEqual(flac.read_bytes()[:4], b"fLaC")
        self.refuse("fit", f"{path}@0", f"{path}@0.1", "-o", self.folder / "r.modal",
                    "--resynthesis", made, naming="--resynthesis", saying="exactly one recording")

    def test_clipping_is_reported(self):
        loud = [max(-0.5, min(0.5, x)) for x in partials(((300, 9, 2.0),))]
        path = self.write("loud.wav", wav([loud]))
        text = self.succeed("fit", f"{path}@0", "-o", self.folder / "out.modal").stdout
        self.assertIn("clipped", text)

    def test_bad_options_get_one_sentence(self):
        good = self.write("good.wav", wav([partials(((300, 9, 0.4),))]))
        output = self.folder / "out.modal"
        for place in ("", "@", "@x", "@1,2", "@1,2,3,4", "@nan", "@-1", "@1,2,inf", "@1,,3"):
            self.refuse("fit", f"{good}{place}", "-o", output, naming="good.wav", saying="a place")
        self.refuse("fit", f"{good}@0", f"{good}@0,0,0", "-o", output, naming="radius")
        self.refuse("fit", f"{good}@0", "-o", self.folder / "no" / "out.modal",
                    naming="out.modal", saying="cannot be written")
        self.refuse("fit", f"{good}@0", "-o", output, "--material", "unobtainium",
                    naming="unobtainium")
        self.refuse("fit", f"{good}@0", "-o", output, "--mesh", self.folder / "no.obj",
                    naming="no.obj")
        for option in ("--modes", "--mass", "--contact-time"):
            self.refuse("fit", f"{good}@0", "-o", output, option, "-1", naming=option)
