from console import ConsoleTest


class Lists(ConsoleTest):
    def test_presets_are_told_with_all_that_a_preset_file_holds(self):
        presets = self.json("presets")
        self.assertEqual(presets[0]["name"], "Rosewood Xylophone")
        self.assertEqual({p["keyMap"]["kind"] for p in presets}, {"bars", "zones", "scaled"})
        text = self.succeed("presets").stdout
        for preset in presets:
            self.assertIn(preset["name"], text)
            self.assertEqual(preset["format"], "idiophone-preset")

    def test_materials_are_told_with_figures_and_sources(self):
        materials = self.json("materials")
        text = self.succeed("materials").stdout
        steel = next(m for m in materials if m["name"] == "Steel")
        self.assertEqual(steel["youngs_modulus_pa"], 2e11)
        self.assertEqual(steel["density_kg_per_m3"], 7850)
        for material in materials:
            self.assertIn(material["name"], text)
            self.assertTrue(material["source"])

    def test_parameters_are_told_with_units_ranges_and_defaults(self):
        parameters = self.json("parameters")
        text = self.succeed("parameters").stdout
        tau = next(p for p in parameters if p["id"] == "tau")
        self.assertEqual(tau["unit"], "steps")
        for parameter in parameters:
            self.assertIn(parameter["id"], text)
            self.assertLessEqual(parameter["minimum"], parameter["default"])
            self.assertLessEqual(parameter["default"], parameter["maximum"])
        self.assertIn("Rosewood", next(p for p in parameters if p["id"] == "material")["choices"])

    def test_help_and_version_succeed(self):
        self.assertIn("render", self.succeed("--help").stdout)
        self.assertIn("--velocity", self.succeed("strike", "--help").stdout)
        self.assertIn("Idiophone 0.", self.succeed("--version").stdout)
