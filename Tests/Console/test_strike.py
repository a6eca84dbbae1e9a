import json
import math
import re

from console import OBJECTS, ConsoleTest, Wave

PLATE = OBJECTS / "plate.modal"
BAR = OBJECTS / "xylophone-72.modal"


class Strike(ConsoleTest):
    def strike(self, obj, *options, name="strike.wav"):
        output = self.folder / name
        report = self.json("strike", obj, "-o", output, *options)
        return report, Wave(output)

    def test_the_sound_consists_of_the_objects_modes(self):
        report, wave = self.strike(BAR, "--at", "0,0,0", "--seconds", 0.5)
        modes = {round(m["frequency_hz"], 6) for m in self.json("info", BAR)["modes"]}
        loudest = report["loudest_modes"]
        self.assertEqual(loudest[0]["relative_db"], 0)
        # One of the two modes that bar and tube share.
        self.assertAlmostEqual(loudest[0]["frequency_hz"], 523.25, delta=1.2)
        for mode in loudest:
            self.assertIn(round(mode["frequency_hz"], 6), modes)
        fundamental = loudest[0]["frequency_hz"]
        for aside in (0.8, 1.25):
            self.assertGreater(wave.level_at(fundamental, 0, 12000),
                               20 * wave.level_at(fundamental * aside, 0, 12000))

    def test_the_loudest_modes_have_the_reported_levels(self):
        report, wave = self.strike(PLATE, "--seconds", 1, "--set", "mallet_hardness=60")
        first, second = report["loudest_modes"][:2]
        told = second["relative_db"]
        heard = 20 * math.log10(wave.level_at(second["frequency_hz"], 0, 24000) /
                                wave.level_at(first["frequency_hz"], 0, 24000))
        self.assertAlmostEqual(heard, told, delta=1.5)

    def test_a_point_equals_the_vertex_there(self):
        at_point, _ = self.strike(PLATE, "--at", "0.05,-0.02,0", name="point.wav")
        x, y, z = at_point["point_m"]
        self.assertLess(math.dist((x, y, z), (0.05, -0.02, 0)), 0.01)
        self.strike(PLATE, "--vertex", at_point["vertex"], name="vertex.wav")
        self.assertEqual((self.folder / "point.wav").read_bytes(),
                         (self.folder / "vertex.wav").read_bytes())

    def test_velocity_makes_the_sound_louder_and_brighter(self):
        loudest, brightness = [], []
        for velocity in (20, 120):
            report, wave = self.strike(BAR, "--at", "0,0,0", "--velocity", velocity, "--seconds",
                                       0.25)
            third = report["loudest_modes"][2]["frequency_hz"]
            loudest.append(wave.peak())
            brightness.append(wave.level_at(third) / wave.level_at(523.25))
        self.assertGreater(loudest[1], 3 * loudest[0])
        self.assertGreater(brightness[1], brightness[0])

    def test_another_material_moves_frequencies_by_the_root_of_stiffness_over_density(self):
        steel, _ = self.strike(PLATE, "--at", "0.1,0.05,0", "--seconds", 0.1)
        glass, _ = self.strike(PLATE, "--at", "0.1,0.05,0", "--seconds", 0.1, "--material", "Glass")
        own = self.json("info", PLATE)["material"]
        ratio = math.sqrt(6.2e10 / 2600 * own["density_kg_per_m3"] / own["youngs_modulus_pa"])
        self.assertEqual(glass["material"], "Glass")
        # The contact on the lighter plate is shorter, so fainter modes come in another order.
        for before, after in list(zip(steel["loudest_modes"], glass["loudest_modes"]))[:3]:
            self.assertAlmostEqual(after["frequency_hz"] / before["frequency_hz"], ratio, places=3)

    def test_files_beside_the_output_stay_under_any_name(self):
        theirs = [self.write(name + ending, "theirs") for name in ("sound.wav", "map.ply")
                  for ending in (".part", ".1.part")]
        before = set(self.folder.iterdir())
        sound, ply = self.folder / "sound.wav", self.folder / "map.ply"
        self.succeed("strike", PLATE, "-o", sound, "--seconds", 0.1)
        self.succeed("map", PLATE, "-o", ply)
        self.assertEqual({path.read_text() for path in theirs}, {"theirs"})
        self.assertEqual(set(self.folder.iterdir()), before | {sound, ply})

    def test_a_listed_material_works_as_a_file(self):
        listed = next(m for m in self.json("materials") if m["name"] == "Glass")
        file = self.write("glass.json", json.dumps(listed))
        self.strike(BAR, "--material", file, name="file.wav")
        self.strike(BAR, "--material", "glass", name="name.wav")
        self.assertEqual((self.folder / "file.wav").read_bytes(),
                         (self.folder / "name.wav").read_bytes())

    def test_an_impossible_material_is_refused_with_its_object(self):
        vapour = self.write("vapour.json", json.dumps({
            "name": "vapour", "youngs_modulus_pa": 1e14, "density_kg_per_m3": 1e-3,
            "poisson_ratio": 0.3, "fluid_damping_per_s": 1, "viscoelastic_damping_s": 1e-8,
            "friction": 0.5, "restitution": 0.5, "roughness": 0.5, "source": "made up"}))
        plate = OBJECTS / "plate.modal"
        self.refuse("strike", plate, "--material", vapour, "-o", self.folder / "x.wav",
                    naming=plate, saying="as 'vapour', an eigenvalue lies beyond 1 GHz")

    def test_live_material_and_reanalysis_sound_alike(self):
        _, live = self.strike(PLATE, "--vertex", 0, "--set", "material=Glass", "--seconds", 0.2,
                              name="live.wav")
        _, given = self.strike(PLATE, "--vertex", 0, "--material", "Glass", "--seconds", 0.2,
                               name="given.wav")
        error = max(abs(a - b) for a, b in zip(live.left, given.left))
        self.assertLess(error, 1e-4 * given.peak())

    def test_bit_depths_are_rounded_to_the_nearest_step(self):
        waves = {bits: self.strike(BAR, "--seconds", 0.1, "--set", "level=-12",
                                   "--bit-depth", bits)[1] for bits in (16, 24, 32)}
        self.assertTrue(waves[32].is_float)
        for bits in (16, 24):
            self.assertFalse(waves[bits].is_float)
            self.assertEqual(waves[bits].bits, bits)
            step = 2.0 ** (1 - bits)
            for exact, whole in zip(waves[32].left, waves[bits].left):
                self.assertLess(abs(exact - whole), 0.501 * step)

    def test_a_name_that_ends_in_flac_gives_flac(self):
        options = ("--seconds", 0.1, "--set", "level=-12")
        report, _ = self.strike(BAR, *options)
        flac = self.folder / "strike.flac"
        told = self.json("strike", BAR, "-o", flac, *options)
        self.assertEqual(flac.read_bytes()[:4], b"fLaC")
        self.assertEqual(told["samples"], report["samples"])
        self.refuse("strike", BAR, "-o", self.folder / "float.flac", *options, "--bit-depth", 32,
                    naming="float.flac", saying="16 or 24 bits")

    def test_rate_and_length_are_as_requested(self):
        for rate in (8000, 44100, 384000):
            report, wave = self.strike(BAR, "--sample-rate", rate, "--seconds", 0.25)
            self.assertEqual(wave.rate, rate)
            self.assertEqual(wave.channel_count, 2)
            self.assertEqual(len(wave), rate // 4)
            self.assertEqual(report["samples"], len(wave))

    def test_a_sound_without_a_given_length_ends_at_silence(self):
        _, wave = self.strike(BAR, "--set", "tau=1")
        self.assertNotEqual(wave.left[-1], 0)
        self.assertLess(len(wave), 5 * 48000)

    def test_clipping_gives_a_warning(self):
        result = self.succeed("strike", BAR, "-o", self.folder / "loud.wav", "--bit-depth", 16,
                              "--set", "level=24", "--set", "limiter=0",
                              "--set", "mallet_mass=500", "--velocity", 127)
        self.assertIn("clipped", result.stderr)

    def test_the_limiter_keeps_a_loud_strike_below_full_scale(self):
        result = self.succeed("strike", BAR, "-o", self.folder / "loud.wav", "--set", "level=24",
                              "--set", "mallet_mass=500", "--velocity", 127, "--seconds", 0.2)
        self.assertEqual(result.stderr, "")
        self.assertLess(Wave(self.folder / "loud.wav").peak(), 10 ** (-0.3 / 20))

    def test_a_peak_beyond_full_scale_is_reported_with_the_level_that_avoids_it(self):
        loud = ("strike", BAR, "-o", self.folder / "loud.wav", "--set", "mallet_mass=500",
                "--set", "limiter=0", "--velocity", 127, "--seconds", 0.2)
        said = self.succeed(*loud, "--set", "level=24").stderr
        peak = 20 * math.log10(Wave(self.folder / "loud.wav").peak())
        told, level = map(float, re.search(r"peak of (\S+) dBFS.*level=(\S+)", said).groups())
        self.assertAlmostEqual(told, peak, delta=0.0501)
        self.assertEqual(self.succeed(*loud, "--set", f"level={level}").stderr, "")
        self.assertLessEqual(Wave(self.folder / "loud.wav").peak(), 1)
        self.assertIn("dBFS", self.succeed(*loud, "--set", f"level={level + 0.2:.1f}").stderr)

    def test_a_point_far_from_the_object_gives_a_warning(self):
        def said(point):
            return self.succeed("strike", PLATE, "-o", self.folder / "a.wav", "--seconds", 0.05,
                                "--at", point).stderr
        # The plate is 300 mm by 200 mm.
        self.assertIn("lies 1000 mm off the object, whose diagonal is 361 mm", said("0.05,0.02,1"))
        self.assertIn("lies 53675 mm off", said("50,20,0"))
        for near in ("0.05,0.02,0", "0.05,0.02,0.003", "0.151,0.1,0"):
            self.assertNotIn("--at", said(near))

    def test_the_report_names_object_point_and_loudest_modes(self):
        text = self.succeed("strike", PLATE, "-o", self.folder / "a.wav", "--vertex", 0).stdout
        for word in ("plate", "vertex 0", "dBFS", "loudest modes", "Hz"):
            self.assertIn(word, text)
