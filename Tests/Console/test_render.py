import json
import math
import sys
import unittest

from console import OBJECTS, ConsoleTest, Wave, midi_file, note, run, tempo

XYLOPHONE = "Rosewood Xylophone"


class Render(ConsoleTest):
    def render(self, song, *options, preset=XYLOPHONE, name="render.wav"):
        output = self.folder / name
        report = self.json("render", "--preset", preset, "--midi", song, "-o", output, *options)
        return report, output

    def song(self, *tracks, name="song.mid", **how):
        return self.write(name, midi_file(*tracks, **how))

    def chords(self):
        """Returns chords, a repeated note, a pedal and a bend, at times off the grid."""
        events = [(0, bytes([0xB0, 64, 127]))]
        for i, ticks in enumerate((0, 131, 307, 310, 733, 1201)):
            events += note(ticks, 72 + 3 * i, 40 + 14 * i, 97) + note(ticks, 79 + 2 * i, 90, 97)
        events += note(1400, 72, 100, 10) + note(1410, 72, 100, 10)
        events += [(1450, bytes([0xB0, 64, 0])), (1500, bytes([0xE0, 0, 90]))]
        return events

    def test_block_sizes_give_the_same_file(self):
        song = self.song(self.chords())
        for preset in (XYLOPHONE, "Singing Xylophone", "Steel Ring", "Scraped Plate"):
            options = ("--set", "tau=20", "--set", "level=-6")
            _, expected = self.render(song, *options, preset=preset, name="480.wav")
            for size in (1, 7, 64, 480, 4096):
                _, output = self.render(song, "--block-size", size, *options, preset=preset)
                with self.subTest(preset=preset, block_size=size):
                    self.assertEqual(output.read_bytes(), expected.read_bytes())

    def test_a_note_of_a_scene_preset_is_as_loud_as_other_presets_and_does_not_clip(self):
        song = self.song(note(0, 66, 100))
        scenes = [p["name"] for p in self.json("presets") if p["keyMap"]["kind"] == "scene"]
        self.assertGreaterEqual(len(scenes), 6)
        for preset in scenes:
            report, _ = self.render(song, "--seconds", 10, "--set", "limiter=0", preset=preset)
            with self.subTest(preset=preset):
                # A single die is fainter: a roll of dice adds up. Paths of a tube and a pebble
                # amplify roundings, which differ between compilers and processors: from starts
                # that differ by micrometres they vary by 5.5 and 5.7 dB.
                delta = {"Dice on Rosewood": 4, "Falling Cylinder": 4,
                         "Pebble in a Wok": 6}.get(preset, 1.5)
                self.assertAlmostEqual(report["integrated_lufs"], -26, delta=delta)
                self.assertLess(report["peak_dbfs"], 1)

    def test_the_room_decays_fully_in_any_block_size(self):
        song = self.song([tempo(0, 500000)] + note(0, 84, 127))
        dry, _ = self.render(song)
        room = ("--set", "room=100", "--set", "room_decay=2")
        wet, expected = self.render(song, *room, name="480.wav")
        # The decay to -100 dB from the level at the dry sound's end.
        self.assertGreater(wet["seconds"], dry["seconds"] + 1)
        self.assertLess(wet["seconds"], dry["seconds"] + 2 * 100 / 60 + 0.5)
        for size in (7, 4096):
            _, output = self.render(song, "--block-size", size, *room)
            self.assertEqual(output.read_bytes(), expected.read_bytes())

    def test_all_sound_off_ends_the_room(self):
        song = [tempo(0, 500000)] + note(0, 84, 127)
        room = ("--set", "room=100", "--set", "room_decay=10")
        rings, _ = self.render(self.song(song), *room)
        hushed, _ = self.render(self.song(song + [(480, bytes([0xB0, 120, 0]))]), *room)
        self.assertLess(hushed["seconds"], rings["seconds"] / 2)

    def test_all_sound_off_in_a_room_gives_the_same_file_in_any_block_size(self):
        song = [tempo(0, 500000)] + note(0, 84, 127)
        song += [(337, bytes([0xB0, 120, 0]))] + note(337, 72, 100)
        song += [(480, bytes([0xB1, 120, 0]))] + note(485, 74, 100)
        room = ("--set", "room=100", "--set", "room_decay=2")
        _, expected = self.render(self.song(song), *room, name="64.wav")
        for size in (1, 300, 4096):
            _, output = self.render(self.song(song), "--block-size", size, *room)
            self.assertEqual(output.read_bytes(), expected.read_bytes())

    def test_a_render_repeats_bit_for_bit(self):
        song = self.song(self.chords())
        first, second = (self.render(song, name=f"{i}.wav")[1] for i in range(2))
        self.assertEqual(first.read_bytes(), second.read_bytes())

    def test_a_note_sounds_from_its_sample_until_silence(self):
        song = self.song([tempo(0, 500000)] + note(337, 72, 127))
        for rate in (44100, 48000):
            _, output = self.render(song, "--sample-rate", rate)
            wave = Wave(output)
            first = next(i for i, sample in enumerate(wave.left) if sample != 0)
            # A contact begins without force, so its first samples may be lost in rounding.
            self.assertAlmostEqual(first, 337 / 960 * rate, delta=2)
            self.assertTrue(any(channel[-1] != 0 for channel in wave.channels))

    def test_a_scale_and_a_mapping_tune_the_keys(self):
        song = self.song([tempo(0, 500000)] + note(0, 81, 100))
        steps = "".join(f"{100.0 * step}\n" for step in range(1, 13))
        scale = self.write("equal.scl", b"Equal\n12\n" + steps.encode())
        mapping = self.write("low.kbm", b"0\n0\n127\n60\n69\n432\n0\n")
        plain = self.render(song, name="plain.wav")[1].read_bytes()
        self.assertEqual(self.render(song, "--scale", scale)[1].read_bytes(), plain)
        self.assertNotEqual(self.render(song, "--mapping", mapping)[1].read_bytes(), plain)
        lower = self.render(song, "--set", "a4=432", name="lower.wav")[1]
        mapped = self.render(song, "--scale", scale, "--mapping", mapping)[1]
        first, second = (Wave(file).left for file in (lower, mapped))
        loudest = max(map(abs, first))
        self.assertLess(max(abs(a - b) for a, b in zip(first, second)), 4e-3 * loudest)

    def test_a_bad_tuning_gets_one_sentence(self):
        song = self.song([tempo(0, 500000)] + note(0, 81, 100))
        bad = self.write("bad.scl", b"title\n3\n3/2\n")
        failed = run("render", "--preset", XYLOPHONE, "--midi", song, "-o",
                     self.folder / "bad.wav", "--scale", bad)
        self.assertNotEqual(failed.returncode, 0)
        self.assertIn("bad.scl ends before note 2 of its 3.", failed.stderr)

    def test_radiation_separates_the_channels_and_zero_width_joins_them(self):
        song = self.song([tempo(0, 500000)] + note(0, 72, 127))

        def channels(*settings):
            options = [part for setting in ("room=0",) + settings
                       for part in ("--set", setting)]
            return [list(channel) for channel in Wave(self.render(song, *options)[1]).channels]

        near = channels("radiation=0")
        self.assertEqual(near[0], near[1])
        far = channels("radiation=60", "strike_across=80")
        self.assertNotEqual(far[0], far[1])
        joined = channels("radiation=60", "strike_across=80", "width=0")
        self.assertEqual(joined[0], joined[1])
        wide = channels("radiation=60", "strike_across=80", "width=200")
        for left, right, l, r in list(zip(*wide, *far))[:4000]:
            self.assertAlmostEqual(left - right, 2 * (l - r), delta=1e-6)

    def test_a_held_key_scrapes_for_as_long_as_it_is_held(self):
        def scraped(length):
            song = self.song([tempo(0, 500000)] + note(0, 60, length=length))
            return Wave(self.render(song, "--set", "let_ring=off", "--set", "release=0.05",
                                    "--set", "room=0",
                                    preset="Scraped Plate")[1])

        short, long = scraped(480), scraped(1920)
        self.assertGreater(short.peak(), 1e-4)
        self.assertAlmostEqual(len(long) - len(short), 1.5 * long.rate, delta=0.05 * long.rate)

    def test_pressure_at_the_time_of_a_key_applies_to_that_key(self):
        def level(*pressures):
            events = [(ticks, bytes([0xD0, 10])) for ticks in pressures]
            song = self.song(events + note(0, 60, 127, 960))
            wave = Wave(self.render(song, preset="Scraped Plate")[1])
            return 10 * math.log10(sum(sample * sample for sample in wave.left))

        self.assertLess(level(0), level() - 6)
        self.assertAlmostEqual(level(0), level(1), delta=0.5)

    def test_tempo_changes_are_followed(self):
        slow = note(0, 72) + note(480, 84, length=120) + note(960, 76)
        fast = note(0, 72) + note(240, 84, length=60) + note(720, 76)
        with_map = self.song([tempo(0, 250000)] + slow[:2] + [tempo(480, 500000)] + slow[2:])
        plain = self.song([tempo(0, 500000)] + fast, name="plain.mid")
        self.assert_same_sound(with_map, plain)

    def test_a_tempo_without_its_bytes_is_ignored(self):
        notes = note(0, 72) + note(480, 84)
        plain = self.song(notes, name="plain.mid")
        text = (0, b"\xff\x01\x28" + b"\x01\x86\xa0" * 13 + b"x")
        for cut in (b"\xff\x51\x00", b"\xff\x51\x02\x01\x86"):
            self.assert_same_sound(self.song([text, (0, cut)] + notes), plain)

    def test_chunks_that_are_not_tracks_are_skipped(self):
        plain = self.song(note(0, 72), note(480, 76), name="plain.mid")
        song, foreign = plain.read_bytes(), b"XFIH\0\0\0\5words"
        first, second = song.index(b"MTrk"), song.rindex(b"MTrk")
        counted = song[:11] + bytes([song[11] + 1]) + song[12:]
        for content in (counted[:second] + foreign + counted[second:],
                        song[:first] + foreign + song[first:],
                        song[:second] + foreign + song[second:], song + foreign, song + bytes(7)):
            self.assert_same_sound(self.write("foreign.mid", content), plain)
        for cut in (song[:second], song[:second] + foreign[:-1], counted[:second] + foreign):
            self.refuse("render", "--preset", XYLOPHONE, "--midi", self.write("cut.mid", cut),
                        "-o", self.folder / "cut.wav", naming="cut.mid")

    @unittest.skipIf(sys.platform == "win32", "permissions of POSIX")
    def test_a_file_rendered_again_keeps_its_permissions(self):
        output = self.render(self.song(note(0, 72)), "--seconds", 0.1)[1]
        output.chmod(0o640)
        self.render(self.song(note(0, 84)), "--seconds", 0.1)
        self.assertEqual(output.stat().st_mode & 0o777, 0o640)

    def test_smpte_time_is_followed(self):
        beats = self.song([tempo(0, 500000)] + note(0, 72, length=48) + note(96, 84, length=48),
                          division=480)
        # 25 frames of 40 ticks are 1000 ticks a second.
        frames = self.song(note(0, 72, length=50) + note(100, 84, length=50), name="smpte.mid",
                           division=-25 * 256 + 40)
        self.assert_same_sound(beats, frames)

    def test_tracks_are_merged(self):
        one, other = note(0, 72) + note(480, 74), note(0, 84) + note(300, 86)
        merged = self.song(one + other)
        tracks = self.song([tempo(0, 500000)], one, other, name="tracks.mid")
        self.assert_same_sound(merged, tracks)

    def test_simultaneous_events_keep_the_order_of_their_track(self):
        def rings(*tracks):
            song = self.song([tempo(0, 500000)], *tracks)
            report, _ = self.render(song, "--set", "let_ring=off", "--set", "release=0.05",
                                    "--set", "room=0",
                                    preset="Singing Xylophone")
            return report["seconds"]

        def pedal(value):
            return [(480, bytes([0xB0, 64, value]))]

        key = note(0, 72, length=480)
        self.assertLess(rings(key + pedal(127)), 0.8)
        self.assertGreater(rings(pedal(127) + key), 1)
        # Messages of other tracks come before notes.
        self.assertGreater(rings(key, pedal(127)), 1)

    def test_a_key_struck_again_as_it_is_released_is_down(self):
        repeated = (note(0, 72, length=480) + note(480, 72, length=480))
        upside_down = [repeated[0], repeated[2], repeated[1], repeated[3]]
        self.assert_same_sound(self.song(repeated), self.song(upside_down, name="b.mid"),
                               preset="Singing Xylophone")

    def test_keys_struck_again_beside_another_key_are_down(self):
        ends = note(0, 72, length=480) + note(0, 76, length=480)
        begins = note(480, 74, length=480) + note(480, 76, length=480)
        tidy = self.song(ends + begins)
        begins_first = self.song(ends[::2] + begins + ends[1::2], name="b.mid")
        self.assert_same_sound(tidy, begins_first, preset="Singing Xylophone")

    def test_a_note_without_length_ends(self):
        for others in ([], note(0, 74, length=480), note(240, 76, length=0)):
            song = self.song([tempo(0, 500000)] + others[:1] + note(0, 76, length=0) + others[1:])
            report, _ = self.render(song, "--set", "let_ring=off", "--set", "release=0.05",
                                    "--set", "room=0",
                                    preset="Singing Xylophone")
            self.assertLess(report["seconds"], 0.8)

    def assert_same_sound(self, one, other, preset=XYLOPHONE):
        waves = [self.render(song, preset=preset, name=f"{i}.wav")[1].read_bytes()
                 for i, song in enumerate((one, other))]
        self.assertEqual(waves[0], waves[1])

    def test_statistics_match_the_file(self):
        statistics = self.folder / "stats.json"
        report, output = self.render(self.song(self.chords()), "--stats", statistics)
        wave, stats = Wave(output), json.loads(statistics.read_text())
        self.assertEqual(stats, report)
        self.assertEqual(stats["samples"], len(wave))
        self.assertEqual(stats["strikes"], 14)
        peak = max(abs(sample) for channel in wave.channels for sample in channel)
        self.assertAlmostEqual(10 ** (stats["peak_dbfs"] / 20), peak, places=6)
        self.assertLess(stats["integrated_lufs"], stats["peak_dbfs"])
        self.assertGreater(stats["modes_mixed_max"], stats["modes_mixed_mean"])
        self.assertGreater(stats["cpu_share"], 0)

    def test_the_budget_limits_the_modes_mixed(self):
        song = self.song(sum((note(0, 72 + i, 127) for i in range(0, 36, 4)), []))
        report, _ = self.render(song, "--set", "budget=50", "--set", "tau=0.001")
        self.assertGreater(report["modes_mixed_max"], 25)
        self.assertLessEqual(report["modes_mixed_max"], 50)

    def test_parameters_are_set_in_their_units(self):
        song = self.song(note(0, 72))
        peaks = [Wave(self.render(song, "--set", f"level={level}")[1]).peak()
                 for level in ("-20 dB", "-14")]
        self.assertAlmostEqual(peaks[1] / peaks[0], 10 ** 0.3, places=4)

    def test_the_length_is_as_requested(self):
        song = self.song(note(0, 72) + note(4800, 74))
        for seconds in (0.25, 12):
            report, output = self.render(song, "--seconds", seconds)
            self.assertEqual(len(Wave(output)), 48000 * seconds)
            self.assertEqual(report["strikes"], 1 if seconds < 1 else 2)

    def warnings(self, song, *options, preset=XYLOPHONE):
        """Renders half a second; returns the text on standard error and the file."""
        output = self.folder / "warned.wav"
        stderr = self.succeed("render", "--preset", preset, "--midi", song, "-o", output,
                              "--seconds", 0.5, *options).stderr
        return stderr, output.read_bytes()

    def test_a_figure_makes_the_material_custom_and_keeps_the_other_figures(self):
        song = self.song(note(0, 72, 127))

        def sound(*settings):
            said, _ = self.warnings(song, *(part for s in settings for part in ("--set", s)))
            self.assertEqual(said, "")
            return Wave(self.folder / "warned.wav").left

        def custom(name, **changes):
            m = next(m for m in self.json("materials") if m["name"] == name)
            figures = {"young": m["youngs_modulus_pa"] / 1e9, "density": m["density_kg_per_m3"],
                       "gamma": max(0.01, m["fluid_damping_per_s"]),
                       "loss_factor": m["loss_factor"],
                       "eta": max(1e-4, m["viscoelastic_damping_s"] * 1e6), **changes}
            return sound("material=Custom", *(f"{id}={value}" for id, value in figures.items()))

        for settings, expected in ((["young=50"], custom("Rosewood", young=50)),
                                   (["young=50000 MPa"], custom("Rosewood", young=50)),
                                   (["gamma=200", "material=Glass"], custom("Glass", gamma=200)),
                                   (["material=Glass", "gamma=200"], custom("Glass", gamma=200))):
            heard = sound(*settings)
            self.assertLess(max(abs(a - b) for a, b in zip(heard, expected)),
                            1e-4 * max(map(abs, expected)))
        own, light, heavy = (sound("mallet=Hard rubber", *mass)
                             for mass in ((), ["mallet_mass=25"], ["mallet_mass=250"]))
        loudest = max(map(abs, own))
        self.assertLess(max(abs(a - b) for a, b in zip(own, light)), 1e-4 * loudest)
        self.assertGreater(max(map(abs, heavy)), 1.05 * loudest)  # limited by the bar's mass

    def test_parameters_without_effect_are_named(self):
        plate, dice = "Steel Plate", "Dice on Rosewood"
        strike = ("contact=Strike",)
        for preset, setting, elsewhere in (
                (XYLOPHONE, "force=20", ("contact=Scrape",)),
                (XYLOPHONE, "speed=3", ("contact=Roll",)),
                (XYLOPHONE, "roughness=5", ("contact=Scrape",)),
                (XYLOPHONE, "roll_coupling=80", ("contact=Roll",)),
                ("Scraped Plate", "chatter=100", strike),
                ("Scraped Plate", "spread=100", strike),
                ("Scraped Plate", "mallet=Yarn", strike), ("Scraped Plate", "mallet_hardness=9", strike),
                ("Scraped Plate", "velocity_curve=4", strike),
                (XYLOPHONE, "release=2", ("let_ring=off",)),
                ("Scraped Plate", "release=2", ("let_ring=off",)),
                (XYLOPHONE, "motor_speed=9", ("motor_depth=100",)),
                (XYLOPHONE, "motor_sync=1/4", None), (plate, "motor_depth=90", None),
                (XYLOPHONE, "room_decay=5", ("room=50",)),
                (XYLOPHONE, "thickness=50", None), (XYLOPHONE, "outputs=Octaves", None),
                (plate, "keep_pitch=off", None), (dice, "keep_pitch=off", None),
                (plate, "width=0", ("radiation=100", "strike_across=50")),
                (dice, "chatter=100", None), (dice, "let_ring=off", None)):
            name = setting.split("=")[0]
            song = self.song(note(0, 70, 50, 120))
            with self.subTest(preset=preset, setting=setting):
                off = () if elsewhere in (None, strike) else ("--set", "radiation=0", "--set", "room=0")
                _, without = self.warnings(song, *off, preset=preset)
                said, heard = self.warnings(song, *off, "--set", setting, preset=preset)
                self.assertEqual(said.count("\n"), 1, said)
                self.assertIn(f"--set {name} has no effect", said)
                self.assertEqual(heard, without)
                if elsewhere is None:
                    continue
                there = [part for other in elsewhere for part in ("--set", other)]
                _, without = self.warnings(song, *there, preset=preset)
                said, heard = self.warnings(song, *there, "--set", setting, preset=preset)
                self.assertEqual(said, "")
                self.assertNotEqual(heard, without)

    def test_release_acts_by_pressure_only_where_keys_are_struck(self):
        pressed = self.song(note(0, 70, length=960) + [(48, bytes([0xd0, 127])), (480, bytes([0xd0, 0]))])
        for preset, acts in ((XYLOPHONE, True), ("Scraped Plate", False)):
            _, without = self.warnings(pressed, preset=preset)
            said, heard = self.warnings(pressed, "--set", "release=2", preset=preset)
            self.assertEqual("--set release has no effect" in said, not acts, preset)
            self.assertEqual(heard != without, acts, preset)

    def test_a_free_motor_sync_gives_no_warning(self):
        song = self.song(note(0, 72))
        self.assertEqual(self.warnings(song, "--set", "motor_sync=Free")[0], "")

    def test_a_scale_that_keys_cannot_follow_gives_a_warning(self):
        song = self.song(note(0, 72))
        scale = self.write("half.scl", b"Half\n2\n600.\n2/1\n")
        said, heard = self.warnings(song, "--scale", scale, preset="Steel Plate")
        self.assertEqual(said.count("\n"), 1)
        self.assertIn("--scale has no effect, because the keys of 'Steel Plate'", said)
        self.assertEqual(heard, self.warnings(song, preset="Steel Plate")[1])
        self.assertEqual(self.warnings(song, "--scale", scale)[0], "")

    def test_some_notes_off_the_keyboard_are_counted(self):
        said, _ = self.warnings(self.song(note(0, 20) + note(10, 72) + note(20, 109) + note(30, 108)))
        self.assertIn("2 of 4 notes are no key of 'Rosewood Xylophone', which plays 21 to 108", said)
        self.assertEqual(self.warnings(self.song(note(0, 21) + note(10, 108)))[0], "")

    def test_notes_off_the_keyboard_give_a_warning(self):
        song = self.song(note(0, 20) + note(480, 120))
        output = self.folder / "out.wav"
        result = run("render", "--preset", XYLOPHONE, "--midi", song, "-o", output)
        self.assertEqual(result.returncode, 0)
        self.assertIn("warning", result.stderr)
        self.assertIn(str(song), result.stderr)
        self.assertIn("21 to 108", result.stderr)
        self.assertEqual(Wave(output).peak(), 0)

    def test_a_preset_file_plays_like_the_preset(self):
        preset = next(p for p in self.json("presets") if p["name"] == "Steel Plate")
        file = self.write("mine.json", json.dumps(preset))
        song = self.song(note(0, 60))
        by_name, by_file = (self.render(song, preset=p, name=f"{i}.wav")[1].read_bytes()
                            for i, p in enumerate(("steel plate", file)))
        self.assertEqual(by_name, by_file)

    def test_objects_are_found_beside_their_preset(self):
        preset = next(p for p in self.json("presets") if p["name"] == "Steel Plate")
        (self.folder / "bank" / "Objects").mkdir(parents=True)
        self.write("bank/Objects/mine.modal", (OBJECTS / "plate.modal").read_bytes())
        preset["keyMap"]["object"] = "Objects/mine.modal"
        file = self.write("bank/mine.json", json.dumps(preset))
        song = self.song(note(0, 60))
        own, factory = (self.render(song, preset=p, name=f"{i}.wav")[1].read_bytes()
                        for i, p in enumerate((file, "Steel Plate")))
        self.assertEqual(own, factory)

    def test_unknown_parameters_of_a_preset_give_a_warning(self):
        preset = self.json("presets")[0]
        preset["parameters"]["from_the_future"] = 1
        file = self.write("mine.json", json.dumps(preset))
        result = self.succeed("render", "--preset", file, "--midi", self.song(note(0, 72)), "-o",
                              self.folder / "out.wav")
        self.assertIn("from_the_future", result.stderr)
