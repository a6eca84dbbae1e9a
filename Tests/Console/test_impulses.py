import json
import math
import os
import struct
import unittest

from console import OBJECTS, ConsoleTest, Wave, most_memory_bytes, run


TAU = 0.001
# In either sound each of the plate's modes may be off by τ, in 65536ths of full scale.
PLATE_MODES = json.loads(run("info", OBJECTS / "plate.modal", "--json").stdout)["mode_count"]
TRUNCATED = 2 * PLATE_MODES * TAU / 65536


class Impulses(ConsoleTest):
    def lines(self, *impulses, name="impulses.jsonl"):
        return self.write(name, "".join(json.dumps(i) + "\n" for i in impulses))

    def render(self, file, *options, name="impulses.wav"):
        output = self.folder / name
        report = self.json("render", "--impulses", file, "-o", output, *options)
        return report, output

    def hit(self, time=0.0, impulse=(0, 0, -0.001), **more):
        where = {} if "vertex" in more else {"point": [0.05, 0.03, 0]}
        return {"time": time, "object": "plate", "impulse": list(impulse), "contact_time": 0.0005,
                **where, **more}

    def test_the_order_of_lines_does_not_matter(self):
        hits = [self.hit(0.01), self.hit(0.1, object="ring", point=[0.07, 0, 0]), self.hit(0.3)]
        sorted_, shuffled = (self.render(self.lines(*order), "--seconds", 0.5, name=f"{i}.wav")[1]
                             for i, order in enumerate((hits, [hits[2], hits[0], hits[1]])))
        self.assertEqual(sorted_.read_bytes(), shuffled.read_bytes())

    def test_block_sizes_give_the_same_file(self):
        file = self.lines(self.hit(0.01), self.hit(0.0203), self.hit(0.05, body=2))
        sounds = {size: self.render(file, "--block-size", size, "--set", "tau=5")[1].read_bytes()
                  for size in (1, 7, 64, 480, 4096)}
        for size, sound in sounds.items():
            self.assertEqual(sound, sounds[64], f"block size {size}")

    def test_sound_is_linear_in_the_impulse(self):
        waves = [Wave(self.render(self.lines(self.hit(impulse=(0, 0, -push))), "--set", f"tau={TAU}",
                                  "--seconds", 0.2)[1]) for push in (0.001, 0.002)]
        for single, double in zip(waves[0].left, waves[1].left):
            self.assertAlmostEqual(double, 2 * single, delta=1.5 * TRUNCATED)
        self.assertGreater(waves[1].peak(), 500 * TRUNCATED)

    def test_impulses_along_a_thin_plate_are_100_times_fainter_than_across(self):
        across, along = (Wave(self.render(self.lines(self.hit(impulse=i)), "--seconds", 0.2)[1])
                         for i in ((0, 0, -0.001), (0.001, 0, 0)))
        self.assertGreater(across.peak(), 100 * along.peak())

    def test_bodies_of_one_object_ring_independently(self):
        # After 5 ms a second impulse meets a ringing body, and the two add linearly. One body and
        # two sound alike, but the modes of each body are counted.
        def modes(*bodies):
            hits = [self.hit(0.005 * i, body=body) for i, body in enumerate(bodies)]
            report, output = self.render(self.lines(*hits), "--seconds", 0.1, "--set", f"tau={TAU}")
            return report["modes_mixed_max"], Wave(output)
        (one_count, one), (two_count, two) = modes("a", "a"), modes("a", "b")
        self.assertGreater(two_count, 1.5 * one_count)
        for a, b in zip(one.left, two.left):
            self.assertAlmostEqual(a, b, delta=TRUNCATED)
        self.assertGreater(one.peak(), 500 * TRUNCATED)

    def test_an_impulse_sounds_as_the_format_page_says(self):
        plate = OBJECTS / "plate.modal"
        raw = plate.read_bytes()
        size, = struct.unpack_from("<Q", raw)
        header = json.loads(raw[8:8 + size])
        material = json.loads(header["__metadata__"]["material"])

        def tensor(name, letter, count):
            begin = 8 + size + header[name]["data_offsets"][0]
            return struct.unpack_from(f"<{count}{letter}", raw, begin)
        modes = header["eigenvalues"]["shape"][0]
        letter = {"F16": "e", "F32": "f"}[header["shapes"]["dtype"]]
        ringing = []
        for stiffness, across in zip(tensor("eigenvalues", "d", modes),
                                     tensor("shapes", letter, 3 * modes)[2::3]):
            decay = (material["fluid_damping_per_s"] + material["loss_factor"] * stiffness ** 0.5
                     + material["viscoelastic_damping_s"] * stiffness) / 2
            ringing.append((0.001 * across ** 2, decay, (stiffness - decay ** 2) ** 0.5))

        hit = {"time": 0, "object": "plate", "vertex": tensor("shape_vertices", "i", 1)[0],
               "impulse": [0, 0, -0.001]}
        wave = Wave(self.render(self.lines(hit), "--seconds", 0.01, "--set", "compression=0", "--set",
                                f"tau={TAU}", "--set", "limiter=0")[1])
        for sample, heard in enumerate(wave.left):
            t = sample / 48000
            expected = sum(a * math.exp(-decay * t) * (math.cos(omega * t)
                                                       - decay / omega * math.sin(omega * t))
                           for a, decay, omega in ringing)
            self.assertAlmostEqual(heard, expected, delta=1e-6 * wave.peak())

    def test_impulses_act_at_their_time(self):
        for time in (0.1, 0.123456):
            wave = Wave(self.render(self.lines(self.hit(time)), "--seconds", 0.2)[1])
            first = next(i for i, sample in enumerate(wave.left) if sample != 0)
            self.assertAlmostEqual(first, time * 48000, delta=2)

    def test_a_vertex_equals_its_point(self):
        struck = self.json("strike", self.object_file("plate"), "-o", self.folder / "s.wav", "--at",
                           "0.02,0.01,0")
        hits = (self.hit(vertex=struck["vertex"]), self.hit(point=struck["point_m"]))
        waves = [Wave(self.render(self.lines(hit), "--seconds", 0.1)[1]) for hit in hits]
        for a, b in zip(waves[0].left, waves[1].left):
            self.assertAlmostEqual(a, b, delta=1e-5 * waves[0].peak())

    def object_file(self, name):
        from console import OBJECTS
        return OBJECTS / f"{name}.modal"

    def test_file_names_are_relative_to_the_folder_of_the_list(self):
        (self.folder / "modèles").mkdir()
        (self.folder / "modèles" / "mine.modal").write_bytes(self.object_file("plate").read_bytes())
        mine, theirs = (self.render(self.lines(self.hit(object=name)), "--seconds", 0.1,
                                    name=f"{i}.wav")[1].read_bytes()
                        for i, name in enumerate(("modèles/mine.modal", "plate")))
        self.assertEqual(mine, theirs)

    def test_a_byte_order_mark_is_ignored(self):
        line = json.dumps(self.hit()) + "\n"
        plain = self.render(self.write("plain.jsonl", line), name="plain.wav")[1]
        for text in (line, "# a comment\n" + line):
            marked = self.render(self.write("marked.jsonl", "\ufeff" + text), name="marked.wav")[1]
            self.assertEqual(marked.read_bytes(), plain.read_bytes())

    def test_no_object_of_the_list_is_overwritten(self):
        content = (OBJECTS / "plate.modal").read_bytes()
        object = self.write("plate.modal", content)
        list_ = self.lines(self.hit(object="./plate.modal"), self.hit(0.1))
        self.refuse("render", "--impulses", list_, "-o", object, naming=list_,
                    saying="line 1: './plate.modal' is the output file")
        self.assertEqual(object.read_bytes(), content)

    def test_comments_and_blank_lines_are_skipped(self):
        file = self.write("list.jsonl", "# contacts\n\n" + json.dumps(self.hit()) + "\r\n\n")
        self.assertEqual(self.render(file, "--seconds", 0.1)[0]["strikes"], 1)

    def test_a_presets_parameters_apply(self):
        file = self.lines(self.hit())
        peaks = [Wave(self.render(file, "--seconds", 0.1, "--preset", "Steel Plate", "--set",
                                  f"level={level}")[1]).peak() for level in (-20, 0)]
        self.assertAlmostEqual(peaks[1] / peaks[0], 10, places=3)

    def test_a_figure_makes_the_material_custom(self):
        file = self.lines(self.hit())
        own, same, damped = (self.render(file, "--seconds", 0.5, *figure, name=f"{i}.wav")[1]
                             for i, figure in enumerate(((), ("--set", "young=200"),
                                                         ("--set", "gamma=500"))))
        # Steel, but with a viscoelastic damping of 0, which the parameter cannot have.
        self.assertAlmostEqual(Wave(same).level_at(539, 12000) / Wave(own).level_at(539, 12000), 1,
                               places=3)
        self.assertLess(Wave(damped).level_at(539, 12000), 0.01 * Wave(own).level_at(539, 12000))

    def test_a_figure_does_not_make_bodies_of_several_materials_alike(self):
        file = self.lines(self.hit(), self.hit(object="table"))
        said, sounds = [], []
        for settings in ((), ("--set", "gamma=500"),
                         ("--set", "gamma=500", "--set", "material=Glass"),
                         ("--set", "material=Glass")):
            output = self.folder / f"{len(sounds)}.wav"
            said.append(self.succeed("render", "--impulses", file, "-o", output, "--seconds", 0.2,
                                     *settings).stderr)
            sounds.append(output.read_bytes())
        self.assertIn("warning: --set gamma has no effect: the objects have several materials; "
                      "choose one with --set material=...\n", said[1])
        self.assertEqual([text.count("\n") for text in said], [0, 1, 0, 0])
        self.assertEqual(sounds[0], sounds[1])
        self.assertNotEqual(sounds[2], sounds[3])

    def test_more_than_64_contacts_at_a_time_all_sound(self):
        peaks = []
        for count in (64, 128):
            output = self.folder / f"{count}.wav"
            file = self.lines(*(self.hit(contact_time=0.005, impulse=(0, 0, -1e-4))
                                for _ in range(count)))
            said = self.succeed("render", "--impulses", file, "-o", output).stderr
            self.assertEqual(said, "")
            peaks.append(max(map(abs, Wave(output).left)))
        self.assertGreater(peaks[1], 1.5 * peaks[0])

    def test_extreme_impulses_give_a_warning(self):
        hard = [self.hit(object="die", vertex=0, size=0.001, impulse=(-1e6, -1e6, -1e6))
                for _ in range(3)]
        file = self.lines(*hard, self.hit(0.1))
        output = self.folder / "out.wav"
        result = self.succeed("render", "--impulses", file, "-o", output)
        self.assertIn("3 impulses were left out, because they are too hard", result.stderr)
        self.assertTrue(all(map(math.isfinite, Wave(output).left)))

    def test_every_bad_line_gets_a_sentence_with_its_number(self):
        good = self.hit()
        bad = {
            "[1, 2]": "JSON object",
            json.dumps({k: v for k, v in good.items() if k != "impulse"}): "'impulse'",
            json.dumps({k: v for k, v in good.items() if k != "point"}): "'vertex' or 'point'",
            json.dumps({**good, "vertex": 3}): "'vertex' or 'point'",
            json.dumps({**good, "time": -1}): "'time'",
            json.dumps({**good, "time": "soon"}): "'time'",
            json.dumps({**good, "impulse": [0, 1]}): "'impulse'",
            json.dumps({**good, "impulse": [0, 1, 1e300]}): "'impulse'",
            json.dumps({**good, "point": "here"}): "'point'",
            json.dumps({**good, "contact_time": 1e9}): "'contact_time'",
            json.dumps({**good, "object": ""}): "'object'",
            json.dumps({**good, "body": 1.5}): "'body'",
            json.dumps({**good, "colour": "red"}): "'colour'",
            json.dumps({**good, "two\nlines": 1}): "'two?lines'",
        }
        self.refuse_lines(bad)

    def test_text_that_is_not_json_is_named(self):
        self.refuse_lines({
            "not JSON": "not JSON: 'not' in column 1",
            json.dumps({"time": float("nan")}): "not JSON: 'NaN' in column 10",
            json.dumps({"impulse": [0, float("-inf")]}): "not JSON: '-Infinity' in column 17",
            '{"time": 1e999}': "not JSON: '1e999' in column 10",
            '{"time" 0}': "not JSON: '0' in column 9",
            "{'time': 0}": "not JSON: ''' in column 2",
            '{"time": 0': "not JSON: it ends too early",
            "[" * 100000: "not JSON: it ends too early",
            "[" * 70 + "]" * 70: "nested too deep",
        })

    def test_the_first_20_bad_lines_are_reported(self):
        result = run("render", "--impulses", self.write("bad.jsonl", "[]\n" * 23), "-o",
                     self.folder / "out.wav")
        sentences = result.stderr.splitlines()
        self.assertEqual(len(sentences), 21)
        self.assertEqual(sentences[-1], "and 3 more bad lines.")

    @unittest.skipUnless(hasattr(os, "wait4"), "figures of POSIX")
    def test_unreported_bad_lines_take_no_memory(self):
        many = self.write("bad.jsonl", "x\n" * 5_000_000)
        few = self.write("few.jsonl", "x\n")
        output = ("-o", self.folder / "out.wav")
        most, code = most_memory_bytes("render", "--impulses", many, *output)
        usual, _ = most_memory_bytes("render", "--impulses", few, *output)
        self.assertEqual(code, 1)
        self.assertLess(most - usual, 200e6)  # took 600 MB when all were kept

    @unittest.skipUnless(hasattr(os, "wait4"), "figures of POSIX")
    def test_an_object_with_many_names_takes_the_memory_of_one(self):
        bowl = self.folder / "bowl.modal"
        bowl.write_bytes((OBJECTS / "glass-bowl.modal").read_bytes())
        names = ["".join("./" if bit == "0" else ".//" for bit in f"{k:07b}") + "bowl.modal" for k in range(128)]

        def most(count):
            file = self.lines(*(self.hit(0.001 * k, object=names[k % count]) for k in range(128)), name=f"{count}.jsonl")
            memory, code = most_memory_bytes("render", "--impulses", file, "-o", self.folder / "out.wav", "--seconds", 0.1)
            self.assertEqual(code, 0)
            return memory
        self.assertLess(most(128) - most(1), 30e6)

    def refuse_lines(self, bad):
        """Checks the sentence for each bad line; `bad` maps lines to sentences."""
        good = json.dumps(self.hit())
        file = self.write("bad.jsonl", "".join(f"{good}\n{line}\n" for line in bad))
        result = run("render", "--impulses", file, "-o", self.folder / "out.wav")
        self.assertEqual(result.returncode, 1)
        sentences = result.stderr.splitlines()
        self.assertEqual(len(sentences), len(bad))
        for i, (sentence, fault) in enumerate(zip(sentences, bad.values())):
            self.assertIn(f"{file}: line {2 * i + 2}: ", sentence)
            self.assertIn(fault, sentence)
        self.assertFalse((self.folder / "out.wav").exists())

    def test_each_wrong_line_and_each_missing_object_gets_one_sentence(self):
        bad = {2: self.hit(0.4, vertex=10 ** 6), 3: self.hit(0.3, object="gone.modal"),
               4: self.hit(0.2, body="b", size=2), 5: self.hit(0.1, object="gone.modal"),
               6: self.hit(0.5, object="ring", vertex=10 ** 6)}
        file = self.lines(self.hit(0, body="b"), *bad.values())
        result = run("render", "--impulses", file, "-o", self.folder / "out.wav")
        self.assertEqual(result.returncode, 1)
        sentences = result.stderr.splitlines()
        for line, said in ((2, "'plate'"), (3, "gone.modal"), (4, "'size'"), (6, "'ring'")):
            sentence = sentences.pop(0)
            self.assertIn(f"{file}: line {line}: ", sentence)
            self.assertIn(said, sentence)
        self.assertEqual(sentences, [])
        self.assertFalse((self.folder / "out.wav").exists())

    def test_other_faults_get_one_sentence(self):
        output = ("-o", self.folder / "out.wav")
        empty = self.write("empty.jsonl", "# nothing\n")
        self.refuse("render", "--impulses", empty, *output, naming=empty, saying="no impulses")
        missing = self.lines(self.hit(object="missing.modal"), name="missing.jsonl")
        self.refuse("render", "--impulses", missing, *output, naming="missing.modal",
                    saying="line 1")
        vertex = self.lines(self.hit(), self.hit(vertex=10 ** 6), name="vertex.jsonl")
        self.refuse("render", "--impulses", vertex, *output, naming=vertex, saying="line 2")
        self.refuse("render", "--impulses", self.folder / "no.jsonl", *output, naming="no.jsonl")
