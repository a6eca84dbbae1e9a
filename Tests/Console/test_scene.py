import json

from console import ConsoleTest, Wave

BALL = {
    "format": "idiophone-scene", "version": 1, "name": "Ball on a plate", "seconds": 1,
    "kinds": [{"name": "plate", "object": "plate", "fixed": True},
              {"name": "ball", "ball": {"radius": 0.01, "material": "Steel"}}],
    "bodies": [{"kind": "plate"}, {"kind": "ball", "at": [0.05, 0.03, 0.2115]}],
}


class Scenes(ConsoleTest):
    def scene(self, **changes):
        return self.write("scene.json", json.dumps({**BALL, **changes}))

    def perform(self, scene, *options, name="scene.wav"):
        output = self.folder / name
        return self.json("scene", scene, "-o", output, *options), Wave(output)

    def test_the_factory_scenes_are_listed(self):
        scenes = self.json("scenes")
        self.assertEqual(scenes[0]["name"], "Dice on a xylophone")
        self.assertTrue(scenes[0]["takes_midi"])
        text = self.succeed("scenes").stdout
        for scene in scenes:
            self.assertIn(scene["description"], text)

    def test_a_ball_falls_on_a_plate_and_is_heard_when_it_does(self):
        report, wave = self.perform(self.scene())
        # From 20 cm above the plate, whose top is at 1.5 mm.
        onset = next(i for i, x in enumerate(wave.left) if x != 0) / 48000
        self.assertAlmostEqual(onset, (2 * 0.2 / 9.81) ** 0.5, delta=0.003)
        self.assertGreaterEqual(report["impacts"], 4)
        self.assertEqual(report["bodies_most"], 2)
        self.assertEqual(sum(report["impacts_of_frame"]), report["impacts"])
        self.assertGreater(max(report["modes_mixed"]), 50)
        self.assertGreater(report["audio_frames_per_second"], 0)

    def test_the_same_scene_is_the_same_file(self):
        file = self.scene()
        self.assertEqual(self.perform(file)[1].left, self.perform(file, name="again.wav")[1].left)

    def test_what_is_out_of_budget_is_counted(self):
        report, _ = self.perform(self.scene(), "--set", "budget=16")
        self.assertGreater(max(report["modes_dropped"]), 0)

    def test_impacts_are_written_as_impulses_that_render(self):
        impulses = self.folder / "impacts.jsonl"
        scene = self.scene(kinds=[BALL["kinds"][0],
                                  {"name": "ball", "object": "die", "size": 0.9}])
        report, _ = self.perform(scene, "--impulses", impulses)
        lines = [json.loads(line) for line in impulses.read_text().splitlines()]
        self.assertEqual(len(lines), report["impacts"])
        self.assertEqual({line.get("size", 1) for line in lines}, {1, 0.9})
        played = self.json("render", "--impulses", impulses, "-o", self.folder / "impacts.wav")
        self.assertEqual(played["strikes"], report["impacts"])

    def test_songs_need_something_to_drop(self):
        song = self.write("song.mid", "")
        self.refuse("scene", self.scene(), "--midi", song, "-o", self.folder / "x.wav",
                    naming="Ball on a plate", saying="nothing is dropped")

    def test_bad_scenes_get_a_sentence(self):
        self.refuse("scene", "No such scene", "-o", self.folder / "x.wav",
                    naming="No such scene", saying="'Dice on a xylophone'")
        self.refuse("scene", self.scene(gravity="much"), "-o", self.folder / "x.wav",
                    naming="scene.json", saying="gravity is not a number")
        self.refuse("scene", self.write("broken.json", "{"), "-o", self.folder / "x.wav",
                    naming="broken.json", saying="line 1")
        missing = {"name": "ball", "object": "missing.modal"}
        self.refuse("scene", self.scene(kinds=[BALL["kinds"][0], missing]),
                    "-o", self.folder / "x.wav", naming="missing.modal")
