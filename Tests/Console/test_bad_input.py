import array
import json
import os
import random
import struct
import subprocess
import sys
import unittest

from console import (OBJECTS, PROGRAM, ConsoleTest, many_modes, midi_file, modal_bytes, modal_parts,
                     note, obj_text, run)

BAR = OBJECTS / "xylophone-108.modal"


class BadMeshes(ConsoleTest):
    def refuse_mesh(self, name, content, saying=""):
        path = self.write(name, content)
        self.refuse("analyse", path, "-o", self.folder / "out.modal", naming=name, saying=saying)

    def test_empty_meshes_are_refused(self):
        for ending in ("obj", "off", "ply", "stl", "gltf", "glb"):
            self.refuse_mesh(f"empty.{ending}", b"", saying="empty")

    def test_meshes_without_faces_are_refused(self):
        self.refuse_mesh("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", saying="faces")
        self.refuse_mesh("points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", saying="faces")
        self.refuse_mesh("points.stl", b"\0" * 80 + struct.pack("<I", 0), saying="faces")

    def test_vertices_that_are_not_finite_are_refused(self):
        for value in ("nan", "inf", "1e999"):
            self.refuse_mesh("bad.obj", f"v {value} 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        facet = struct.pack("<12fH", 0, 0, 1, float("nan"), 0, 0, 1, 0, 0, 0, 1, 0, 0)
        self.refuse_mesh("nan.stl", b"\0" * 80 + struct.pack("<I", 1) + facet)

    def test_indices_out_of_range_are_refused(self):
        for index in (4, 0, -4, 2 ** 31, 2 ** 64):
            self.refuse_mesh("bad.obj", f"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 {index}\n")
        self.refuse_mesh("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")

    def test_files_shorter_than_their_header_says_are_refused(self):
        self.refuse_mesh("short.stl", b"\0" * 80 + struct.pack("<I", 2 ** 32 - 1) + b"\0" * 50)
        self.refuse_mesh("short.off", "OFF\n1000000000 1 0\n0 0 0\n")
        self.refuse_mesh("short.ply", "ply\nformat ascii 1.0\nelement vertex 2000000000\n"
                                      "property float x\nproperty float y\nproperty float z\n"
                                      "element face 1\nproperty list uchar int vertex_indices\n"
                                      "end_header\n0 0 0\n")

    def test_a_mesh_without_area_is_refused(self):
        self.refuse_mesh("point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n")
        self.refuse_mesh("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")

    def test_a_million_loose_triangles_are_refused(self):
        random.seed(1)
        count = 10 ** 6
        corners = array.array("f", (random.random() for _ in range(9 * 1000))).tobytes()
        thousand = b"".join(b"\0" * 12 + corners[36 * i:36 * i + 36] + b"\0\0"
                            for i in range(1000))
        # Each thousand lies elsewhere, so that nothing is welded.
        soup = bytearray(b"\0" * 80 + struct.pack("<I", count) + thousand * (count // 1000))
        for i in range(count):
            struct.pack_into("<f", soup, 84 + 50 * i + 12, i * 1e-6)
        self.refuse_mesh("soup.stl", bytes(soup), saying="vertices")

    def test_random_bytes_are_refused(self):
        random.seed(2)
        for ending in ("obj", "off", "ply", "stl", "gltf", "glb"):
            for size in (1, 84, 1000):
                self.refuse_mesh(f"noise.{ending}", random.randbytes(size))

    def test_missing_and_other_files_are_refused_as_meshes(self):
        out = ("-o", self.folder / "out.modal")
        self.refuse("analyse", self.folder / "missing.obj", *out, naming="missing.obj")
        self.refuse("analyse", self.folder, *out, naming=self.folder.name)
        self.refuse("analyse", self.write("mesh.txt", "v 0 0 0\n"), *out, naming="mesh.txt",
                    saying=".obj")


class BadObjects(ConsoleTest):
    def refuse_object(self, content, saying=""):
        path = self.write("bad.modal", content)
        self.refuse("info", path, naming=path, saying=saying)
        self.refuse("strike", path, "-o", self.folder / "out.wav", naming=path, saying=saying)

    def parts(self):
        return modal_parts(BAR.read_bytes())

    def test_the_undamaged_object_is_accepted(self):
        path = self.write("good.modal", modal_bytes(*self.parts()))
        self.assertGreater(self.json("info", path)["mode_count"], 0)

    def test_truncated_objects_are_refused(self):
        whole = BAR.read_bytes()
        for size in (0, 1, 7, 8, 100, len(whole) // 2, len(whole) - 1):
            self.refuse_object(whole[:size])
        self.refuse_object(whole + b"\0")

    def test_an_enormous_header_is_refused(self):
        for length in (2 ** 60, 2 ** 64 - 1, 2 ** 63):
            self.refuse_object(struct.pack("<Q", length) + b"{}", saying="not a modal object")

    def test_a_damaged_header_is_refused(self):
        for text in (b"", b"{", b"[]", b"null", b"[" * 100000, b"\xff\xfe" * 10,
                     b'{"__metadata__": 3}'):
            self.refuse_object(struct.pack("<Q", len(text)) + text)

    def test_overlapping_tensors_are_refused(self):
        header, data = self.parts()
        size = struct.calcsize("d") * header["eigenvalues"]["shape"][0]
        begin = header["vertices"]["data_offsets"][0]
        header["eigenvalues"]["data_offsets"] = [begin, begin + size]
        self.refuse_object(modal_bytes(header, data))

    def test_impossible_eigenvalues_are_refused(self):
        header, data = self.parts()
        begin, end = header["eigenvalues"]["data_offsets"]
        for value in (float("nan"), float("inf"), -1.0, 0.0):
            values = array.array("d", data[begin:end])
            values[0] = value
            self.refuse_object(modal_bytes(header, data[:begin] + values.tobytes() + data[end:]),
                               saying="eigenvalue")

    def test_impossible_shapes_are_refused(self):
        header, data = self.parts()
        begin, end = header["shapes"]["data_offsets"]
        count = (end - begin) // 2  # half-precision values
        header["shapes"]["dtype"] = "F32"
        header["shapes"]["data_offsets"] = [begin, begin + 4 * count]
        for tensor in header.values():
            if tensor.get("data_offsets", [0])[0] > begin:
                tensor["data_offsets"] = [x + 2 * count for x in tensor["data_offsets"]]
        for shape in (1.0, 3e20, -3e10, float("inf"), float("nan")):
            shapes = array.array("f", [1.0] * count)
            shapes[count // 2] = shape
            content = modal_bytes(header, data[:begin] + shapes.tobytes() + data[end:])
            if shape == 1:
                self.succeed("info", self.write("good.modal", content))
            else:
                self.refuse_object(content, saying="a mode shape is not between")

    def test_impossible_counts_are_refused(self):
        for shape in ([-1], [2 ** 63], [1.5], ["many"], [], [2 ** 32, 2 ** 32]):
            header, data = self.parts()
            header["eigenvalues"]["shape"] = shape
            self.refuse_object(modal_bytes(header, data))

    def test_indices_of_missing_vertices_are_refused(self):
        header, data = self.parts()
        for name in ("faces", "shape_vertices"):
            begin, end = header[name]["data_offsets"]
            for index in (-1, 2 ** 31 - 1):
                self.refuse_object(modal_bytes(
                    header, data[:end - 4] + struct.pack("<i", index) + data[end:]))

    def test_a_future_format_is_refused(self):
        header, data = self.parts()
        header["__metadata__"]["format_version"] = "99"
        self.refuse_object(modal_bytes(header, data), saying="99")

    def test_one_damaged_byte_anywhere_causes_no_crash(self):
        random.seed(3)
        whole = bytearray(BAR.read_bytes())
        header_size = struct.unpack_from("<Q", whole)[0]
        for _ in range(60):
            place, value = random.randrange(8 + header_size + 800), random.randrange(256)
            damaged = bytearray(whole)
            damaged[place] = value
            result = run("info", self.write("damaged.modal", bytes(damaged)), "--json")
            self.assertIn(result.returncode, (0, 1), f"byte {place} = {value}")
            if result.returncode == 0:
                json.loads(result.stdout)

    def test_missing_and_other_files_are_refused_as_objects(self):
        for name in (self.folder / "missing.modal", self.folder):
            self.refuse("info", name, naming=name)
            self.refuse("strike", name, "-o", self.folder / "out.wav", naming=name)


class BadPresetsAndSongs(ConsoleTest):
    def setUp(self):
        super().setUp()
        self.song = self.write("song.mid", midi_file(note(0, 72)))
        self.out = ("-o", self.folder / "out.wav")

    def preset(self, **changes):
        preset = json.loads(run("presets", "--json").stdout)[0]
        return json.dumps({**preset, **changes})

    def refuse_preset(self, content, saying="", naming="bad.json"):
        path = self.write("bad.json", content)
        self.refuse("render", "--preset", path, "--midi", self.song, *self.out, naming=naming,
                    saying=saying)

    def test_a_preset_of_a_future_version_is_refused(self):
        self.refuse_preset(self.preset(version=99), saying="newer")

    def test_invalid_presets_are_refused(self):
        for content in ("", "{", "[]", "null", "{}", b"\xff" * 100, "[" * 100000,
                        self.preset(format="something"), self.preset(keyMap=3),
                        self.preset(name="")):
            self.refuse_preset(content)

    def test_a_preset_without_its_object_is_refused(self):
        key_map = {"kind": "zones", "lowestNote": 60, "highestNote": 72, "object": "gone.modal"}
        self.refuse_preset(self.preset(keyMap=key_map), saying="gone.modal")
        key_map["object"] = ""
        self.refuse_preset(self.preset(keyMap=key_map), saying="no object is named")

    def test_missing_presets_are_refused(self):
        for name in ("No Such Preset", self.folder):
            self.refuse("render", "--preset", name, "--midi", self.song, *self.out, naming=name)

    def test_invalid_songs_are_refused(self):
        whole = midi_file(note(0, 72) + note(480, 74))
        silent = midi_file([(0, b"\xff\x51\x03\x07\xa1\x20")])
        endless = midi_file(note(2 ** 27, 72), division=1)
        for content in (b"", b"RIFF", b"hello, this is text", b"MThd", whole[:30], whole[:-3],
                        silent, endless, midi_file(note(0, 72, velocity=200)),
                        midi_file(note(0, 72), division=0),
                        midi_file(note(0, 72), division=-25 * 256)):
            path = self.write("bad.mid", content)
            self.refuse("render", "--preset", "Steel Ring", "--midi", path, *self.out, naming=path)
        self.refuse("render", "--preset", "Steel Ring", "--midi", self.folder, *self.out,
                    naming=self.folder)

    def test_a_song_full_of_tempo_changes_is_read_fast(self):
        # Searching all tempi for each event took minutes.
        body = b"\1\xff\x51\3\7\xa1\x20" * 100000 + b"\1\xb0\1\1" * 200000 + b"\0\xff\x2f\0"
        path = self.write("tempi.mid", midi_file()[:10] + struct.pack(">HH", 1, 480) + b"MTrk" +
                          struct.pack(">I", len(body)) + body)
        self.refuse("render", "--preset", "Steel Ring", "--midi", path, *self.out, naming=path,
                    saying="no notes")

    def test_a_song_with_all_notes_at_one_time_is_read_fast(self):
        # Searching all events of a time for the end of each note took minutes.
        count = 200000
        body = (b"\0\x90\x3c\x40" + b"\0\x3c\x40" * count + b"\0\x80\x3c\x40" + b"\0\x3c\x40" * count +
                b"\0\xb0\1\1" + b"\0\1\1" * 3 * count + b"\0\x90\x3c\xc8\0\xff\x2f\0")
        path = self.write("chord.mid", midi_file()[:10] + struct.pack(">HH", 1, 480) + b"MTrk" +
                          struct.pack(">I", len(body)) + body)
        self.refuse("render", "--preset", "Steel Ring", "--midi", path, *self.out, naming=path,
                    saying="damaged")

    def test_random_songs_cause_no_crash(self):
        random.seed(4)
        for _ in range(60):
            noise = bytearray(midi_file(note(0, 72) + note(48, 74), note(9, 80)))
            for _ in range(random.randrange(1, 6)):
                noise[random.randrange(12, len(noise))] = random.randrange(256)
            result = run("render", "--preset", "Steel Ring", "--midi",
                         self.write("noise.mid", bytes(noise)), *self.out, "--seconds", 0.05)
            self.assertIn(result.returncode, (0, 1), bytes(noise).hex())


class Recordings(ConsoleTest):
    @unittest.skipUnless(hasattr(os, "mkfifo"), "files of POSIX")
    def test_files_without_a_length_are_refused(self):
        pipe = self.folder / "pipe.wav"
        os.mkfifo(pipe)
        endless = self.folder / "endless.wav"
        endless.symlink_to("/dev/zero")
        for file in (pipe, endless):
            self.refuse("surface", file, naming=file, saying="cannot be opened")
            self.refuse("fit", f"{file}@0", "-o", self.folder / "out.modal", naming=file,
                        saying="cannot be opened")


class Terminals(ConsoleTest):
    """Control sequences in a file's texts do not reach a terminal."""

    HOSTILE = "\x1b[31mred\x1b]0;title\x07\x7f\x9b2J\nü"

    def tame(self, text):
        return not any(ord(c) < 32 and c not in "\n\t" or 127 <= ord(c) < 160 for c in text)

    def check(self, *arguments, saying, code):
        result = run(*arguments, environment=self.environment)
        self.assertEqual(result.returncode, code, result.stderr)
        said = result.stdout + result.stderr
        self.assertTrue(self.tame(said), repr(said))
        self.assertIn(saying, said)
        return result

    def test_texts_of_objects_reach_no_terminal_as_commands(self):
        header, data = modal_parts(BAR.read_bytes())
        metadata = header["__metadata__"]
        for part, member in (("material", "name"), ("provenance", "source"),
                             ("provenance", "software"), ("provenance", "notes")):
            metadata[part] = json.dumps({**json.loads(metadata[part]), member: self.HOSTILE})
        metadata["name"] = metadata["method"] = self.HOSTILE
        path = self.write("hostile.modal", modal_bytes(header, data))
        self.check("info", path, saying="[31mred", code=0)
        told = self.check("info", path, "--json", saying="[31mred", code=0)
        self.assertEqual(json.loads(told.stdout)["name"], self.HOSTILE)

    def test_texts_of_presets_reach_no_terminal_as_commands(self):
        preset = self.json("presets")[0]
        preset["parameters"][self.HOSTILE] = 1
        out = ("-o", self.folder / "out.wav", "--seconds", 0.1)
        song = self.write("song.mid", midi_file(note(0, 72)))
        path = self.write("hostile.json", json.dumps(preset))
        self.check("render", "--preset", path, "--midi", song, *out, saying="[31mred", code=0)
        preset["keyMap"]["object"] = self.HOSTILE + "/gone.modal"
        path.write_text(json.dumps(preset))
        self.check("render", "--preset", path, "--midi", song, *out, saying="[31mred", code=1)
        preset["keyMap"]["object"] = 5000 * "x"
        path.write_text(json.dumps(preset))
        self.refuse("render", "--preset", path, "--midi", song, *out, naming="hostile.json",
                    saying="keyMap.object is longer than 4096 bytes")

    def test_texts_of_scenes_and_arguments_reach_no_terminal_as_commands(self):
        scene = {"format": "idiophone-scene", "version": 1, "name": self.HOSTILE,
                 "kinds": [{"name": "ball", "object": "ring"}], "bodies": [{"kind": "ball"}]}
        song = self.write("song.mid", midi_file(note(0, 72)))
        self.check("scene", self.write("hostile.json", json.dumps(scene)), "--midi", song, "-o",
                   self.folder / "out.wav", saying="[31mred", code=1)
        self.check("info", self.HOSTILE, saying="[31mred", code=1)
        self.check(self.HOSTILE, saying="[31mred", code=2)


class SmallFilesThatAreLarge(ConsoleTest):
    """Small files cannot ask for more modes than can be played."""

    def test_scenes_with_too_many_modes_are_refused(self):
        self.write("many.modal", many_modes(65536))
        scene = {"format": "idiophone-scene", "version": 1, "name": "Crowd",
                 "kinds": [{"name": "bar", "object": "many.modal"}], "seconds": 0.01,
                 "bodies": [{"kind": "bar", "count": 33, "over": 3600, "at": [0, 0, 1]}]}
        self.refuse("scene", self.write("scene.json", json.dumps(scene)), "-o",
                    self.folder / "out.wav", naming="Crowd",
                    saying="2162688 modes on all bodies together")

    def test_impulses_on_bodies_with_too_many_modes_are_refused(self):
        self.write("many.modal", many_modes(65536))
        lines = "".join(json.dumps({"time": 0, "object": "many.modal", "body": body, "vertex": 0,
                                    "impulse": [0, 0, 0.001]}) + "\n" for body in range(33))
        self.refuse("render", "--impulses", self.write("bodies.jsonl", lines), "-o",
                    self.folder / "out.wav", "--seconds", 0.01, naming="bodies.jsonl",
                    saying="2162688 modes on all bodies together")


class BadArguments(ConsoleTest):
    def setUp(self):
        super().setUp()
        self.song = self.write("song.mid", midi_file(note(0, 72)))
        self.out = ("-o", self.folder / "out.wav")

    def test_outputs_that_cannot_be_written_are_refused(self):
        mesh = self.write("mesh.obj", obj_text([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
        nowhere = self.folder / "missing" / "out.obj"
        for output in (nowhere, self.folder):
            for command in (("analyse", mesh), ("strike", BAR), ("mesh", "bar"),
                            ("render", "--preset", "Steel Ring", "--midi", self.song)):
                self.refuse(*command, "-o", output, naming=output.name)
        self.refuse("factory", "-o", mesh / "folder", "--only", "ring", naming=mesh / "folder")
        self.refuse("render", "--preset", "Steel Ring", "--midi", self.song, *self.out,
                    "--seconds", 0.1, "--stats", nowhere, naming=nowhere)

    def test_numbers_out_of_range_are_refused(self):
        mesh = self.write("mesh.obj", obj_text([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
        analyse, strike = ("analyse", mesh, *self.out), ("strike", BAR, *self.out)
        render = ("render", "--preset", "Steel Ring", "--midi", self.song, *self.out)
        for command, option, values in (
                (analyse, "--thickness", ("nan", 0, -1, "inf", "thick")),
                (analyse, "--max-frequency", ("nan", 0, -5, 1e30)),
                (analyse, "--unit", ("inch", "")),
                (analyse, "--method", ("fem-2",)),
                (strike, "--velocity", (0, 128, "nan", -3)),
                (strike, "--at", ("nan,0,0", "1,2", "a,b,c")),
                (strike, "--vertex", (-1, 10 ** 7, "nan")),
                (strike, "--seconds", ("nan", 0, -1, 1e9)),
                (render, "--sample-rate", ("nan", -48000, 0, 7999, 1e9)),
                (render, "--block-size", (0, -1, "nan", 10 ** 9)),
                (render, "--bit-depth", (8, 0, -16, "nan")),
                (render, "--set", ("tau", "tau=", "tau=loud", "tau=-1", "tau=nan", "tau=+1e9", "tau= 1e9", "colour=3",
                                   "young=1200000MPa", "young=3kg",
                                   "material=Unobtainium", "=3"))):
            for value in values:
                self.refuse(*command, option, value, naming=option)

    def test_invalid_materials_are_refused(self):
        good = {"youngs_modulus_pa": 1e10, "density_kg_per_m3": 800, "poisson_ratio": 0.3,
                "fluid_damping_per_s": 5, "viscoelastic_damping_s": 1e-7}
        for content in ("", "{", "[]", json.dumps({**good, "density_kg_per_m3": -1}),
                        json.dumps({**good, "colour": 1}),
                        json.dumps({**good, "colour": "#12345g"}), json.dumps({"name": "Empty"}),
                        json.dumps({**good, "poisson_ratio": "soft"}),
                        json.dumps({**good, "loss_factor": -1}),
                        json.dumps({**good, "source": {"colour": "seen"}})):
            path = self.write("material.json", content)
            self.refuse("materials", path, naming=path)
            self.refuse("strike", BAR, *self.out, "--material", path, naming=path)
        self.refuse("strike", BAR, *self.out, "--material", "Unobtainium", naming="Unobtainium")

    def test_invalid_commands_are_refused(self):
        self.refuse(naming="command")
        self.refuse("dance", naming="dance")
        self.refuse("render", "--preset", "Steel Ring", *self.out, naming="--midi")
        self.refuse("render", "--midi", self.song, *self.out, naming="--preset")
        self.refuse("strike", BAR, naming="--output")
        self.refuse("strike", BAR, *self.out, "--loudly", naming="--loudly")
        self.refuse("mesh", "cow", "-o", self.folder / "cow.obj", naming="cow")
        self.refuse("mesh", "bar", "--length", 100, "--width", 1e-4,
                    "-o", self.folder / "hair.obj", naming="bar", saying="proportions")


class WrittenFiles(ConsoleTest):
    """No command overwrites another file that its command line names."""

    def refuse_to_write_over(self, file, *command, option="-o"):
        before = file.read_bytes()
        for spelled in (file, f"{file.parent}/./{file.name}"):
            self.refuse(*command, option, spelled, naming=spelled, saying="would replace the file")
            self.assertEqual(file.read_bytes(), before)

    def test_inputs_are_not_overwritten(self):
        mesh = self.write("bar.obj", "")
        self.succeed("mesh", "bar", "--vertices", 60, "-o", mesh)
        self.refuse_to_write_over(mesh, "analyse", mesh)
        bar = self.write("bar.modal", BAR.read_bytes())
        self.refuse_to_write_over(bar, "strike", bar)
        self.refuse_to_write_over(bar, "map", bar)
        song = self.write("song.mid", midi_file(note(0, 60)))
        render = ("render", "--preset", "Marimba", "--midi", song)
        self.refuse_to_write_over(song, *render)
        self.refuse_to_write_over(song, *render, "-o", self.folder / "x.wav", option="--stats")
        sound = self.folder / "bar.wav"
        self.succeed("strike", BAR, "--seconds", 0.5, "-o", sound)
        self.refuse_to_write_over(sound, "surface", sound)
        self.refuse_to_write_over(sound, "fit", f"{sound}@0,0,0", "--mesh", mesh)
        impulses = self.write("impacts.jsonl", "{}")
        self.refuse_to_write_over(impulses, "render", "--impulses", impulses)

    def test_other_outputs_are_not_overwritten(self):
        song = self.write("song.mid", midi_file(note(0, 60)))
        new = self.folder / "new"
        elsewhere = self.folder / "folder"
        elsewhere.mkdir()
        for same in (new, elsewhere / ".." / "new", os.path.relpath(new)):
            self.refuse("render", "--preset", "Marimba", "--midi", song, "-o", new, "--stats", same,
                        naming=new, saying="would replace the file")

    @unittest.skipUnless(hasattr(os, "mkfifo"), "files of POSIX")
    def test_a_wav_file_is_written_through_a_link_but_not_to_a_device(self):
        pipe, link, file = (self.folder / name for name in ("pipe", "link.wav", "file.wav"))
        os.mkfifo(pipe)
        self.refuse("strike", BAR, "-o", pipe, naming="pipe", saying="a device or a pipe")
        self.assertTrue(pipe.is_fifo())
        link.symlink_to(file.name)
        file.write_bytes(b"old")
        for place in (link, file):
            self.succeed("strike", BAR, "-o", place, "--seconds", 0.1)
            self.assertTrue(link.is_symlink())
            self.assertEqual(file.read_bytes()[:4], b"RIFF")

    @unittest.skipIf(sys.platform == "win32", "links need a right there")
    def test_a_link_counts_as_its_target(self):
        bar = self.write("bar.modal", BAR.read_bytes())
        link = self.folder / "link"
        link.symlink_to(bar)
        self.refuse_to_write_over(bar, "strike", link)
        grain, lost = self.folder / "grain.obj", self.folder / "lost.modal"
        self.succeed("mesh", "icosphere", "--radius", 1e-4, "-o", grain)
        lost.symlink_to(self.folder / "nowhere" / "grain.modal")
        self.refuse("analyse", grain, "-o", self.folder / "grain.modal", naming=grain, saying="mode")
        # An output that cannot be written is found before the analysis fails.
        self.refuse("analyse", grain, "-o", lost, naming=lost, saying="written")

    def test_a_protected_file_is_not_overwritten(self):
        mesh = self.write("mine.obj", "mine")
        mesh.chmod(0o444)
        self.refuse("mesh", "bar", "-o", mesh, naming=mesh, saying="written")
        self.refuse("strike", BAR, "-o", mesh, naming=mesh, saying="written")
        self.assertEqual(mesh.read_bytes(), b"mine")


@unittest.skipIf(sys.platform == "win32", "limits of POSIX")
class FullDisks(ConsoleTest):
    """The disk is full just before the last bytes of an output."""

    def refuse_last_bytes(self, output, *command):
        output = self.folder / output
        self.succeed(*command, "-o", output)
        written = output.read_bytes()
        for missing in (64, len(written) // 2, len(written)):
            self.refuse(*command, "-o", output, naming=output, saying="written",
                        largest_file_bytes=len(written) - missing)
            self.assertEqual(output.read_bytes(), written, "what was there stays")

    def test_a_full_disk_leaves_the_old_sound(self):
        strike = ("strike", BAR, "--seconds", 0.1)
        for bits in (16, 24, 32):
            self.refuse_last_bytes("bar.wav", *strike, "--bit-depth", bits)

    def test_a_full_disk_leaves_the_old_object(self):
        mesh = self.folder / "bar.obj"
        self.succeed("mesh", "bar", "--vertices", 60, "-o", mesh)
        self.refuse_last_bytes("bar.modal", "analyse", mesh, "--max-frequency", 2000)

    def test_a_full_disk_leaves_the_old_mesh(self):
        self.refuse_last_bytes("bar.obj", "mesh", "bar")
        self.refuse_last_bytes("map.ply", "map", BAR)

    @unittest.skipUnless(os.path.exists("/dev/full"), "no device that is always full")
    def test_a_full_standard_output_is_an_error(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "presets"], stdout=full, stderr=subprocess.PIPE,
                                    text=True)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr, "idiophone: the standard output cannot be written\n")
