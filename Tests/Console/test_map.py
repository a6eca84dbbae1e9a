import os
import unittest

from console import OBJECTS, ConsoleTest, many_modes, most_memory_bytes

BAR = OBJECTS / "xylophone-72.modal"


def read_ply(path):
    """Returns the vertices of a text PLY file as dictionaries, and the face count of its header."""
    lines = path.read_text().splitlines()
    names, faces, at_faces = [], 0, False
    for number, line in enumerate(lines):
        words = line.split()
        if words[:2] == ["element", "vertex"]:
            count = int(words[2])
        elif words[:2] == ["element", "face"]:
            faces, at_faces = int(words[2]), True
        elif words[0] == "property" and not at_faces:
            names.append(words[2])
        elif words == ["end_header"]:
            body = lines[number + 1:]
            break
    assert len(body) == count + faces
    return [dict(zip(names, map(float, line.split()))) for line in body[:count]], faces


class ToneMap(ConsoleTest):
    def test_a_bar_is_coloured_by_its_brightness(self):
        output = self.folder / "bar.ply"
        told = self.json("map", BAR, "-o", output)
        vertices, faces = read_ply(output)
        self.assertEqual(len(vertices), told["vertices"])
        self.assertGreater(faces, 50)
        values = [v["brightness_hz"] for v in vertices]
        self.assertEqual(told["silent_vertices"], 0)
        self.assertAlmostEqual(min(values), told["darkest"]["brightness_hz"], places=6)
        self.assertAlmostEqual(max(values), told["brightest"]["brightness_hz"], places=6)
        self.assertGreater(max(values), 1.5 * min(values))
        self.assertGreaterEqual(min(values), 523)
        darkest = min(vertices, key=lambda v: v["brightness_hz"])
        brightest = max(vertices, key=lambda v: v["brightness_hz"])
        self.assertEqual([darkest[c] for c in ("red", "green", "blue")], [68, 1, 84])
        self.assertEqual([brightest[c] for c in ("red", "green", "blue")], [253, 231, 37])

    def test_the_middle_of_a_bar_is_darker_than_the_nodes_of_its_fundamental(self):
        output = self.folder / "bar.ply"
        self.json("map", BAR, "-o", output)
        vertices, _ = read_ply(output)
        half = max(v["x"] for v in vertices)

        def brightness(share):
            return min(vertices, key=lambda v: (abs(abs(v["x"]) - share * half) + abs(v["y"])
                                                - 1e-3 * v["z"]))["brightness_hz"]
        self.assertGreater(brightness(0.5516), 1.2 * brightness(0))

    @unittest.skipUnless(hasattr(os, "wait4"), "figures of POSIX")
    def test_close_modes_take_no_memory_for_each_pair(self):
        crowd = self.write("crowd.modal", many_modes(12000))
        most, code = most_memory_bytes("map", crowd, "-o", self.folder / "crowd.ply")
        self.assertEqual(code, 0)
        self.assertLess(most, 1e9)  # 72 million pairs of 24 bytes would take more

    def test_the_range_is_reported(self):
        text = self.succeed("map", BAR, "-o", self.folder / "bar.ply").stdout
        for word in ("bar.ply", "darkest", "brightest", "Hz", "vertex"):
            self.assertIn(word, text)

    def test_impossible_requests_get_one_sentence(self):
        self.refuse("map", self.folder / "no.modal", "-o", self.folder / "a.ply",
                    naming="no.modal", saying="cannot be opened")
        self.refuse("map", BAR, "-o", self.folder / "a.obj", naming="a.obj", saying=".ply")
        self.refuse("map", BAR, "-o", self.folder / "no" / "a.ply", naming="a.ply",
                    saying="cannot be written")
        self.refuse("map", BAR, naming="--output")
