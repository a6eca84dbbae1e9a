from test_benchmarks import BenchmarkTest


class LongBenchmarks(BenchmarkTest):
    """Those that take a minute or more."""

    def test_two_cores_render_the_samples_of_one(self):
        document = self.bench("render")
        figures = document["benchmarks"]["render"]
        self.assertEqual(figures["differing_samples"], 0)
        self.assertGreater(figures["samples"], 2 * 44100 * figures["seconds"])
        one, two = figures["curves"]
        self.assertAlmostEqual(two["mean_frames_per_second"] / one["mean_frames_per_second"],
                               figures["two_cores_over_one"])
        for curve in one, two:
            seconds = curve["frame_seconds"] * len(curve["frames_per_second"])
            self.assertAlmostEqual(seconds, figures["seconds"], delta=0.02)

    def test_two_cores_analyse_to_the_figures_of_one(self):
        document = self.bench("analysis")
        bodies = document["benchmarks"]["analysis"]["bodies"]
        self.assertEqual(len(bodies), 3)
        *speedups, same = document["goals"]
        self.assertEqual(same["measured"], 0)
        for body, goal in zip(bodies, speedups, strict=True):
            self.assertIn(body["name"], goal["name"])
            self.assertEqual(body["differing_figures"], 0)
            self.assertGreater(body["modes"], 10)
            self.assertAlmostEqual(goal["measured"],
                                   body["one_thread_wall_s"] / body["two_threads_wall_s"])
        self.assertGreater(bodies[-1]["triangles"], 18000)



