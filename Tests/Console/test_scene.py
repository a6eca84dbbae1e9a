import cmath
import json
import math
import pathlib
import re
import statistics
import unittest

from console import OBJECTS, ON_QEMU, ConsoleTest, Wave

HEADS = pathlib.Path(__file__).parent / "Heads"
BALL = {
    "format": "idiophone-scene", "version": 1, "name": "Ball on a plate", "seconds": 1,
    "kinds": [{"name": "plate", "object": "plate", "fixed": True},
              {"name": "ball", "ball": {"radius": 0.01, "material": "Steel"}}],
    "bodies": [{"kind": "plate"}, {"kind": "ball", "at": [0.05, 0.03, 0.2115]}],
}


def loudest(samples, band, rate=48000):
    """Returns the power of the spectrum within a band in Hz, in dB, under a Hann window."""
    count = len(samples)
    windowed = [x * (1 - math.cos(2 * math.pi * k / count)) for k, x in enumerate(samples)]
    levels = []
    for hz in range(*band, 3):
        turn, phasor, total = cmath.exp(-2j * math.pi * hz / rate), 1, 0
        for x in windowed:
            total += x * phasor
            phasor *= turn
        levels.append(20 * math.log10(abs(total) + 1e-12))
    return max(levels)


class Scenes(ConsoleTest):
    def scene(self, **changes):
        return self.write("scene.json", json.dumps({**BALL, **changes}))

    def perform(self, scene, *options, name="scene.wav"):
        output = self.folder / name
        return self.json("scene", scene, "-o", output, *options), Wave(output)

    def test_parameters_of_keys_are_reported_to_have_no_effect(self):
        out = ("-o", self.folder / "out.wav", "--seconds", 0.1)
        said = self.succeed("scene", self.scene(), *out, "--set", "mallet_mass=30", "--set",
                            "bend_range=4", "--set", "tau=1").stderr
        self.assertEqual(said.count("has no effect"), 2)
        self.assertIn("--set mallet_mass has", said)
        self.assertIn("--set bend_range has", said)

    def test_parameters_of_keys_are_also_reported_if_no_body_is_heard(self):
        silent = self.scene(kinds=[BALL["kinds"][1]], bodies=[BALL["bodies"][1]])
        said = self.succeed("scene", silent, "-o", self.folder / "out.wav", "--seconds", 0.1,
                            "--set", "bend_range=4", "--set", "gamma=5").stderr
        self.assertIn("--set bend_range has no effect", said)
        self.assertEqual(said.count("has no effect"), 1)

    def test_a_figure_does_not_change_bodies_of_several_materials(self):
        sounds = []
        for settings, warned in (((), 0), (("gamma=50", "young=20"), 2),
                                 (("gamma=50", "material=Glass"), 0), (("material=Glass",), 0)):
            out = self.folder / f"{len(sounds)}.wav"
            said = self.succeed("scene", "Cylinder off a table", "-o", out, "--seconds", 1,
                                *(part for s in settings for part in ("--set", s))).stderr
            self.assertEqual(said.count("the objects have several materials"), warned)
            sounds.append(out.read_bytes())
        self.assertEqual(sounds[0], sounds[1])
        self.assertNotEqual(sounds[2], sounds[3])

    def test_the_factory_scenes_are_listed(self):
        scenes = self.json("scenes")
        self.assertEqual(scenes[0]["name"], "Dice on a xylophone")
        self.assertTrue(scenes[0]["takes_midi"])
        text = self.succeed("scenes").stdout
        for scene in scenes:
            self.assertIn(scene["description"], " ".join(text.split()))

    def test_a_ball_that_falls_on_a_plate_sounds_at_the_impact(self):
        report, wave = self.perform(self.scene())
        # The ball falls from 20 cm above the plate, whose top is at 1.5 mm.
        onset = next(i for i, x in enumerate(wave.left) if x != 0) / 48000
        self.assertAlmostEqual(onset, (2 * 0.2 / 9.81) ** 0.5, delta=0.003)
        self.assertGreaterEqual(report["impacts"], 4)
        self.assertEqual(report["bodies_most"], 2)
        self.assertEqual(sum(report["impacts_of_frame"]), report["impacts"])
        self.assertGreater(max(report["modes_mixed"]), 50)
        self.assertGreater(report["audio_frames_per_second"], 0)

    @unittest.skipIf(ON_QEMU, "qemu starts no second program, and one reads the head")
    def test_a_measured_sphere_sounds_like_the_modelled_one(self):
        # The ball is left of the listener, who looks along y.
        scene = self.scene(listener={"at": [0.4, -0.2, 0.0], "towards": [0.4, 1, 0.0]})
        for rate in (48000, 44100):
            report, sphere = self.perform(scene, "--sample-rate", rate)
            measured_report, measured = self.perform(scene, "--sample-rate", rate,
                                                     "--head", HEADS / "sphere.sofa")
            self.assertEqual(report["impacts"], measured_report["impacts"])
            self.assertAlmostEqual(report["integrated_lufs"], measured_report["integrated_lufs"],
                                   delta=1.0)
            for one, other in zip(sphere.channels, measured.channels):
                energies = [sum(x * x for x in side) for side in (one, other)]
                self.assertLess(abs(10 * math.log10(energies[1] / energies[0])), 1.5)
            onsets = [next(i for i, x in enumerate(side) if abs(x) > 0.05)
                      for side in measured.channels]
            self.assertGreater(onsets[1] - onsets[0], 0.0003 * rate)

    @unittest.skipIf(ON_QEMU, "qemu starts no second program, and one reads the head")
    def test_a_file_that_is_no_head_gets_one_sentence(self):
        scene = self.scene()
        no_head = self.write("-text.sofa", "RIFF and so on")
        huge = self.folder / "huge.sofa"
        with huge.open("wb") as file:
            file.truncate((1 << 28) + 1)
        for name, sentence in ((HEADS / "endless.sofa", "damaged"),
                               (no_head, "it is not a SOFA file"),
                               (self.folder / "nowhere.sofa", "cannot be opened"),
                               (self.folder, "it is a directory"),
                               (huge, "it is larger than 256 MiB")):
            self.refuse("scene", scene, "-o", self.folder / "none.wav", "--head", name,
                        naming=name, saying=sentence)

    def test_the_same_scene_gives_the_same_file(self):
        file = self.scene()
        self.assertEqual(self.perform(file)[1].left, self.perform(file, name="again.wav")[1].left)

    def test_the_number_of_threads_does_not_change_the_file(self):
        for scene, seconds in ("A hundred rings", 1.4), ("Shells in a room", 1):
            files = []
            for threads in (1, 2, 5):
                report, _ = self.perform(scene, "--threads", threads, "--seconds", seconds)
                files.append((self.folder / "scene.wav").read_bytes())
                self.assertGreater(report["impacts"], 0)
            self.assertEqual(files[0], files[1])
            self.assertEqual(files[0], files[2])
        for threads in 0, 65, 1.5:
            self.refuse("scene", scene, "-o", self.folder / "none.wav", "--threads", threads,
                        naming="--threads")

    def test_stems_begin_with_the_mix_and_sum_to_it(self):
        for scene, seconds, kind, fewest, settings, error in (
                ("Dice on a xylophone", 0.5, "bodies", 4, ("room=0", "budget=32"), 1e-6),
                ("Ball on a washboard", 2, "contacts", 2, ("room=30",), 1e-4)):
            stems = self.folder / kind
            assignments = [text for each in (*settings, "limiter=0") for text in ("--set", each)]
            report, mix = self.perform(scene, "--seconds", seconds, "--stems", kind,
                                       "--stem-folder", stems, *assignments)
            waves = [Wave(each["file"]) for each in report["stems"]]
            self.assertGreaterEqual(len(waves), fewest)
            self.assertEqual(len(waves), len(list(stems.iterdir())))
            for wave in waves:
                self.assertGreater(wave.peak(), 0)
                self.assertEqual(len(wave), len(mix))
            sums = map(sum, zip(*(wave.left for wave in waves)))
            worst = max(abs(whole - parts) for whole, parts in zip(mix.left, sums))
            self.assertLess(worst, error * mix.peak())

    def test_stems_need_a_kind_and_a_folder(self):
        mix = ("-o", self.folder / "mix.wav")
        self.refuse("scene", self.scene(), *mix, "--stems", "bodies", naming="--stem-folder")
        self.refuse("scene", self.scene(), *mix, "--stem-folder", self.folder / "stems",
                    naming="--stems")
        self.refuse("scene", self.scene(), *mix, "--stems", "all", "--stem-folder",
                    self.folder / "stems", naming="--stems")
        self.refuse("scene", self.scene(), *mix, "--stems", "bodies", "--stem-folder",
                    self.write("file", "") / "stems", naming="file", saying="cannot be created")

    def test_modes_beyond_the_budget_are_counted(self):
        report, _ = self.perform(self.scene(), "--set", "budget=16")
        self.assertGreater(max(report["modes_dropped"]), 0)

    def test_impacts_are_written_as_a_list_of_impulses_that_renders(self):
        impulses = self.folder / "impacts.jsonl"
        scene = self.scene(kinds=[BALL["kinds"][0],
                                  {"name": "ball", "object": "die", "size": 0.9}])
        report, _ = self.perform(scene, "--impulses", impulses)
        lines = [json.loads(line) for line in impulses.read_text().splitlines()]
        self.assertEqual(len(lines), report["impacts"])
        self.assertEqual({line.get("size", 1) for line in lines}, {1, 0.9})
        played = self.json("render", "--impulses", impulses, "-o", self.folder / "impacts.wav")
        self.assertEqual(played["strikes"], report["impacts"])

    def test_written_impulses_name_their_object_files(self):
        here, there = self.folder / "here", self.folder / "there"
        for folder in here, there:
            folder.mkdir()
        # A different object with the name of a factory object.
        (here / "plate.modal").write_bytes((OBJECTS / "die.modal").read_bytes())
        kinds = [BALL["kinds"][0], {"name": "ball", "object": "plate.modal"}]
        scene = here / "scene.json"
        scene.write_text(json.dumps({**BALL, "kinds": kinds}))
        for folder, name in (here, "plate.modal"), (there, str(here / "plate.modal")):
            impulses = folder / "impacts.jsonl"
            report, _ = self.perform(scene, "--impulses", impulses)
            lines = [json.loads(line) for line in impulses.read_text().splitlines()]
            self.assertEqual({line["object"] for line in lines}, {"plate", name})
            played = self.json("render", "--impulses", impulses, "-o", self.folder / "x.wav")
            self.assertEqual(played["strikes"], report["impacts"])
        # The list and its objects move together.
        moved = here.rename(self.folder / "moved")
        self.succeed("render", "--impulses", moved / "impacts.jsonl", "-o", self.folder / "x.wav")

    def test_the_cylinder_rolls_in_impulses_as_in_the_paper(self):
        impulses = self.folder / "impacts.jsonl"
        self.perform("Cylinder off a table", "--impulses", impulses)
        on_table = [line["time"] for line in map(json.loads, impulses.read_text().splitlines())
                    if line["object"] == "long-table"]
        # Takes the times from the end of the landing to the edge. Impulses within a millisecond are
        # one impact.
        set_down = [time for before, time in zip(on_table, on_table[1:])
                    if 0.2 <= time < 1 and time - before > 0.001]
        steps = [later - time for time, later in zip(set_down, set_down[1:])]
        self.assertAlmostEqual(statistics.mean(steps), 0.017, delta=0.002)
        self.assertAlmostEqual(statistics.stdev(steps), 0.010, delta=0.003)

    def test_landings_in_the_middle_and_at_the_edge_have_different_spectra(self):
        scene = json.loads((OBJECTS.parent / "Scenes" / "03-cylinder-off-a-table.json").read_text())
        scene["bodies"][2].update(velocity=[0, 0, 0], spin=[0, 0, 0])
        levels = []
        for along in 0, 0.57:
            scene["bodies"][2]["at"] = [along, 0, 0.79]
            file = self.write("landing.json", json.dumps(scene))
            left = self.perform(file, "--seconds", "0.5", "--set", "tau=0.01")[1].left
            onset = next(i for i, x in enumerate(left) if x != 0)
            levels.append([loudest(left[onset:onset + 9600], band) for band in ((150, 225),
                                                                                (400, 600))])
        (middle_low, middle_high), (edge_low, edge_high) = levels
        # Modes with a node in the middle sound at the edge; other modes sound as before.
        self.assertGreater(edge_low - middle_low, 20)
        self.assertLess(abs(edge_high - middle_high), 6)

    def test_a_song_needs_a_scene_that_drops_bodies(self):
        song = self.write("song.mid", "")
        self.refuse("scene", self.scene(), "--midi", song, "-o", self.folder / "x.wav",
                    naming="Ball on a plate", saying="drops nothing")

    def test_a_scene_moved_only_by_notes_plays_the_factory_song(self):
        notes = {"notes": {"kind": "ball"}}
        waits = {**notes, "bodies": BALL["bodies"][:1]}
        taps = {**waits, "hand": {"kind": "plate", "tool": "ball", "taps": [[0.01, 0, 0, 0, 1]]}}
        for changes, plays in ((waits, True), (taps, False), (notes, False)):
            report, _ = self.perform(self.scene(**changes), "--seconds", 2)
            bodies = len(changes.get("bodies", BALL["bodies"]))
            self.assertEqual(report["bodies_most"] > bodies, plays)

    def test_too_many_bodies_in_one_place_are_refused(self):
        crowd = [{"kind": "ball", "count": 10000}]
        self.refuse("scene", self.scene(bodies=crowd), "-o", self.folder / "x.wav",
                    naming="Ball on a plate", saying="too many bodies in one place")

    def test_warning_and_report_give_the_same_peak_beyond_full_scale(self):
        said = self.succeed("scene", self.scene(), "-o", self.folder / "x.wav",
                            "--seconds", 0.5, "--set", "level=24", "--set", "limiter=0")
        told, level = re.search(r"peak of (\S+) dBFS.*level=(\S+)", said.stderr).groups()
        self.assertIn(f"peak {told} dBFS", said.stdout)
        self.assertLessEqual(float(level), 24 - float(told) + 0.05)

    def test_bad_scenes_get_one_sentence(self):
        self.refuse("scene", "No such scene", "-o", self.folder / "x.wav",
                    naming="No such scene", saying="'Dice on a xylophone'")
        too_long = 300 * "x"
        self.refuse("scene", too_long, "-o", self.folder / "x.wav",
                    naming=too_long, saying="neither a file nor one of the scenes")
        self.refuse("scene", self.scene(gravity="much"), "-o", self.folder / "x.wav",
                    naming="scene.json", saying="gravity is not a number")
        self.refuse("scene", self.write("broken.json", "{"), "-o", self.folder / "x.wav",
                    naming="broken.json", saying="line 1")
        missing = {"name": "ball", "object": "missing.modal"}
        self.refuse("scene", self.scene(kinds=[BALL["kinds"][0], missing]),
                    "-o", self.folder / "x.wav", naming="missing.modal")
