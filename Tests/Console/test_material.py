from console import ConsoleTest

# A hard, light mallet excites all modes.
HARD = ("--set", "mallet_hardness=100000", "--set", "mallet_mass=1", "--set", "tau=0.001")
MESHES = {
    "bar": (("bar", "--length", 0.25, "--width", 0.04), ("--thickness", 0.008), "0.09,0.012,0"),
    "plate": (("plate", "--length", 0.3, "--width", 0.2), ("--thickness", 0.004), "0.11,0.06,0"),
    "bowl": (("bowl", "--radius", 0.05, "--height", 0.07, "--foot-radius", 0.03),
             ("--thickness", 0.003), "0.05,0,0.07"),
}


class Material(ConsoleTest):
    def mesh(self, kind):
        shape, thickness, place = MESHES[kind]
        path = self.folder / f"{kind}.obj"
        self.succeed("mesh", *shape, "-o", path)
        return path, thickness, place

    def struck(self, kind, material):
        """Writes the sound of a strike; returns its file and the mesh with its thickness."""
        mesh, thickness, place = self.mesh(kind)
        obj = self.folder / "true.modal"
        self.succeed("analyse", mesh, "-o", obj, "--material", material, *thickness,
                     "--max-frequency", 14000)
        wave = self.folder / "strike.wav"
        self.succeed("strike", obj, "-o", wave, "--at", place, "--seconds", 2, *HARD)
        return wave, ("--mesh", mesh, *thickness)

    def fitted(self, kind, material):
        wave, mesh = self.struck(kind, material)
        return self.json("material", wave, *mesh, "-o", self.folder / "fitted.json")

    def decays(self, kind, material):
        mesh, thickness, _ = self.mesh(kind)
        obj = self.folder / "other.modal"
        self.succeed("analyse", mesh, "-o", obj, "--material", material, *thickness,
                     "--max-frequency", 3000)
        return [(mode["frequency_hz"], mode["t60_s"]) for mode in self.json("info", obj)["modes"]]

    def test_a_material_is_found_and_can_be_put_on_another_object(self):
        told = self.fitted("bar", "Glass")
        true = self.json("materials", "Glass")
        ratio = lambda m: m["youngs_modulus_pa"] / m["density_kg_per_m3"]
        self.assertAlmostEqual(ratio(told) / ratio(true), 1, delta=0.05)
        copy = self.decays("plate", self.folder / "fitted.json")
        self.assertGreater(len(copy), 10)
        for (hz, seconds), (true_hz, true_seconds) in zip(copy, self.decays("plate", "Glass")):
            self.assertAlmostEqual(hz / true_hz, 1, delta=0.03)
            self.assertAlmostEqual(seconds / true_seconds, 1, delta=0.2)

    def test_a_bowl_tells_its_material(self):
        told = self.fitted("bowl", "Glass")
        true = self.json("materials", "Glass")
        ratio = lambda m: m["youngs_modulus_pa"] / m["density_kg_per_m3"]
        self.assertAlmostEqual(ratio(told) / ratio(true), 1, delta=0.05)

    def test_a_bowl_is_an_open_shell_or_a_solid_with_a_wall(self):
        bowl = ("mesh", "bowl", "--radius", 0.06, "--height", 0.05, "-o", self.folder / "b.obj")
        for wall, method in (((), "two-layer"), (("--thickness", 0.006), "fem")):
            self.succeed(*bowl, *wall)
            obj = self.folder / "b.modal"
            self.succeed("analyse", self.folder / "b.obj", "-o", obj, "--max-frequency", 8000)
            self.assertEqual(self.json("info", obj)["method"], method)
        self.refuse(*bowl, "--foot-radius", 0.06, naming="bowl", saying="narrower than its rim")

    def test_without_a_mesh_only_the_damping_is_fitted(self):
        wave, _ = self.struck("bar", "Marble")
        told = self.json("material", wave, "-o", self.folder / "m.json")
        true = self.json("materials", "Marble")
        self.assertIn("only the damping is fitted", told["notes"])
        for hz in ("1000", "4000"):
            known = self.json("materials", self.folder / "m.json")["t60_s"][hz]
            self.assertAlmostEqual(known / true["t60_s"][hz], 1, delta=0.2)

    def test_a_recording_of_another_object_is_refused(self):
        wave, _ = self.struck("bar", "Glass")
        self.refuse("material", wave, "--mesh", self.folder / "bar.obj", "--thickness", 0.03,
                    "-o", self.folder / "x.json", naming="strike.wav",
                    saying="not those of bar.obj")
