import json

from console import OBJECTS, ConsoleTest, run

SONG = OBJECTS.parent / "Songs" / "TheEntertainer.mid"


class BenchmarkTest(ConsoleTest):
    """Does not check times, because they depend on the machine."""

    def bench(self, *arguments):
        document = self.json(*arguments)
        for goal in document["goals"]:
            self.assertIn(goal["relation"], ("at least", "at most"))
            above = goal["measured"] >= goal["bound"]
            below = goal["measured"] <= goal["bound"]
            self.assertEqual(goal["met"], above if goal["relation"] == "at least" else below)
            self.assertIn(goal["name"].split(":")[0], document["benchmarks"])
        return document


class Benchmarks(BenchmarkTest):
    def test_truncation_ends_at_the_time_of_eq_14(self):
        document = self.bench("tau")
        self.assertEqual([goal["met"] for goal in document["goals"]], [True] * 3)
        fine, coarse = document["benchmarks"]["tau"]["runs"]
        self.assertGreater(fine["modes"][2], 3)
        for mixed, fewer in zip(fine["modes"], coarse["modes"]):
            self.assertGreaterEqual(mixed, fewer)
        for run in fine, coarse:
            seconds = sum(run["modes"]) * document["benchmarks"]["tau"]["cell_s"]
            self.assertAlmostEqual(seconds, run["mode_seconds"], places=6)

    def test_a_budget_limits_the_modes_of_any_number_of_bodies(self):
        document = self.bench("scale")
        self.assertEqual([goal["met"] for goal in document["goals"]
                          if "modes mixed" in goal["name"]], [True] * 3)
        few, some, many = document["benchmarks"]["scale"]["crowds"]
        self.assertGreater(many["unscaled"]["modes_mixed_mean"],
                           8 * some["unscaled"]["modes_mixed_mean"])
        self.assertGreater(some["unscaled"]["modes_mixed_mean"],
                           8 * few["unscaled"]["modes_mixed_mean"])
        self.assertGreater(many["scaled"]["modes_mixed_mean"], 450)

    def test_compression_moves_the_level_by_less_than_half_a_decibel(self):
        figures = self.bench("compression")["benchmarks"]["compression"]
        self.assertEqual({o["name"] for o in figures["objects"]},
                         {path.stem for path in OBJECTS.glob("*.modal")})
        for entry in figures["objects"]:
            self.assertLessEqual(entry["groups"], entry["modes"])
            self.assertLessEqual(entry["mean_error_db"], entry["largest_error_db"])
            self.assertLess(entry["largest_error_db"], 0.5, entry["name"])
        self.assertLess(sum(o["groups"] for o in figures["objects"]),
                        sum(o["modes"] for o in figures["objects"]))

    def test_the_kernel_is_below_its_peak_and_exact_after_ten_seconds(self):
        document = self.bench("kernel")
        figures = document["benchmarks"]["kernel"]
        self.assertEqual([size["modes"] for size in figures["sizes"]],
                         ["64", "500", "1000", "10000", "37x100"])
        for size in figures["sizes"]:
            self.assertGreater(size["share_of_peak"], size["naive_share_of_peak"])
            self.assertLess(size["share_of_peak"], 1)
        self.assertEqual(set(figures["error_after_10_s_db"]), {"500", "1000"})
        for error in figures["error_after_10_s_db"].values():
            self.assertLess(error, -110)
        self.assertTrue(document["build"]["simd_target"])

    def test_the_worst_cell_is_compared_with_the_mean_of_cells_where_all_ring(self):
        document = self.bench("callback")
        figures = document["benchmarks"]["callback"]
        measured = {goal["name"]: goal["measured"] for goal in document["goals"]}
        self.assertEqual(len(measured), 3)
        for scene in figures["scenes"]:
            ringing = scene["seconds"][37:]
            self.assertEqual(len(ringing), 35)
            self.assertEqual(scene["worst_s"], max(ringing))
            self.assertEqual(scene["struck_s"], scene["seconds"][48])
            self.assertAlmostEqual(scene["mean_s"], sum(ringing) / 35)
            self.assertEqual(measured["callback: worst over mean, " + scene["name"]],
                             scene["worst_s"] / scene["mean_s"])
            self.assertGreater(scene["struck_s"], scene["mean_s"])
        self.assertLess(figures["silence_over_sound"], 1)

    def test_force_is_compared_with_free_cells_of_the_same_run(self):
        document = self.bench("force")
        figures = document["benchmarks"]["force"]
        self.assertEqual([size["modes"] for size in figures["sizes"]], [100, 500, 1000])
        measured = {goal["name"]: goal["measured"] for goal in document["goals"]}
        self.assertEqual(len(measured), 4)
        for size in figures["sizes"]:
            for contact in "staying", "moving":
                self.assertGreater(size[f"{contact}_s"], size["free_s"])
                self.assertAlmostEqual(size[f"{contact}_over_free"],
                                       size[f"{contact}_s"] / size["free_s"])
                if size["modes"] >= 500:
                    name = f"force: cost over the free bank at {size['modes']} modes, {contact}"
                    self.assertEqual(measured[name], size[f"{contact}_over_free"])
        self.assertEqual([source["name"] for source in figures["generators"]],
                         ["scrape", "roll", "coupled roll"])
        for source in figures["generators"]:
            self.assertGreater(source["seconds"], 0)
            self.assertAlmostEqual(source["over_free_500"],
                                   source["seconds"] / figures["sizes"][1]["free_s"])

    def test_each_factory_scene_has_a_goal_for_its_motion(self):
        document = self.bench("scenes")
        scenes = document["benchmarks"]["scenes"]["scenes"]
        self.assertEqual(len(scenes), len(list((OBJECTS.parent / "Scenes").glob("*.json"))))
        self.assertIn("scenes: motion over real time, 100 rings",
                      [goal["name"] for goal in document["goals"]])
        for scene, goal in zip(scenes, document["goals"], strict=True):
            self.assertEqual(goal["measured"], scene["motion_over_real_time"])
            self.assertGreaterEqual(scene["slowest_tenth_over_real_time"],
                                    scene["motion_over_real_time"])
            self.assertGreater(scene["impacts"], 0)

    def test_the_song_benchmark_plays_the_xylophone(self):
        figures = self.bench("xylophone", "--song", SONG)["benchmarks"]["xylophone"]
        self.assertGreater(figures["strikes"], 100)
        self.assertGreater(figures["modes_mixed_most"], figures["modes_mixed_mean"])
        self.assertGreater(figures["share_of_core"], 0)

    def test_the_check_fails_if_a_goal_is_missed(self):
        path = self.folder / "callback.json"
        checked = run("callback", "--check", "--json", "-o", path)
        missed = [goal for goal in json.loads(path.read_text())["goals"] if not goal["met"]]
        self.assertEqual(checked.returncode, 1 if missed else 0)
        for goal in missed[:1]:
            self.assertIn(goal["name"], checked.stderr)

    def test_the_text_and_the_file_give_the_same_goals(self):
        text = self.succeed("tau").stdout
        path = self.folder / "tau.json"
        self.succeed("tau", "--json", "-o", path)
        for goal in json.loads(path.read_text())["goals"]:
            self.assertIn(goal["name"], text)

    def test_bad_requests_are_refused_in_one_sentence(self):
        self.refuse("speed", naming="speed")
        self.refuse("xylophone", naming="--song")
        self.refuse("xylophone", "--song", self.folder / "none.mid", naming="none.mid")
        self.refuse("tau", "-o", self.folder, naming=self.folder)
