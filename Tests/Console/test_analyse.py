import json
import math
import os
import signal
import subprocess
import sys
import time
import unittest

from console import ON_QEMU, PROGRAM, ConsoleTest, Wave, mesh_text, obj_text


def signals(process, disposition):
    """Returns the numbers of the signals that a process catches (SigCgt) or ignores (SigIgn)."""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
        mask = next(int(line.split()[1], 16) for line in status if line.startswith(disposition))
    return {number for number in range(1, 64) if mask >> (number - 1) & 1}


def wait_for_handlers(process):
    """Returns once the program catches signals, or has ended."""
    while process.poll() is None and signal.SIGTERM not in signals(process, "SigCgt"):
        time.sleep(0.01)


class Analyse(ConsoleTest):
    def mesh(self, kind, *options):
        path = self.folder / f"{kind}.obj"
        self.succeed("mesh", kind, "-o", path, *options)
        return path

    def analyse(self, mesh, *options):
        output = self.folder / "object.modal"
        report = self.json("analyse", mesh, "-o", output, *options)
        return report, self.json("info", output)

    def test_a_sphere_has_six_zero_modes_and_five_equal_lowest_modes(self):
        sphere = self.mesh("icosphere", "--radius", 0.1, "--vertices", 162)
        for method in ("spring-mass", "van-gelder", "two-layer"):
            report, info = self.analyse(sphere, "--method", method, "--thickness", 0.002,
                                        "--max-frequency", 8000)
            with self.subTest(method=method):
                self.assertEqual(report["vertices"], 162)
                self.assertEqual(report["zero_modes"], 6)
                self.assertEqual(info["method"], method)
                lowest = [mode["frequency_hz"] for mode in info["modes"][:6]]
                self.assertLess(lowest[4] / lowest[0] - 1, 1e-6)
                self.assertGreater(lowest[5] / lowest[0] - 1, 1e-3)
                self.assertLess(info["modes_after_compression"], info["mode_count"])

    def test_an_object_can_have_radiation_in_all_directions(self):
        sphere = self.mesh("icosphere", "--radius", 0.1, "--vertices", 162)
        options = ("--method", "two-layer", "--thickness", 0.002, "--max-frequency", 6000)
        _, front = self.analyse(sphere, *options)
        _, all_around = self.analyse(sphere, *options, "--all-around")
        self.assertEqual(front["radiation_directions"], 2)
        self.assertEqual(all_around["radiation_directions"], 28)

    def test_flat_faces_under_the_published_method_get_a_warning(self):
        box = self.mesh("box", "--vertices", 200)
        options = ("--method", "spring-mass", "--max-frequency", 4000)
        report, _ = self.analyse(box, *options)
        self.assertGreater(report["zero_modes"], 6)
        self.assertIn("zero modes", report["notes"])
        text = self.succeed("analyse", box, "-o", self.folder / "box.modal", *options).stdout
        self.assertIn(f"{report['zero_modes']} zero modes", text)

    def test_frequencies_scale_with_the_root_of_stiffness_over_density(self):
        bar = self.mesh("bar", "--vertices", 120)
        plain = {"poisson_ratio": 0.3, "fluid_damping_per_s": 0, "viscoelastic_damping_s": 0}
        frequencies = []
        for modulus, density in ((1e10, 1000), (4e10, 1000)):
            material = self.write("material.json", str({
                **plain, "youngs_modulus_pa": modulus, "density_kg_per_m3": density,
            }).replace("'", '"'))
            _, info = self.analyse(bar, "--material", material, "--max-frequency", 4000,
                                   "--method", "two-layer")
            frequencies.append(info["modes"][0]["frequency_hz"])
        self.assertAlmostEqual(frequencies[1] / frequencies[0], 2, places=6)

    def test_info_reports_decay_times_from_the_material(self):
        bar = self.mesh("bar", "--vertices", 120)
        _, info = self.analyse(bar, "--material", "glass", "--max-frequency", 8000)
        for mode in info["modes"]:
            material, eigenvalue = info["material"], mode["eigenvalue"]
            alpha = (material["fluid_damping_per_s"] +
                     material["loss_factor"] * math.sqrt(eigenvalue) +
                     material["viscoelastic_damping_s"] * eigenvalue) / 2
            self.assertAlmostEqual(mode["t60_s"] * alpha / math.log(1000), 1, places=9)
            frequency = math.sqrt(mode["eigenvalue"] - alpha ** 2) / (2 * math.pi)
            self.assertAlmostEqual(mode["frequency_hz"] / frequency, 1, places=9)
        text = self.succeed("info", self.folder / "object.modal").stdout
        for word in (str(info["vertices"]), "Glass", "two-layer", str(info["mode_count"])):
            self.assertIn(word, text)

    def test_a_mesh_in_millimetres_is_the_same_object(self):
        bar = self.mesh("bar", "--vertices", 120)
        vertices, faces = mesh_text(bar)
        millimetres = self.write("mm.obj", obj_text([[1000 * x for x in v] for v in vertices],
                                                    faces))
        _, metres = self.analyse(bar, "--max-frequency", 8000)
        _, scaled = self.analyse(millimetres, "--unit", "mm", "--max-frequency", 8000)
        self.assertEqual(metres["mode_count"], scaled["mode_count"])
        for a, b in zip(metres["modes"], scaled["modes"]):
            self.assertAlmostEqual(a["frequency_hz"] / b["frequency_hz"], 1, places=6)

    def test_a_grain_of_foam_sounds(self):
        foam = self.write("foam.json", json.dumps({
            "name": "foam", "youngs_modulus_pa": 1e4, "density_kg_per_m3": 10,
            "poisson_ratio": 0.1, "fluid_damping_per_s": 5, "viscoelastic_damping_s": 1e-7,
            "friction": 0.5, "restitution": 0.5, "roughness": 0.5, "source": "made up"}))
        cube = self.mesh("box", "--length", 0.001, "--width", 0.001, "--height", 0.001)
        _, info = self.analyse(cube, "--material", foam, "--max-frequency", 15000)
        self.assertLess(info["mass_kg"], 2e-8)
        sound = self.folder / "sound.wav"
        self.succeed("strike", self.folder / "object.modal", "-o", sound, "--velocity", 127,
                     "--set", "mallet_mass=500", "--set", "mallet_speed=10",
                     "--set", "level=24", "--set", "room=100")
        self.assertTrue(all(map(math.isfinite, Wave(sound).left)))
        self.assertGreater(Wave(sound).peak(), 0)

    def test_a_repair_is_reported_in_words(self):
        bar = self.mesh("bar", "--vertices", 120)
        vertices, faces = mesh_text(bar)
        soup = [vertices[corner] for face in faces for corner in face]
        report, info = self.analyse(
            self.write("soup.obj", obj_text(soup, [(3 * f, 3 * f + 1, 3 * f + 2)
                                                   for f in range(len(faces))])),
            "--max-frequency", 4000)
        self.assertIn("Joined", report["notes"])
        self.assertEqual(info["vertices"], len(vertices))

    def test_a_concave_face_is_filled_and_a_crossed_one_reported(self):
        corners = [(0, 0, 0), (0.4, 0, 0), (0.4, 0.1, 0), (0.1, 0.1, 0), (0.1, 0.3, 0), (0, 0.3, 0)]
        text = obj_text(corners, [])
        sheet = self.write("sheet.obj", text + "f 3 4 5 6 1 2\n")
        report, _ = self.analyse(sheet, "--max-frequency", 500, "--material", "Steel")
        self.assertAlmostEqual(report["mass_kg"], 0.06 * 0.005 * 7850, delta=0.02)
        self.assertNotIn("crosses itself", report["notes"])
        crossed = self.write("crossed.obj", text + "f 1 3 2 6 \\\n\n")
        report, _ = self.analyse(crossed, "--max-frequency", 500)
        self.assertIn("crosses itself", report["notes"])

    def test_open_and_non_manifold_meshes_work(self):
        bar = self.mesh("bar", "--vertices", 120)
        vertices, faces = mesh_text(bar)
        (a, b, _), top = faces[len(faces) // 2], len(vertices)
        middle = [(x + y) / 2 for x, y in zip(vertices[a], vertices[b])]
        fin = self.write("fin.obj", obj_text(
            vertices + [[middle[0], middle[1], 0.01], [middle[0], middle[1], -0.01]],
            faces + [[a, b, top], [a, b, top + 1]]))
        for mesh in (bar, fin):
            _, info = self.analyse(mesh, "--max-frequency", 4000)
            self.assertGreater(info["mode_count"], 3)

    def test_a_truncated_mesh_file_is_refused_or_gets_a_warning(self):
        whole = self.mesh("icosphere", "--radius", 0.1, "--vertices", 162).read_bytes()
        in_a_line = self.write("line.obj", whole[:-4])
        self.refuse("analyse", in_a_line, "-o", self.folder / "out.modal", naming="line.obj",
                    saying="truncated")
        lines = whole.splitlines(keepends=True)
        report, _ = self.analyse(self.write("lines.obj", b"".join(lines[:-80])),
                                 "--max-frequency", 4000)
        self.assertIn("the end of the mesh may be missing", report["notes"])
        report, _ = self.analyse(self.write("whole.obj", whole.rstrip()), "--method", "two-layer",
                                 "--max-frequency", 8000)
        self.assertNotIn("may be missing", report["notes"])

    def test_an_impossible_or_useless_thickness_is_reported(self):
        bar = self.mesh("bar", "--vertices", 60)
        report, _ = self.analyse(bar, "--thickness", 3, "--max-frequency", 2000)
        self.assertIn("3000 mm is thicker than its mesh is wide", report["notes"])
        ball = self.mesh("icosphere", "--radius", 0.1, "--vertices", 42)
        options = ("--max-frequency", 20000, "--elements", 1000)
        out = ("-o", self.folder / "ball.modal")
        self.assertIn("--thickness has no effect",
                      self.succeed("analyse", ball, *out, *options, "--thickness", 0.003).stderr)
        self.assertEqual(self.succeed("analyse", ball, *out, *options).stderr, "")

    def test_a_clamp_holds_a_part(self):
        tine = self.folder / "tine.obj"
        self.succeed("mesh", "box", "--length", 0.06, "--width", 0.005, "--height", 0.001,
                     "--vertices", 300, "-o", tine)
        options = ("--max-frequency", 5000, "--clamp", "x < -0.02", "--support-resistance", 200)
        report, info = self.analyse(tine, *options)
        self.assertEqual(report["zero_modes"], 0)
        self.assertGreater(info["clamped_vertices"], 0)
        self.assertIn("Clamps hold", report["notes"])
        # Steel of 5 cm beyond the clamp, 1 mm thick.
        self.assertAlmostEqual(info["modes"][0]["frequency_hz"] / 326.2, 1, delta=0.02)
        for region, saying in (("x<", "'x<' is no region"), ("x<-1", "hold no point")):
            self.refuse("analyse", tine, "-o", self.folder / "t.modal", "--clamp", region,
                        naming="clamp" if region == "x<" else "tine.obj", saying=saying)

    def test_a_clamp_holds_a_named_group_as_it_holds_a_box(self):
        bar = self.mesh("box", "--length", 0.06, "--width", 0.005, "--height", 0.002,
                        "--vertices", 200)
        vertices, rest, end = [], [], []
        for line in bar.read_text().splitlines():
            words = line.split()
            if words[0] == "v":
                vertices.append(float(words[1]))
            elif words[0] == "f":
                at_end = all(vertices[int(word) - 1] < -0.0299 for word in words[1:])
                (end if at_end else rest).append(line)
        grouped = self.write("grouped.obj", "\n".join(
            [line for line in bar.read_text().splitlines() if line[0] == "v"] +
            ["g body"] + rest + ["g end"] + end) + "\n")
        options = ("--max-frequency", 8000, "--elements", 600)
        (_, by_group), (_, by_box) = (self.analyse(grouped, *options, "--clamp", clamp)
                                      for clamp in ("group:end", "x<-0.0299"))
        self.assertGreater(by_group["clamped_vertices"], 2)
        self.assertEqual(by_group["clamped_vertices"], by_box["clamped_vertices"])
        self.assertEqual(by_group["modes"], by_box["modes"])
        self.refuse("analyse", grouped, "-o", self.folder / "t.modal", "--clamp", "group:foot",
                    naming="grouped.obj", saying="no group 'foot' in the mesh; its groups are "
                                                 "'body', 'end'.")
        self.assertEqual(self.json("info", grouped)["groups"],
                         [{"name": "body", "faces": len(rest)}, {"name": "end", "faces": len(end)}])
        self.assertIn("end, ", self.succeed("info", grouped).stdout)

    def test_file_names_can_have_spaces_and_umlauts(self):
        mesh, modal = self.folder / "eine Glocke, größer.obj", self.folder / "Glöckchen 2.modal"
        self.succeed("mesh", "bar", "--vertices", 60, "-o", mesh)
        self.succeed("analyse", mesh, "-o", modal, "--max-frequency", 2000)
        self.assertEqual(self.json("info", modal)["name"], "eine Glocke, größer")
        self.succeed("strike", modal, "-o", self.folder / "ein Schlag, dröhnend.wav")
        self.assertTrue((self.folder / "ein Schlag, dröhnend.wav").exists())

    def test_obj_and_ply_give_one_object(self):
        ply, obj = self.folder / "bar.ply", self.mesh("bar", "--vertices", 60)
        self.succeed("mesh", "bar", "--vertices", 60, "-o", ply)
        of_ply, of_obj = (self.analyse(mesh, "--max-frequency", 2000)[1] for mesh in (ply, obj))
        self.assertGreater(of_ply["mode_count"], 3)
        self.assertEqual(of_ply["modes"], of_obj["modes"])

    @unittest.skipUnless(sys.platform == "linux" and not ON_QEMU, "its own handlers are read from /proc")
    def test_a_signal_ends_it_with_a_sentence_and_no_file(self):
        plate = self.mesh("plate", "--length", 0.5, "--width", 0.4, "--vertices", 8000)
        output = self.folder / "plate.modal"
        for wish in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(wish=wish):
                process = subprocess.Popen([PROGRAM, "analyse", plate, "-o", output],
                                           stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                wait_for_handlers(process)
                self.assertIsNone(process.poll(), "it was over before it could be stopped")
                process.send_signal(wish)
                _, complaint = process.communicate()
                self.assertEqual(process.returncode, 130)
                self.assertEqual(complaint, "idiophone: The analysis was cancelled.\n")
                self.assertEqual(list(self.folder.glob("plate.modal*")), [])

    @unittest.skipUnless(sys.platform == "linux" and not ON_QEMU, "its own handlers are read from /proc")
    def test_a_run_without_a_terminal_ignores_a_closed_one(self):
        plate = self.mesh("plate", "--length", 0.5, "--width", 0.4, "--vertices", 8000)
        process = subprocess.Popen(["nohup", PROGRAM, "analyse", plate, "-o", self.folder / "p.modal"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        wait_for_handlers(process)
        process.send_signal(signal.SIGHUP)
        self.assertIn(signal.SIGHUP, signals(process, "SigIgn"))
        process.send_signal(signal.SIGINT)
        process.communicate()
        self.assertEqual(process.returncode, 130)

    @unittest.skipIf(sys.platform == "win32", "signals and terminals of POSIX")
    def test_progress_is_shown_on_a_terminal_only(self):
        import pty
        bar = self.mesh("bar", "--vertices", 120)
        command = [PROGRAM, "analyse", bar, "-o", self.folder / "bar.modal",
                   "--max-frequency", "2000"]
        self.assertEqual(self.succeed(*command[1:]).stderr, "")
        terminal, its_end = pty.openpty()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=its_end)
        os.close(its_end)
        shown = b""
        try:
            while part := os.read(terminal, 4096):
                shown += part
        except OSError:  # end of a terminal on Linux
            pass
        os.close(terminal)
        self.assertIn(b"bar.obj: 0 %", shown)
