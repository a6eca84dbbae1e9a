"""LV2 atoms as bytes, for a host's event ports."""
import struct

LV2 = "http://lv2plug.in/ns/"


def atom(type_urid, body):
    return struct.pack("=II", len(body), type_urid) + body


def padded(data):
    return data + bytes(-len(data) % 8)


def midi_event(urid, message):
    return atom(urid(LV2 + "ext/midi#MidiEvent"), message)


def patch_set(urid, parameter, value):
    """Returns a message that sets a parameter, because JUCE's plugins have no control ports."""
    properties = (("property", "URID", struct.pack("=I", urid(parameter))),
                  ("value", "Float", struct.pack("=f", value)))
    body = struct.pack("=II", 0, urid(LV2 + "ext/patch#Set"))
    for key, kind, data in properties:
        body += struct.pack("=II", urid(LV2 + "ext/patch#" + key), 0)
        body += padded(atom(urid(LV2 + "ext/atom#" + kind), data))
    return atom(urid(LV2 + "ext/atom#Object"), body)


def position(urid, beats_per_minute):
    """Returns the position of a playing host, with only speed and tempo."""
    properties = (("speed", 1.0), ("beatsPerMinute", beats_per_minute))
    body = struct.pack("=II", 0, urid(LV2 + "ext/time#Position"))
    for key, value in properties:
        body += struct.pack("=II", urid(LV2 + "ext/time#" + key), 0)
        body += padded(atom(urid(LV2 + "ext/atom#Float"), struct.pack("=f", value)))
    return atom(urid(LV2 + "ext/atom#Object"), body)


def sequence(urid, events):
    """Returns a sequence of (frame, atom) events, which must be in time order."""
    body = struct.pack("=II", 0, 0)
    for frame, event in events:
        body += padded(struct.pack("=q", frame) + event)
    return atom(urid(LV2 + "ext/atom#Sequence"), body)


def empty_chunk(urid, capacity):
    """Returns the initial content of an output port, which the plugin replaces by a sequence."""
    return struct.pack("=II", capacity, urid(LV2 + "ext/atom#Chunk"))


def events_of(written):
    """Returns the types of the events in a sequence, as URIDs."""
    size, = struct.unpack_from("=I", written)
    types, start = [], 16
    while start < 8 + size:
        length, kind = struct.unpack_from("=II", written, start + 8)
        types.append(kind)
        start += 16 + length + -length % 8
    return types
