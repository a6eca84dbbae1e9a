"""A host for one LV2 instrument, through LV2's C interface; lilv (lv2info) lists its ports."""
import ctypes
import re
import subprocess

import numpy

import lv2_state
from lv2_atoms import LV2, empty_chunk, events_of, midi_event, patch_set, position, sequence

SEQUENCE_BYTES = 1 << 16
LONGEST_BLOCK = 1 << 14


class Descriptor(ctypes.Structure):
    """LV2_Descriptor."""


Handle = ctypes.c_void_p
Descriptor._fields_ = [
    ("uri", ctypes.c_char_p),
    ("instantiate", ctypes.CFUNCTYPE(Handle, ctypes.POINTER(Descriptor), ctypes.c_double,
                                     ctypes.c_char_p, ctypes.c_void_p)),
    ("connect_port", ctypes.CFUNCTYPE(None, Handle, ctypes.c_uint32, ctypes.c_void_p)),
    ("activate", ctypes.CFUNCTYPE(None, Handle)),
    ("run", ctypes.CFUNCTYPE(None, Handle, ctypes.c_uint32)),
    ("deactivate", ctypes.CFUNCTYPE(None, Handle)),
    ("cleanup", ctypes.CFUNCTYPE(None, Handle)),
    ("extension_data", ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_char_p)),
]


class Feature(ctypes.Structure):
    """LV2_Feature."""
    _fields_ = [("uri", ctypes.c_char_p), ("data", ctypes.c_void_p)]


MapFunction = ctypes.CFUNCTYPE(ctypes.c_uint32, ctypes.c_void_p, ctypes.c_char_p)


class UridMap(ctypes.Structure):
    """LV2_URID_Map."""
    _fields_ = [("handle", ctypes.c_void_p), ("map", MapFunction)]


class Option(ctypes.Structure):
    """LV2_Options_Option."""
    _fields_ = [("context", ctypes.c_int), ("subject", ctypes.c_uint32), ("key", ctypes.c_uint32),
                ("size", ctypes.c_uint32), ("type", ctypes.c_uint32), ("value", ctypes.c_void_p)]


def ports_of(uri, environment):
    """Returns [(index, symbol, set of type names, default value)], read by lilv from the plugin's
    files."""
    text = subprocess.run(["lv2info", uri], env=environment, check=True, capture_output=True,
                          text=True).stdout
    ports = []
    for index, body in re.findall(r"^\tPort (\d+):\n((?:\t\t.*\n|\n)*)", text, re.MULTILINE):
        types = set(re.findall(r"[#](\w+Port)\b", body))
        symbol = re.search(r"Symbol:\s+(\S+)", body).group(1)
        default = re.search(r"Default:\s+(\S+)", body)
        ports.append((int(index), symbol, types, float(default.group(1)) if default else 0.0))
    return ports


class Lv2Host:
    """One instance. The host announces blocks of at most `block` samples."""

    def __init__(self, bundle, uri, environment, sample_rate, block):
        self.block, self.uris, self.keep, self.changes = block, {}, [], []
        library = ctypes.CDLL(str(next(path for ending in ("so", "dylib", "dll")
                                       for path in bundle.glob(f"*.{ending}"))))
        library.lv2_descriptor.restype = ctypes.POINTER(Descriptor)
        self.descriptor = library.lv2_descriptor(0)
        assert self.descriptor.contents.uri.decode() == uri
        self.handle = self.descriptor.contents.instantiate(
            self.descriptor, sample_rate, f"{bundle}/".encode(), self.features())
        assert self.handle, "the plugin did not start"
        self.connect(ports_of(uri, environment))
        self.descriptor.contents.activate(self.handle)

    def close(self):
        self.descriptor.contents.deactivate(self.handle)
        self.descriptor.contents.cleanup(self.handle)

    def urid(self, uri):
        return self.uris.setdefault(uri, len(self.uris) + 1)

    def features(self):
        """Returns the features that JUCE's plugins need: a URID map and the block size option."""
        map_function = MapFunction(lambda _, uri: self.urid(uri.decode()))
        urid_map = UridMap(None, map_function)
        size = ctypes.c_int32(self.block)
        integer = self.urid(LV2 + "ext/atom#Int")
        options = (Option * 3)(*[
            Option(0, 0, self.urid(LV2 + "ext/buf-size#" + key), 4, integer,
                   ctypes.cast(ctypes.pointer(size), ctypes.c_void_p))
            for key in ("minBlockLength", "maxBlockLength")], Option())
        listed = [Feature((LV2 + name).encode(), data and ctypes.cast(data, ctypes.c_void_p))
                  for name, data in (("ext/urid#map", ctypes.pointer(urid_map)),
                                     ("ext/options#options", options),
                                     ("ext/buf-size#boundedBlockLength", None))]
        pointers = (ctypes.POINTER(Feature) * (len(listed) + 1))(*map(ctypes.pointer, listed), None)
        self.keep += [map_function, urid_map, size, options, listed, pointers]
        return ctypes.cast(pointers, ctypes.c_void_p)

    def connect(self, ports):
        self.audio, self.controls, self.events_in, self.events_out = [], {}, None, None
        for index, symbol, types, default in ports:
            if "AudioPort" in types:
                memory = numpy.zeros(LONGEST_BLOCK, dtype=numpy.float32)
                if "OutputPort" in types:
                    self.audio.append(memory)
            elif "AtomPort" in types:
                memory = ctypes.create_string_buffer(SEQUENCE_BYTES)
                if "InputPort" in types:
                    self.events_in = memory
                else:
                    self.events_out = memory
            else:
                memory = self.controls[symbol] = ctypes.c_float(default)
            self.keep.append(memory)
            address = (memory.ctypes.data if isinstance(memory, numpy.ndarray)
                       else ctypes.addressof(memory))
            self.descriptor.contents.connect_port(self.handle, index, address)

    def set_control(self, symbol, value):
        self.controls[symbol].value = value

    def set_parameter(self, uri, value):
        """Sets a parameter at the first sample of the next block."""
        self.changes.append((0, patch_set(self.urid, uri, value)))

    def set_tempo(self, beats_per_minute):
        """Sends the tempo with the next block."""
        self.changes.append((0, position(self.urid, beats_per_minute)))

    def sent(self):
        """Returns the types of the events that the plugin sent in the last block."""
        names = {number: uri for uri, number in self.uris.items()}
        return [names[number] for number in events_of(self.events_out.raw)]

    def save(self):
        return lv2_state.save(self.descriptor, self.handle)

    def restore(self, saved):
        lv2_state.restore(self.descriptor, self.handle, saved)

    def run(self, messages, frames):
        """Renders one block with (frame, MIDI bytes) in time order; returns [channels, frames]."""
        events = self.changes + [(frame, midi_event(self.urid, message))
                                 for frame, message in messages]
        self.changes = []
        written = sequence(self.urid, events)
        ctypes.memmove(self.events_in, written, len(written))
        if self.events_out is not None:
            room = empty_chunk(self.urid, SEQUENCE_BYTES - 8)
            ctypes.memmove(self.events_out, room, len(room))
        self.descriptor.contents.run(self.handle, frames)
        return numpy.array([channel[:frames] for channel in self.audio])

    def render(self, messages, frames, lengths=None):
        """Plays (sample, MIDI bytes) in time order, in blocks of these lengths and then of the
        announced one; returns [channels, frames]."""
        rendered, waiting, start = [], list(messages), 0
        lengths = iter(lengths or ())
        while start < frames:
            length = min(next(lengths, self.block), frames - start)
            now = [(sample - start, message) for sample, message in waiting
                   if sample < start + length]
            waiting = waiting[len(now):]
            rendered.append(self.run(now, length))
            start += length
        return numpy.concatenate(rendered, axis=1)
