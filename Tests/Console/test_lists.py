import json
import math
import pathlib
import re
import sys

from console import OBJECTS, PROGRAM, ConsoleTest

DOCS = pathlib.Path(__file__).parents[2] / "docs"


class Lists(ConsoleTest):
    def test_the_manuals_parameters_presets_and_mallets_are_those_of_the_program(self):
        sys.path.insert(0, str(DOCS))
        from make_pages import pages
        for file, text in pages(PROGRAM).items():
            self.assertEqual(file.read_text(encoding="utf-8"), text, "`./dev pages` makes it anew")

    def test_each_preset_file_is_numbered_by_its_program(self):
        files = sorted((DOCS.parent / "Presets").iterdir())
        self.assertEqual([file.name[:3] for file in files],
                         [f"{number:02}-" for number in range(1, len(files) + 1)])
        programs = self.json("presets")
        self.assertEqual([json.loads(file.read_text())["name"] for file in files],
                         [preset["name"] for preset in programs])
        self.assertEqual([preset["program"] for preset in programs], list(range(len(files))))

    def test_the_matching_level_of_a_preset_does_not_depend_on_its_own_level(self):
        wok = next(p for p in self.json("presets") if p["name"] == "Wok")
        own = self.json("presets", "wok")
        self.assertLess(abs(own["matching_level_db"] - own["level_db"]), 1)
        wok["parameters"]["level"] = own["level_db"] - 30
        faint = self.json("presets", self.write("faint.json", json.dumps(wok)))
        self.assertAlmostEqual(faint["level_db"], own["level_db"] - 30)
        self.assertAlmostEqual(faint["matching_level_db"], own["matching_level_db"], places=3)
        said = self.succeed("presets", "wok").stdout
        self.assertIn(f" {own['matching_level_db']:.1f} dB;", said)

    def test_the_matching_level_of_a_preset_includes_its_room(self):
        wok = next(p for p in self.json("presets") if p["name"] == "Wok")
        dry = self.json("presets", "wok")["matching_level_db"]
        wok["parameters"]["room"] = 100
        roomy = self.json("presets", self.write("roomy.json", json.dumps(wok)))
        self.assertLess(roomy["matching_level_db"], dry - 0.5)

    def test_presets_without_a_matching_level_are_refused(self):
        self.refuse("presets", "Thrown Shells", naming="Thrown Shells", saying="scene")
        wok = next(p for p in self.json("presets") if p["name"] == "Wok")
        wok["mutedModes"] = {"all": list(range(1000))}
        wok["parameters"]["radiation"] = 0  # otherwise the click of the whole body sounds
        self.refuse("presets", self.write("muted.json", json.dumps(wok)),
                    naming="muted.json", saying="silent")

    def test_presets_are_listed_with_all_members_of_a_preset_file(self):
        presets = self.json("presets")
        self.assertEqual(presets[0]["name"], "Rosewood Xylophone")
        self.assertEqual({p["keyMap"]["kind"] for p in presets}, {"bars", "zones", "scaled", "scene", "kit"})
        text = self.succeed("presets").stdout
        for preset in presets:
            self.assertIn(preset["name"], text)
            self.assertIn(preset["description"], " ".join(text.split()))
            self.assertEqual(preset["format"], "idiophone-preset")

    def test_materials_are_listed_with_figures_and_sources(self):
        materials = self.json("materials")
        text = self.succeed("materials").stdout
        steel = next(m for m in materials if m["name"] == "Steel")
        self.assertEqual(steel["youngs_modulus_pa"], 2e11)
        self.assertEqual(steel["density_kg_per_m3"], 7850)
        for material in materials:
            self.assertIn(material["name"], text)
            self.assertTrue(material["source"])

    @staticmethod
    def words(text):
        return {word.rstrip(";") for word in text.split()}

    def test_listings_keep_to_80_characters_a_line(self):
        for listing in (("materials",), ("materials", "--sources"), ("parameters",), ("presets",),
                        ("scenes",)):
            lines = self.succeed(*listing).stdout.splitlines()
            settings = str(self.folder)  # the folder of user materials; its path may be long
            self.assertLessEqual(max(len(line) for line in lines if settings not in line), 80)

    def test_figures_of_materials_align_with_their_heading(self):
        lines = self.succeed("materials").stdout.splitlines()
        materials = self.json("materials")
        ends = [match.end() for match in re.finditer(r"\S+", lines[1])]
        for material, line in zip(materials, lines[2:]):
            self.assertTrue(line.startswith(material["name"] + " "))
            shown = [float(line[from_:to].split()[-1]) for from_, to in zip(ends, ends[1:])]
            self.assertAlmostEqual(shown[-1] / material["t60_s"]["4000"], 1, delta=0.005)
            self.assertAlmostEqual(shown[0] / material["density_kg_per_m3"], 1, delta=1e-4)
            self.assertAlmostEqual(shown[-4], material["viscoelastic_damping_s"] * 1e6, delta=1e-4)

    def test_sources_are_listed_on_request(self):
        plain, sourced = (self.succeed("materials", *options).stdout
                          for options in ((), ("--sources",)))
        self.assertNotIn("handbook", plain)
        for material in self.json("materials"):
            self.assertEqual(self.words(material["source"]) - self.words(sourced), set())

    def test_materials_are_listed_with_decay_times_of_their_damping_law(self):
        for material in self.json("materials"):
            for hz in (440, 1000, 4000):
                omega = 2 * math.pi * hz
                damping = (material["fluid_damping_per_s"] + material["loss_factor"] * omega +
                           material["viscoelastic_damping_s"] * omega ** 2)
                self.assertAlmostEqual(
                    material["t60_s"][str(hz)] * damping / (2 * math.log(1000)), 1, places=9)

    def test_a_material_listed_as_json_is_read_back_and_checked(self):
        bronze = next(m for m in self.json("materials") if m["name"] == "Bell bronze")
        file = self.write("bronze.json", json.dumps(bronze))
        self.assertEqual(self.json("materials", file), bronze)
        self.assertEqual(self.json("materials", "bell BRONZE"), bronze)
        text = self.succeed("materials", file).stdout
        for figure in ("Bell bronze", "105", "8800", "0.0002", "25", "11"):
            self.assertIn(figure, text)
        self.assertEqual(self.words(bronze["source"]) - self.words(text), set())

    def test_a_material_listed_as_json_can_be_used_for_objects(self):
        told = self.write("told.json", self.succeed("materials", "bell bronze", "--json").stdout)
        report = self.json("strike", OBJECTS / "plate.modal", "--material", told, "-o", self.folder / "bar.wav")
        self.assertEqual(report["material"], "Bell bronze")

    def test_materials_of_the_users_folder_are_listed_and_found_by_name(self):
        folder = self.folder / "settings" / "Idiophone" / "Materials"
        folder.mkdir(parents=True)
        jade = {"youngs_modulus_pa": 1.1e11, "density_kg_per_m3": 3300, "poisson_ratio": 0.27,
                "loss_factor": 1e-4}
        (folder / "Jade.json").write_text(json.dumps(jade))
        self.assertEqual(self.json("materials")[-1]["name"], "Jade")
        self.assertEqual(self.json("materials", "jade")["density_kg_per_m3"], 3300)
        self.assertIn(str(folder), self.succeed("materials").stdout)
        (folder / "broken.json").write_text("{")
        listed = self.succeed("materials")
        self.assertIn("Jade", listed.stdout)
        self.assertEqual(listed.stderr, f"idiophone: {folder / 'broken.json'}: it is not JSON "
                                        "(line 1, column 2)\n")
        self.assertEqual(self.json("materials", "jade")["name"], "Jade")

    def test_parameters_are_listed_with_units_ranges_and_defaults(self):
        parameters = self.json("parameters")
        text = self.succeed("parameters").stdout
        tau = next(p for p in parameters if p["id"] == "tau")
        self.assertEqual(tau["unit"], "steps")
        self.assertEqual({p["id"] for p in parameters if p["physical"]},
                         {"young", "density", "gamma", "eta", "loss_factor", "mallet_hardness",
                          "mallet_mass", "mallet_radius", "mallet_exponent", "mallet_speed", "force",
                          "speed", "roughness"})
        for parameter in parameters:
            self.assertIn(parameter["id"], text)
            self.assertLessEqual(parameter["minimum"], parameter["default"])
            self.assertLessEqual(parameter["default"], parameter["maximum"])
        row = next(line for line in text.splitlines() if line.startswith("tau "))
        self.assertEqual(row.split()[1:6], ["0.001", "to", "1000", "steps", "0.1"])
        for names in (p["choices"] for p in parameters if "choices" in p):
            self.assertIn("; ".join(names), " ".join(text.split()))
        self.assertIn("Rosewood", next(p for p in parameters if p["id"] == "material")["choices"])

    def test_help_and_version_succeed(self):
        self.assertIn("render", self.succeed("--help").stdout)
        self.assertIn("--velocity", self.succeed("strike", "--help").stdout)
        self.assertIn("Idiophone 0.", self.succeed("--version").stdout)
