import base64
import json
import math
import os
import pathlib
import random
import struct
import unittest

from console import OBJECTS, ConsoleTest, Wave
from gltf_file import AUDIO, GltfFile, Model, parse

RATE = 48000
CLICK = int(0.002 * RATE)  # the noise of acceleration is over by then
# The draft's own samples can be tested, too. They are not part of this project.
SAMPLES = os.environ.get("IDIOPHONE_GLTF_SAMPLES")
# So can its schemas beside those of glTF 2.0, if there is jsonschema.
SCHEMAS = os.environ.get("IDIOPHONE_GLTF_SCHEMAS")


def gltf_model(file, frequencies, decays, size=0.1, seed=1, **more):
    """Adds a model on the corners of a tetrahedron."""
    numbers = random.Random(seed)
    return {"name": f"model {seed}", "frequencies": file.add(frequencies),
            "decayRates": file.add(decays),
            "positions": file.add([0, 0, 0, size, 0, 0, 0, size, 0, 0, 0, size], "VEC3"),
            "shapes": file.add([numbers.uniform(-2, 2) for _ in range(12 * len(frequencies))], "VEC3"),
            "indices": file.add([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], component=5123), **more}


def gltf_document(file, models, nodes=(), **audio):
    file.document["extensionsUsed"] = [AUDIO]
    file.document["nodes"] = list(nodes)
    file.document["extensions"] = {AUDIO: {"modalModels": models, **audio}}
    return file.text()


class Gltf(ConsoleTest):
    def model_file(self, name="model.gltf", **more):
        file = GltfFile()
        # Not ascending; the last two are beyond hearing and beyond the Nyquist frequency.
        frequencies, decays = [2210, 440.5, 3300.25, 905, 12000, 17900, 30000], [9, 2, 31, 0, 80, 200, 400]
        return self.write(name, gltf_document(file, [gltf_model(file, frequencies, decays, **more)]))

    def sound(self, *impulses, seconds=0.15, name="sound.wav"):
        lines = self.write("list.jsonl", "".join(json.dumps(line) + "\n" for line in impulses))
        self.succeed("render", "--impulses", lines, "-o", self.folder / name, "--seconds", seconds,
                     "--bit-depth", 32, "--set", "radiation=100", "--set", "tau=0.001",
                     "--set", "compression=0", "--set", "limiter=0")
        return Wave(self.folder / name).left

    def ratio_to_the_draft(self, path, point, impulse):
        """Returns our sound over the draft's, and what is left over of it."""
        document, elements = parse(path)
        model = Model(document["extensions"][AUDIO]["modalModels"][0], elements)
        ours = self.sound({"time": 0, "object": str(path), "vertex": point, "impulse": impulse})
        theirs = model.signal(point, impulse, RATE, len(ours))
        # The program plays up to 0.49 of the sample rate.
        ours, theirs = ours[CLICK:], theirs[CLICK:]
        power = sum(t * t for t in theirs)
        ratio = sum(o * t for o, t in zip(ours, theirs)) / power
        rest = sum((o - ratio * t) ** 2 for o, t in zip(ours, theirs)) / (ratio * ratio * power)
        return ratio, math.sqrt(rest)

    def test_every_mode_has_the_files_frequency_and_decay(self):
        modes = self.json("info", self.model_file())["modes"]
        found = {round(mode["frequency_hz"], 3): mode["t60_s"] for mode in modes}
        for frequency, decay in ((440.5, 2), (3300.25, 31), (17900, 200)):
            self.assertAlmostEqual(found[frequency], math.log(1000) / decay, delta=1e-5 / decay)
        self.assertGreater(found[905.0], 1000, "a mode without damping rings on")

    def test_a_strike_sounds_as_the_draft_says(self):
        ratios = []
        for number, (seed, point, impulse) in enumerate(
                ((1, 0, [0, 0, 0.01]), (1, 3, [0.004, -0.01, 0.002]), (2, 1, [0, 0.02, 0]))):
            path = self.model_file(f"model{number}.gltf", seed=seed, size=0.05 * (1 + number))
            ratio, rest = self.ratio_to_the_draft(path, point, impulse)
            self.assertLess(rest, 0.002)
            ratios.append(20 * math.log10(ratio))
        self.assertLess(max(ratios) - min(ratios), 0.02, "one level for all models")

    @unittest.skipIf(SAMPLES is None, "IDIOPHONE_GLTF_SAMPLES is not set")
    def test_the_drafts_samples_sound_as_it_says(self):
        levels = []
        for path in sorted(pathlib.Path(SAMPLES).rglob("*.gltf")):
            with self.subTest(path=path.name):
                self.succeed("scene", path, "-o", self.folder / "scene.wav", "--seconds", 0.1)
                if "surface" in path.parts:
                    continue
                document, elements = parse(path)
                model = Model(document["extensions"][AUDIO]["modalModels"][0], elements)
                modes = self.json("info", path)["modes"]
                for mode, (f, d) in zip(modes, sorted(zip(model.frequencies, model.decays))):
                    self.assertAlmostEqual(mode["frequency_hz"] / f, 1, delta=1e-5)
                    self.assertAlmostEqual(mode["t60_s"] * d / math.log(1000), 1, delta=1e-4)
                if min(model.frequencies) > 0.4 * RATE:
                    continue
                for point in (0, len(model.positions) // 2):
                    ratio, rest = self.ratio_to_the_draft(path, point, [0.003, -0.01, 0.002])
                    self.assertLess(rest, 0.02)
                    levels.append(20 * math.log10(ratio))
        self.assertGreater(len(levels), 8)
        self.assertLess(max(levels) - min(levels), 0.5)

    def test_what_is_written_comes_back_bit_for_bit(self):
        for name, vertex in (("plate", 0), ("vibraphone-60", 3), ("tuning-fork", 5)):
            written = self.folder / f"{name}.glb"
            self.succeed("export", name, "-o", written)
            for output, source in ((f"{name}.modal", written), (f"{name}-2.modal", name)):
                self.succeed("export", source, "-o", self.folder / output)
            self.assertEqual((self.folder / f"{name}.modal").read_bytes(),
                             (self.folder / f"{name}-2.modal").read_bytes())
            for file, output in ((str(written), "a.wav"), (name, "b.wav")):
                self.sound({"time": 0.01, "object": file, "point": [0.01, 0.01, 0.01],
                            "impulse": [0, 0.001, -0.003]}, name=output)
            self.assertEqual((self.folder / "a.wav").read_bytes(), (self.folder / "b.wav").read_bytes())

    def test_other_programs_can_strike_what_is_written(self):
        self.succeed("export", "plate", "-o", self.folder / "plate.glb")
        document, elements = parse(self.folder / "plate.glb")
        written = document["extensions"][AUDIO]
        model = Model(written["modalModels"][0], elements)
        told = self.json("info", OBJECTS / "plate.modal")
        self.assertEqual(len(model.frequencies), told["mode_count"])
        for f, mode in zip(sorted(model.frequencies), told["modes"]):
            self.assertAlmostEqual(f / mode["frequency_hz"], 1, delta=1e-6)
        self.assertEqual(written["acousticMaterials"][0]["density"],
                         told["material"]["density_kg_per_m3"])
        self.assertAlmostEqual(written["modalModels"][0]["massProperties"]["mass"],
                               told["mass_kg"], delta=1e-9)
        # The loudest modes come first: a few of them have most of the draft's energy.
        def energy(modes):
            return sum((model.amplitudes(7, (0, 0, 1), RATE)[m]) ** 2 / model.decays[m] for m in modes)
        count = len(model.frequencies)
        self.assertGreater(energy(range(count // 3)), energy(range(2 * count // 3, count)))
        mesh = document["meshes"][0]["primitives"][0]
        self.assertEqual(len(elements(mesh["indices"])), 3 * told["faces"])
        # As a mesh, it is where it was: the node turns z up to y up, and reading turns it back.
        positions = elements(mesh["attributes"]["POSITION"])
        x, y, z, w = document["nodes"][0]["rotation"]
        self.assertEqual((y, z), (0, 0))
        up = [2 * w * x * p[2] * -1 + (1 - 2 * x * x) * p[1] for p in positions]
        self.assertAlmostEqual(max(up) - min(up), max(p[2] for p in positions) -
                               min(p[2] for p in positions), delta=1e-6)

    @unittest.skipIf(SCHEMAS is None, "IDIOPHONE_GLTF_SCHEMAS is not set")
    def test_the_schemas_accept_what_is_written(self):
        import jsonschema
        import referencing
        schemas = {path.name: json.loads(path.read_text())
                   for path in pathlib.Path(SCHEMAS).glob("*.json")}
        registry = referencing.Registry().with_resources(
            (name, referencing.Resource.from_contents(schema)) for each in schemas.values()
            for name, schema in [(each["$id"], each)])

        def faults(document):
            parts = [("glTF", document), (f"glTF.{AUDIO}", document["extensions"][AUDIO]),
                     (f"node.{AUDIO}", document["nodes"][0]["extensions"][AUDIO])]
            return [error.message for name, part in parts
                    for error in jsonschema.Draft202012Validator(
                        schemas[f"{name}.schema.json"], registry=registry).iter_errors(part)]
        for name in ("plate", "vibraphone-60", "tuning-fork", "die"):
            self.succeed("export", name, "-o", self.folder / f"{name}.glb")
            document, _ = parse(self.folder / f"{name}.glb")
            self.assertEqual(faults(document), [])
        for change in ({"modalModels": []}, {"acousticMaterials": [{"density": -1}]}):
            document["extensions"][AUDIO].update(change)
            self.assertEqual(len(faults(document)), 1)
            document["extensions"][AUDIO].pop(next(iter(change)))

    def test_a_changed_model_is_what_it_says(self):
        self.succeed("export", "plate", "-o", self.folder / "plate.glb")
        raw = bytearray((self.folder / "plate.glb").read_bytes())
        document, elements = parse(self.folder / "plate.glb")
        model = document["extensions"][AUDIO]["modalModels"][0]
        view = document["bufferViews"][document["accessors"][model["frequencies"]]["bufferView"]]
        begin = 28 + struct.unpack_from("<I", raw, 12)[0] + view["byteOffset"]
        frequency = struct.unpack_from("<f", raw, begin)[0]
        struct.pack_into("<f", raw, begin, 1.01 * frequency)
        modes = self.json("info", self.write("changed.glb", bytes(raw)))["modes"]
        nearest = min(modes, key=lambda mode: abs(mode["frequency_hz"] - 1.01 * frequency))
        self.assertAlmostEqual(nearest["frequency_hz"] / frequency, 1.01, delta=1e-6)

    def test_broken_files_get_a_sentence(self):
        good = json.loads(self.model_file().read_text())

        def broken(change, saying):
            document = json.loads(json.dumps(good))
            change(document, document["extensions"][AUDIO]["modalModels"][0])
            file = self.write("broken.gltf", json.dumps(document))
            self.refuse("info", file, naming="broken.gltf", saying=saying)

        def accessor(document, model, key):
            return document["accessors"][model[key]]

        broken(lambda d, m: m.pop("shapes"), "shapes is missing")
        broken(lambda d, m: m.update(frequencies=99), "frequencies names something that does not exist")
        broken(lambda d, m: m.update(frequencies="a"), "frequencies names something")
        broken(lambda d, m: m.update(frequencies=m["decayRates"]), "a frequency that is not positive")
        broken(lambda d, m: m.update(decayRates=m["indices"]), "component type FLOAT")
        broken(lambda d, m: m.update(positions=m["frequencies"]), "has another type")
        broken(lambda d, m: accessor(d, m, "shapes").update(count=3), "another count than frequencies times")
        broken(lambda d, m: accessor(d, m, "shapes").update(count=10 ** 6), "outside its buffer")
        broken(lambda d, m: m.update(material=0), "material names something that does not exist")
        broken(lambda d, m: m.update(massProperties={"mass": 0}), "mass is 0, which is out of range")
        broken(lambda d, m: m.update(massProperties={"mass": 1, "centerOfMass": [0]}), "has not 3 numbers")
        broken(lambda d, m: d.update(extensionsRequired=["ACME_sound"]), "'ACME_sound'")
        broken(lambda d, m: d["asset"].update(version="1.0"), "version")
        broken(lambda d, m: d["extensions"].update({AUDIO: []}), "is not an object")
        broken(lambda d, m: d["extensions"][AUDIO].update(acousticMaterials=[{"density": -1}]),
               "acousticMaterials[0].density is -1")

    def test_unknown_extensions_do_no_harm(self):
        document = json.loads(self.model_file().read_text())
        document["extensionsUsed"].append("ACME_sound")
        document["extensions"]["ACME_sound"] = {"volume": [{}]}
        document["extensions"][AUDIO]["modalModels"][0]["extensions"] = {"ACME_sound": 1}
        self.assertEqual(self.json("info", self.write("more.gltf", json.dumps(document)))["mode_count"], 7)

    def scene(self, name, scale=1, body_mass=None, gain=1, **more):
        """A tetrahedron that falls 20 cm on a floor, which is a plane."""
        file = GltfFile(scene=0, scenes=[{"nodes": [0, 1]}], **more)
        model = gltf_model(file, [700, 1500, 2600], [8, 12, 20],
                           massProperties={"mass": 0.5, "centerOfMass": [0.025] * 3,
                                           "inertiaDiagonal": [2e-4, 2e-4, 2e-4]})
        physics = "KHR_physics_rigid_bodies"
        nodes = [
            {"name": "floor", "extensions": {physics: {"collider": {"geometry": {"shape": 0}}},
                                             AUDIO: {"acousticSurface": 0}}},
            {"name": "body", "translation": [0, 0.2, 0], "scale": [scale] * 3, "rotation": [0.1, 0.2, 0.3, 0.9273618],
             "extensions": {
                 physics: {"motion": {} if body_mass is None else
                           {"mass": body_mass, "inertiaDiagonal": [2e-4 * scale ** 5] * 3},
                           "collider": {"geometry": {"shape": 1}, "physicsMaterial": 0}},
                 AUDIO: {"modalModel": 0, "acousticSurface": 0, "gain": gain}}}]
        gltf_document(file, [model], nodes, acousticSurfaces=[{"roughness": 1e-6}])
        file.document["extensions"]["KHR_implicit_shapes"] = {"shapes": [
            {"type": "plane", "plane": {}}, {"type": "box", "box": {"size": [0.1, 0.1, 0.1]}}]}
        file.document["extensions"][physics] = {"physicsMaterials": [
            {"staticFriction": 0.5, "dynamicFriction": 0.4, "restitution": 0.2}]}
        return self.write(name, file.text())

    def test_bodies_collide_with_meshes(self):
        # A bowl of four faces catches the body, which would miss a plane at its rim.
        document = json.loads(self.scene("scene.gltf", body_mass=0.5).read_text())
        file = GltfFile()
        file.document = document
        raw = document["buffers"][0]["uri"].split(",")[1]
        file.data = base64.b64decode(raw)
        rim = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        positions = file.add([c for x, z in rim for c in (x, 0.5, z)] + [0, -0.5, 0], "VEC3")
        indices = file.add([1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4], component=5123)
        document["meshes"] = [{"primitives": [{"attributes": {"POSITION": positions}, "indices": indices}]}]
        floor = document["nodes"][0]
        floor["mesh"] = 0
        floor["extensions"]["KHR_physics_rigid_bodies"]["collider"]["geometry"] = {"node": 0}
        report, wave = self.render_scene(self.write("bowl.gltf", file.text()))
        self.assertGreaterEqual(report["impacts"], 2)
        first = next(n for n, sample in enumerate(wave.left) if sample != 0) / RATE
        self.assertGreater(first, math.sqrt(2 * 0.4 / 9.81), "it falls below the plane")

    def render_scene(self, file, *options):
        output = self.folder / "scene.wav"
        report = self.json("scene", file, "-o", output, "--seconds", 1, "--set", "limiter=0",
                           "--bit-depth", 32, *options)
        return report, Wave(output)

    def test_a_file_with_rigid_bodies_is_a_scene(self):
        report, wave = self.render_scene(self.scene("scene.gltf", body_mass=0.5))
        self.assertGreaterEqual(report["impacts"], 2)
        first = next(n for n, sample in enumerate(wave.left) if sample != 0) / RATE
        # It falls less than 20 cm, because it is not a point.
        self.assertTrue(0.05 < first < math.sqrt(2 * 0.2 / 9.81))
        start = int((first + 0.01) * RATE)
        at_mode, beside = (wave.level_at(f, start, RATE // 4) for f in (700, 760))
        self.assertGreater(at_mode, 20 * beside)

    def test_the_object_of_a_scene_says_that_it_is_one_of_it(self):
        document = json.loads(self.scene("scene.gltf").read_text())
        document["extensionsUsed"].append("KHR_physics_rigid_bodies")
        models = document["extensions"][AUDIO]["modalModels"]
        models.append({**models[0], "name": "second"})
        notes = self.json("info", self.write("two.gltf", json.dumps(document)))["provenance"]["notes"]
        self.assertIn("The first of 2 modal models", notes)
        self.assertIn("it is a scene, too", notes)

    def test_the_gain_of_a_node_counts(self):
        loud, soft = (self.render_scene(self.scene(f"{gain}.gltf", body_mass=0.5, gain=gain))[1].peak()
                      for gain in (1, 0.25))
        # The click of the whole body has no gain.
        self.assertAlmostEqual(loud / soft, 4, delta=1)

    def test_masses_say_whether_a_scale_changes_the_pitch(self):
        # The draft's samples use one model at several sizes, with masses that grow with the cube.
        for mass, pitch in ((0.5 * 1.5 ** 3, 700 / 1.5), (None, 700)):
            _, wave = self.render_scene(self.scene("scaled.gltf", scale=1.5, body_mass=mass))
            start = next(n for n, sample in enumerate(wave.left) if sample != 0) + RATE // 100
            levels = {f: wave.level_at(f, start, RATE // 4) for f in (700 / 1.5, 700)}
            self.assertEqual(max(levels, key=levels.get), pitch)

    def test_no_list_of_impulses_names_the_objects_inside(self):
        self.refuse("scene", self.scene("scene.gltf"), "-o", self.folder / "x.wav", "--impulses",
                    self.folder / "list.jsonl", naming="--impulses", saying="no files of their own")

    def test_a_file_without_bodies_is_no_scene(self):
        self.refuse("scene", self.model_file(), "-o", self.folder / "x.wav", naming="model.gltf",
                    saying="no rigid bodies")


if __name__ == "__main__":
    unittest.main()
