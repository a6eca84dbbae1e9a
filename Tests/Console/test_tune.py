import csv
import math

from console import ConsoleTest, midi_file, note, run


def obj_mesh(path):
    """Returns points and triangles, with indices from 0."""
    points, faces = [], []
    for line in path.read_text().splitlines():
        kind, *rest = line.split()
        if kind == "v":
            points.append([float(number) for number in rest])
        elif kind == "f":
            faces.append([int(word.split("/")[0]) - 1 for word in rest])
    return points, faces


class Tune(ConsoleTest):
    def tuned(self, *options):
        folder = self.folder / "bars"
        self.succeed("tune", "marimba", "-o", folder, *options)
        return folder

    def test_two_tuned_bars_have_their_pitches_and_are_as_loud_as_the_factorys_in_any_folder(self):
        folder = self.tuned("--from", "83", "--to", "84", "--a4", "442")
        for key in (83, 84):
            wanted = 442 * 2 ** ((key - 69) / 12)
            modes = self.json("info", folder / f"marimba-{key}.modal")["modes"]
            heard = (modes[0]["frequency_hz"] + modes[1]["frequency_hz"]) / 2  # shared with the tube
            self.assertLess(abs(1200 * math.log2(heard / wanted)), 1)
        moved = self.folder / "elsewhere" / "Marimba of maple"
        moved.parent.mkdir()
        folder.rename(moved)
        told = self.json("presets", moved / "marimba.json")
        self.assertAlmostEqual(told["level_db"], told["matching_level_db"], delta=1)
        midi = self.write("note.mid", midi_file(note(0, 84)))
        told = self.json("render", "--preset", moved / "marimba.json", "--midi", midi,
                         "-o", self.folder / "note.wav", "--seconds", "1")
        self.assertGreater(told["peak_dbfs"], -40)
        self.assertLess(told["peak_dbfs"], -6)

    def test_existing_files_are_not_replaced_by_default(self):
        options = "--from", "84", "--to", "84"
        folder = self.folder / "bars"
        folder.mkdir()
        for name in ("marimba.csv", "marimba.json", "marimba-84.obj", "marimba-84.modal"):
            with self.subTest(name=name):
                mine = self.write(f"bars/{name}", "mine")
                self.refuse("tune", "marimba", "-o", folder, *options, naming=mine,
                            saying="exists already")
                self.assertEqual(mine.read_text(), "mine")
                mine.unlink()
        object = self.write("bars/marimba-84.modal", "mine")
        self.tuned(*options, "--meshes-only")
        self.assertEqual(object.read_text(), "mine")
        self.tuned(*options, "--replace")
        self.assertGreater(len(self.json("info", object)["modes"]), 1)

    def test_the_table_gives_the_measures_of_the_mesh(self):
        folder = self.tuned("--from", "84", "--to", "84")
        with (folder / "marimba.csv").open() as file:
            bar, = csv.DictReader(file)
        self.assertLess(abs(float(bar["miss_cents"])), 1)
        self.assertAlmostEqual(float(bar["second_ratio"]), 4, delta=0.01)
        points, faces = obj_mesh(folder / "marimba-84.obj")
        for axis, name in enumerate(("length_mm", "width_mm", "height_mm")):
            values = [point[axis] for point in points]
            self.assertAlmostEqual(max(values) - min(values), float(bar[name]), delta=0.01)
        edges = {}
        for face in faces:
            for a, b in zip(face, face[1:] + face[:1]):
                edges[a, b] = edges.get((a, b), 0) + 1
        self.assertTrue(all(count == 1 and edges.get((b, a)) == 1
                            for (a, b), count in edges.items()), "the surface is closed")

    def test_meshes_only_writes_no_preset(self):
        folder = self.tuned("--from", "84", "--to", "84", "--meshes-only")
        self.assertEqual(sorted(path.name for path in folder.iterdir()),
                         ["marimba-84.obj", "marimba.csv"])

    def test_a_failed_run_keeps_the_old_table(self):
        options = "--from", "84", "--to", "84", "--meshes-only"
        table = self.tuned(*options) / "marimba.csv"
        measures = table.read_text()
        self.assertEqual(measures.count("\n"), 2)
        self.refuse("tune", "marimba", "-o", table.parent, *options, "--replace", "--material",
                    "nope", naming="nope")
        self.assertEqual(table.read_text(), measures)
        beyond = self.folder / "beyond"
        beyond.mkdir()
        self.refuse("tune", "marimba", "-o", beyond, "--from", "0", "--to", "0", "--meshes-only",
                    naming="marimba")
        self.assertEqual(list(beyond.iterdir()), [])

    def test_another_scale_moves_every_bar(self):
        cents = [0, 90, 204, 294, 408, 498, 588, 702, 792, 906, 996, 1110]
        folder = self.tuned("--from", "76", "--to", "76", "--meshes-only", "--scale",
                            ",".join(map(str, cents)))
        with (folder / "marimba.csv").open() as file:
            bar, = csv.DictReader(file)
        # C is tuned so that A, 906 cents above it, is 440 Hz. E lies 408 cents above C.
        wanted = 440 * 2 ** ((1200 + 408 - 906) / 1200)
        self.assertLess(abs(1200 * math.log2(float(bar["frequency_hz"]) / wanted)), 1)

    def test_a_preset_that_cannot_be_written_is_named(self):
        folder = self.folder / "bars"
        (folder / "marimba.json").mkdir(parents=True)
        result = run("tune", "marimba", "-o", folder, "--from", "84", "--to", "84",
                     environment=self.environment)
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"{folder / 'marimba.json'}: ", result.stderr)

    def test_impossible_tunings_get_one_sentence(self):
        folder = self.folder / "bars"
        self.refuse("tune", "marimba", "-o", folder, "--from", "70", "--to", "60",
                    naming="--to", saying="lower than --from")
        self.refuse("tune", "marimba", "-o", folder, "--scale", "1", "2", "3",
                    naming="--scale", saying="twelve figures")
        self.refuse("tune", "bell", "-o", folder, naming="bell")
