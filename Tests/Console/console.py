"""Runs the program in the environment variable IDIOPHONE, and reads its output."""
import array
import cmath
import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.environ["IDIOPHONE"]
ON_QEMU = "qemu" in os.environ.get("IDIOPHONE_EMULATOR", "")
OBJECTS = pathlib.Path(__file__).resolve().parents[2] / "Resources" / "Objects"


def run(*arguments, environment=(), largest_file_bytes=None):
    def fill_disk():
        import resource  # POSIX only
        import signal

        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file_bytes, largest_file_bytes))

    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, **dict(environment)},
                          preexec_fn=None if largest_file_bytes is None else fill_disk)


def most_memory_bytes(*arguments):
    """Returns the peak memory of a run in bytes and its exit code. POSIX only."""
    with subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return usage.ru_maxrss * (1 if sys.platform == "darwin" else 1024), process.returncode


class ConsoleTest(unittest.TestCase):
    """Gives each test a directory of its own, and checks that the program succeeds or refuses."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = pathlib.Path(directory.name)
        # Hide the materials of the user who runs the tests.
        settings = str(self.folder / "settings")
        self.environment = {"XDG_CONFIG_HOME": settings, "APPDATA": settings}  # the second for Windows

    def succeed(self, *arguments):
        result = run(*arguments, environment=self.environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def json(self, *arguments):
        return json.loads(self.succeed(*arguments, "--json").stdout)

    def refuse(self, *arguments, naming, saying="", largest_file_bytes=None):
        """Checks that the program fails with one sentence naming the fault, and leaves no files."""
        before = set(self.folder.rglob("*"))
        result = run(*arguments, environment=self.environment,
                     largest_file_bytes=largest_file_bytes)
        with self.subTest(arguments=arguments, stderr=result.stderr):
            self.assertIn(result.returncode, (1, 2), "a refusal, no signal and no success")
            self.assertEqual(result.stdout, "")
            self.assertEqual(result.stderr.count("\n"), 1, "one line")
            self.assertTrue(result.stderr.startswith(pathlib.Path(PROGRAM).stem + ": "))
            self.assertIn(str(naming), result.stderr)
            self.assertIn(saying, result.stderr)
            self.assertEqual(set(self.folder.rglob("*")), before, "no files are left behind")

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path


class Wave:
    """Returns the channels of a WAV file as floats."""

    def __init__(self, path):
        raw = pathlib.Path(path).read_bytes()
        assert raw[:4] == b"RIFF" and raw[8:12] == b"WAVE", "not a WAV file"
        chunks, position = {}, 12
        while position + 8 <= len(raw):
            size = struct.unpack_from("<I", raw, position + 4)[0]
            chunks[raw[position:position + 4]] = raw[position + 8:position + 8 + size]
            position += 8 + size + size % 2
        tag, self.channel_count, self.rate, _, _, self.bits = struct.unpack_from(
            "<HHIIHH", chunks[b"fmt "])
        if tag == 0xFFFE:
            tag = struct.unpack_from("<H", chunks[b"fmt "], 24)[0]
        self.is_float = tag == 3
        values = self.decode(chunks[b"data"])
        self.channels = [values[c::self.channel_count] for c in range(self.channel_count)]

    def decode(self, data):
        if self.is_float:
            return array.array("f", data)
        width = self.bits // 8
        return [int.from_bytes(data[i:i + width], "little", signed=True) / (1 << (self.bits - 1))
                for i in range(0, len(data), width)]

    @property
    def left(self):
        return self.channels[0]

    def __len__(self):
        return len(self.left)

    def peak(self):
        return max(map(abs, self.left), default=0.0)

    def level_at(self, frequency, start=0, count=None):
        """Returns the amplitude of a frequency under a Hann window."""
        samples = self.left[start:None if count is None else start + count]
        n = len(samples)
        turn = cmath.exp(-2j * math.pi * frequency / self.rate)
        phase, total = 1, 0
        for i, sample in enumerate(samples):
            total += sample * (0.5 - 0.5 * math.cos(2 * math.pi * i / n)) * phase
            phase *= turn
        return abs(total) / n


def variable_length(number):
    parts = [number & 0x7F]
    while number := number >> 7:
        parts.insert(0, 0x80 | number & 0x7F)
    return bytes(parts)


def midi_track(events):
    """Makes a track from (ticks, bytes), sorted stably by time. Meta events include their FF."""
    body, now = b"", 0
    events = sorted(events, key=lambda event: event[0])
    for ticks, message in [*events, (events[-1][0] if events else 0, b"\xff\x2f\x00")]:
        body += variable_length(ticks - now) + message
        now = ticks
    return b"MTrk" + struct.pack(">I", len(body)) + body


def midi_file(*tracks, division=480):
    return (b"MThd" + struct.pack(">IHHh", 6, 0 if len(tracks) == 1 else 1, len(tracks), division)
            + b"".join(map(midi_track, tracks)))


def note(ticks, number, velocity=100, length=240):
    return [(ticks, bytes([0x90, number, velocity])), (ticks + length, bytes([0x80, number, 64]))]


def tempo(ticks, microseconds_per_quarter):
    return ticks, b"\xff\x51\x03" + microseconds_per_quarter.to_bytes(3, "big")


def mesh_text(path):
    """Returns the lists of vertices and faces of an OBJ file, with indices from 0."""
    vertices, faces = [], []
    for line in pathlib.Path(path).read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            vertices.append([float(x) for x in rest[:3]])
        elif word == "f":
            faces.append([int(x.split("/")[0]) - 1 for x in rest])
    return vertices, faces


def obj_text(vertices, faces):
    return ("".join("v {!r} {!r} {!r}\n".format(*v) for v in vertices) +
            "".join("f {} {} {}\n".format(*(corner + 1 for corner in f)) for f in faces))


def modal_parts(content):
    """Returns the header and the tensors' bytes of a .modal file."""
    size = struct.unpack_from("<Q", content)[0]
    return json.loads(content[8:8 + size]), content[8 + size:]


def modal_bytes(header, data):
    text = json.dumps(header).encode()
    return struct.pack("<Q", len(text)) + text + data


def many_modes(mode_count, **metadata):
    """Makes a small .modal file: a box whose modes all lie within some hundred Hz."""
    source, _ = modal_parts((OBJECTS / "xylophone-108.modal").read_bytes())
    vertices = [0.1 * (corner >> axis & 1) for corner in range(8) for axis in range(3)]
    faces = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
             2, 4, 6, 1, 3, 5, 3, 7, 5]
    eigenvalues = ((2 * math.pi * (1000 + 5e-3 * mode)) ** 2 for mode in range(mode_count))
    header = {"__metadata__": {**source["__metadata__"], **metadata}}
    data = b""
    for name, kind, shape, content in (
            ("eigenvalues", "F64", [mode_count], array.array("d", eigenvalues).tobytes()),
            ("vertices", "F32", [8, 3], array.array("f", vertices).tobytes()),
            ("faces", "I32", [12, 3], array.array("i", faces).tobytes()),
            ("shape_vertices", "I32", [3], array.array("i", [0, 1, 2]).tobytes()),
            ("shapes", "F16", [3, mode_count, 3], struct.pack("<e", 1) * (9 * mode_count))):
        header[name] = {"dtype": kind, "shape": shape,
                        "data_offsets": [len(data), len(data) + len(content)]}
        data += content
    return modal_bytes(header, data)
