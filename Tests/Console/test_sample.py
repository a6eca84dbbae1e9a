import csv
import math
import re

from console import OBJECTS, ConsoleTest, Wave, midi_file, note

BAR = OBJECTS / "xylophone-72.modal"
SHORT = ("--tail", -40, "--seconds", 0.5, "--set", "room=0")


def decibels(ratio):
    return 20 * math.log10(ratio)


class Samples(ConsoleTest):
    def sample(self, instrument, *options, folder="out"):
        report = self.json("sample", instrument, "-o", self.folder / folder, *SHORT, *options)
        return report, self.folder / folder

    def regions(self, folder):
        """Returns the opcodes of each region of the SFZ file, with those of its headers."""
        text = re.sub(r"//.*", "", next(folder.glob("*.sfz")).read_text())
        inherited, regions = {"global": {}, "group": {}}, []
        for header, body in re.findall(r"<(\w+)>([^<]*)", text):
            opcodes = dict(re.findall(r"(\w+)=(\S+)", body))
            if header == "region":
                regions.append(inherited["global"] | inherited["group"] | opcodes)
            else:
                inherited[header] = opcodes
        return regions

    def test_keys_velocities_and_round_robins_are_files_and_regions(self):
        report, folder = self.sample("Marimba", "--keys", "60-64", "--every", 2, "--velocities", 2,
                                     "--round-robins", 2)
        self.assertEqual(report["samples"], 3 * 2 * 2)
        self.assertEqual(report["rendered"], 12)
        regions = self.regions(folder)
        self.assertEqual(len(regions), 12)
        for region in regions:
            wave = Wave(folder / region["sample"])
            self.assertEqual((wave.bits, wave.rate, wave.channel_count), (24, 48000, 2))
            self.assertEqual(region["loop_mode"], "one_shot")
            self.assertEqual(region["amp_veltrack"], "0")
        self.assertEqual([(r["lokey"], r["pitch_keycenter"], r["hikey"]) for r in regions[::4]],
                         [("60", "60", "61"), ("62", "62", "63"), ("64", "64", "64")])
        self.assertEqual({(r["lovel"], r["hivel"]) for r in regions}, {("1", "64"), ("65", "127")})
        turns = [(folder / r["sample"]).read_bytes() for r in regions[:2]]
        self.assertNotEqual(*turns)
        self.assertEqual([r["seq_position"] for r in regions[:2]], ["1", "2"])

    def test_a_sample_is_the_note_that_render_plays_with_the_stated_gain(self):
        report, folder = self.sample("Marimba", "--keys", "60-60", "--velocities", 1)
        song = self.write("note.mid", midi_file(note(0, 60, 127, 4800)))
        self.succeed("render", "--preset", "Marimba", "--midi", song, "-o",
                     self.folder / "note.wav", "--seconds", 0.5, "--set", "room=0",
                     "--set", "limiter=0")
        sampled = Wave(folder / report["files"][0]["file"])
        rendered = Wave(self.folder / "note.wav")
        gain = 10 ** (report["gain_db"] / 20)
        self.assertGreater(len(sampled), 4000)
        for mine, theirs in zip(sampled.left[:-480], rendered.left):
            self.assertAlmostEqual(mine, gain * theirs, delta=2e-7)
        self.assertAlmostEqual(float(self.regions(folder)[0]["volume"]), -report["gain_db"])
        self.assertAlmostEqual(report["files"][0]["peak_dbfs"], -3, delta=0.2)

    def test_an_export_goes_on_with_missing_files_and_refuses_other_settings(self):
        options = ("--keys", "60-61", "--velocities", 2)
        report, folder = self.sample("Marimba", *options)
        files = [folder / each["file"] for each in report["files"]]
        before = [file.read_bytes() for file in files]
        files[1].unlink()
        again, _ = self.sample("Marimba", *options)
        self.assertEqual(again["rendered"], 1)
        self.assertEqual([file.read_bytes() for file in files], before)
        self.assertEqual(again["files"], report["files"])
        self.refuse("sample", "Marimba", "-o", folder, *SHORT, *options, "--set", "hardness=20",
                    naming=folder, saying="other settings")
        self.refuse("sample", "Marimba", "-o", folder, *SHORT, *options, "--sample-rate", 44100,
                    naming=folder, saying="other settings")

    def test_released_keys_are_damped_where_the_preset_damps_them(self):
        _, folder = self.sample("Marimba", "--keys", "60-60", "--velocities", 1, "--set",
                                "let_ring=0", "--set", "release=0.3")
        region = self.regions(folder)[0]
        self.assertEqual(region["loop_mode"], "no_loop")
        self.assertEqual(float(region["ampeg_release"]), 0.3)

    def test_flac_has_the_samples_of_wav(self):
        options = ("--keys", "60-60", "--velocities", 1)
        wav, _ = self.sample("Marimba", *options)
        flac, folder = self.sample("Marimba", *options, "--format", "flac", folder="flac")
        self.assertEqual((folder / flac["files"][0]["file"]).read_bytes()[:4], b"fLaC")
        for figure in ("peak_dbfs", "loudest_moment_lufs", "seconds"):
            self.assertEqual(wav["files"][0][figure], flac["files"][0][figure])

    def test_places_and_velocities_of_an_object_have_a_table(self):
        report, folder = self.sample(BAR, "--places", 3, "--velocities", 2)
        self.assertEqual([each["file"] for each in report["files"]],
                         [f"p{place:02}-v{velocity:03}.wav" for place in (1, 2, 3)
                          for velocity in (64, 127)])
        with open(folder / "samples.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual(len(rows), 6)
        places = {(row["x_m"], row["y_m"], row["z_m"]) for row in rows}
        self.assertEqual(len(places), 3)
        for row in rows:
            wave = Wave(folder / row["file"])
            self.assertAlmostEqual(decibels(wave.peak()), float(row["peak_dbfs"]), delta=1)
            self.assertAlmostEqual(len(wave) / wave.rate, float(row["seconds"]), places=4)
        for soft, hard in zip(rows[::2], rows[1::2]):
            self.assertLess(float(soft["loudest_moment_lufs"]) + 3,
                            float(hard["loudest_moment_lufs"]))
        self.assertEqual(list(folder.glob("*.sfz")), [])

    def test_a_place_sounds_as_strike_plays_it(self):
        report, folder = self.sample(BAR, "--places", 1, "--velocities", 1)
        place = ",".join(map(str, report["files"][0]["place_m"]))
        self.succeed("strike", BAR, "--at", place, "--velocity", 127, "-o",
                     self.folder / "strike.wav", "--seconds", 0.5, "--set", "limiter=0",
                     "--set", "spread=0")
        sampled = Wave(folder / report["files"][0]["file"])
        struck = Wave(self.folder / "strike.wav")
        self.assertAlmostEqual(decibels(sampled.peak() / struck.peak()), report["gain_db"],
                               delta=0.1)

    def test_bad_choices_get_one_sentence(self):
        out = self.folder / "out"
        for options, naming in ((("--places", 3, "--every", 2), "--every"),
                                (("--places", 3, "--round-robins", 2), "--round-robins"),
                                (("--places", 3, "--keys", "60-61"), "--keys"),
                                (("--places", 0), "--places"),
                                (("--places", 999), "only")):
            self.refuse("sample", BAR, "-o", out, *options, naming=naming)
        for options, naming in ((("--keys", "1-2"), "--keys"),
                                (("--keys", "64-60"), "--keys"),
                                (("--keys", "60"), "--keys"),
                                (("--every", 0), "--every"),
                                (("--velocities", 0), "--velocities"),
                                (("--tail", 0), "--tail"),
                                (("--format", "mp3"), "--format"),
                                (("--bit-depth", 32), "--bit-depth"),
                                (("--round-robins", 2, "--set", "spread=0"), "equal")):
            self.refuse("sample", "Marimba", "-o", out, *options, naming=naming)
        self.refuse("sample", "Marimba", naming="--output")
        self.refuse("sample", "Dice on Rosewood", "-o", out, naming="scene")
        self.refuse("sample", "Scraped Plate", "-o", out, naming="scrapes")
        self.refuse("sample", BAR, "-o", out, naming=BAR.name, saying="--places")
        self.refuse("sample", "Marimba", "-o", self.write("file", "") / "out", *SHORT,
                    naming="file", saying="cannot be created")
