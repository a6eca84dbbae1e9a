"""Sound from shapes: modal analysis of triangle meshes, and bodies that are struck.

    import idiophone

    bell = idiophone.analyse(idiophone.load_mesh("bell.obj"), "Bronze")
    print(bell.frequencies[:5])
    sound = idiophone.strike(bell, impulse=(0, 0, -0.02))     # [frames, 2], 48 kHz

Lengths are in metres, times in seconds, frequencies in hertz.
"""
import numpy as _numpy

from ._core import (Material, Mesh, ModalObject, World, analyse, fit, load, load_material, load_mesh,
                    material_from_recording, materials)

__all__ = ["Material", "Mesh", "ModalObject", "World", "analyse", "fit", "load", "load_material",
           "load_mesh", "material_from_recording", "materials", "render", "strike"]
__version__ = "0.1.0"


def strike(body, impulse=(0.0, 0.0, -0.01), point=None, *, vertex=None, contact_time=0.0005,
           seconds=None, sample_rate=48000):
    """Returns the sound [frames, 2] of one strike, heard at the struck place (full scale 1 m/s).

    Without a point or a vertex the middle of the object's upper side is struck. Without `seconds`
    the sound lasts until it is silent, at most 30 s.
    """
    if point is None and vertex is None:
        low, high = body.vertices.min(axis=0), body.vertices.max(axis=0)
        point = (*((low + high) / 2)[:2], high[2])
    return render([body], [{"body": 0, "impulse": impulse, "point": point, "vertex": vertex,
                            "contact_time": contact_time}], seconds=seconds, sample_rate=sample_rate)


def render(bodies, impacts, *, seconds=None, sample_rate=48000):
    """Returns the sound [frames, 2] of impacts on bodies, as `idiophone render --impulses` does.

    `bodies` are as of World. Each impact is a dictionary of the arguments of World.strike. Without
    `seconds` the sound lasts until it is silent, at most 30 s after the last impact.
    """
    world = World(bodies, sample_rate=sample_rate, listener=False)
    waiting = sorted(impacts, key=lambda impact: impact.get("time") or 0.0)
    last = (waiting[-1].get("time") or 0.0) if waiting else 0.0
    frames = round(sample_rate * (last + 30 if seconds is None else seconds))
    sound, done, block = [_numpy.zeros((0, 2), _numpy.float32)], 0, 4096
    while done < frames and not (seconds is None and not waiting and world.silent):
        count = min(block, frames - done)
        due = 0
        while due < len(waiting) and (waiting[due].get("time") or 0.0) * sample_rate < done + count:
            world.strike(**waiting[due])
            due += 1
        del waiting[:due]
        sound.append(world.render(count))
        done += count
    return _numpy.concatenate(sound)
