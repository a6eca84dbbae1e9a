"""Reads and writes glTF files with KHR_audio_rigid_bodies, and computes the draft's formulas. It
shares no code with the program."""
import array
import base64
import json
import math
import pathlib
import struct

AUDIO = "KHR_audio_rigid_bodies"
COUNTS = {"SCALAR": 1, "VEC3": 3}
CODES = {5126: "f", 5125: "I", 5123: "H"}


class GltfFile:
    """Collects accessors in one buffer."""

    def __init__(self, **document):
        self.data = b""
        self.document = {"asset": {"version": "2.0"}, "accessors": [], "bufferViews": [], **document}

    def add(self, values, kind="SCALAR", component=5126):
        content = array.array(CODES[component], values).tobytes()
        self.document["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data),
                                             "byteLength": len(content)})
        self.document["accessors"].append({
            "bufferView": len(self.document["bufferViews"]) - 1, "componentType": component,
            "count": len(values) // COUNTS[kind], "type": kind})
        self.data += content + bytes(-len(content) % 4)
        return len(self.document["accessors"]) - 1

    def text(self):
        self.document["buffers"] = [{
            "byteLength": len(self.data),
            "uri": "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()}]
        return json.dumps(self.document)


def parse(path):
    """Returns the document and a function that returns an accessor's elements."""
    raw = pathlib.Path(path).read_bytes()
    if raw[:4] == b"glTF":
        length = struct.unpack_from("<I", raw, 12)[0]
        document, data = json.loads(raw[20:20 + length]), raw[28 + length:]
    else:
        document = json.loads(raw)
        data = base64.b64decode(document["buffers"][0]["uri"].split(",")[1])

    def elements(index):
        accessor = document["accessors"][index]
        view = document["bufferViews"][accessor["bufferView"]]
        values = array.array(CODES[accessor["componentType"]])
        width = COUNTS[accessor["type"]]
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        values.frombytes(data[begin:begin + accessor["count"] * width * values.itemsize])
        return [tuple(values[i:i + width]) for i in range(0, len(values), width)]

    return document, elements


class Model:
    """A modal model as the draft defines it."""

    def __init__(self, model, elements):
        self.frequencies = [f for f, in elements(model["frequencies"])]
        self.decays = [d for d, in elements(model["decayRates"])]
        self.positions = elements(model["positions"])
        self.shapes = elements(model["shapes"])

    def amplitudes(self, point, impulse, rate):
        """Returns 2πf a of every mode (Synthesis), 0 from the Nyquist frequency on."""
        count = len(self.positions)
        return [2 * math.pi * f * sum(s * j for s, j in zip(self.shapes[m * count + point], impulse))
                if f < rate / 2 else 0 for m, f in enumerate(self.frequencies)]

    def signal(self, point, impulse, rate, count):
        total = [0.0] * count
        for f, d, a in zip(self.frequencies, self.decays, self.amplitudes(point, impulse, rate)):
            for n in range(count):
                t = n / rate
                total[n] += a * math.exp(-d * t) * math.sin(2 * math.pi * f * t)
        return total
