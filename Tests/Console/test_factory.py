from console import OBJECTS, ConsoleTest, modal_parts, run


class Factory(ConsoleTest):
    def test_a_rebuilt_object_equals_the_shipped_one(self):
        for name in ("xylophone-108", "ring"):
            text = self.succeed("factory", "-o", self.folder, "--only", name).stdout
            self.assertIn(name, text)
            made, ships = (self.json("info", folder / f"{name}.modal")
                           for folder in (self.folder, OBJECTS))
            self.assertEqual(made["mode_count"], ships["mode_count"])
            self.assertEqual(made["vertices"], ships["vertices"])
            for a, b in zip(made["modes"], ships["modes"]):
                self.assertAlmostEqual(a["frequency_hz"] / b["frequency_hz"], 1, places=5)

    def test_shapes_are_stored_in_half_precision(self):
        self.succeed("factory", "-o", self.folder / "new", "--only", "xylophone-108")
        header, _ = modal_parts((self.folder / "new" / "xylophone-108.modal").read_bytes())
        self.assertEqual(header["shapes"]["dtype"], "F16")

    def test_each_build_gives_the_same_bytes(self):
        contents = []
        for folder in ("a", "b"):
            self.succeed("factory", "-o", self.folder / folder, "--only", "xylophone-108")
            contents.append((self.folder / folder / "xylophone-108.modal").read_bytes())
        self.assertEqual(contents[0], contents[1])

    def test_an_unknown_object_is_refused(self):
        result = run("factory", "-o", self.folder, "--only", "trombone")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("trombone", result.stderr)

    def test_existing_files_are_not_replaced_by_default(self):
        mine = self.write("xylophone-108.modal", "mine")
        options = "factory", "-o", self.folder, "--only", "xylophone-108"
        self.refuse(*options, naming=mine, saying="exists already")
        self.assertEqual(mine.read_text(), "mine")
        self.succeed(*options, "--replace")
        self.assertNotEqual(mine.read_bytes(), b"mine")
