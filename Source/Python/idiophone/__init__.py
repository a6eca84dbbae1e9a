"""Sound from shapes: modal analysis of triangle meshes, and bodies that are struck.

    import idiophone

    bell = idiophone.analyse(idiophone.load_mesh("bell.obj"), "Bell bronze")
    print(bell.frequencies[:5])
    sound = idiophone.strike(bell, impulse=(0, 0, -0.02))     # [frames, 2], 48 kHz

Lengths are in metres, times in seconds, frequencies in hertz. A function that cannot do its work raises ValueError with
one sentence. Meshes, materials and modal objects can be pickled.
"""
from __future__ import annotations

from collections.abc import Iterable as _Iterable, Mapping as _Mapping, Sequence as _Sequence
from typing import Any as _Any, Optional as _Optional, Union as _Union

import numpy as _numpy
from numpy.typing import ArrayLike as _ArrayLike, NDArray as _NDArray

from ._core import (Material, Mesh, ModalObject, World, analyse, fit, load, load_material, load_mesh,
                    material_from_recording, materials, version as _version)

__all__ = ["Material", "Mesh", "ModalObject", "World", "analyse", "fit", "load", "load_material",
           "load_mesh", "material_from_recording", "materials", "render", "strike"]
__version__ = _version

_Body = _Union[ModalObject, tuple[ModalObject, float]]


def strike(body: _Body, impulse: _ArrayLike = (0.0, 0.0, -0.01), point: _Optional[_ArrayLike] = None, *,
           vertex: _Optional[int] = None, contact_time: float = 0.0005, seconds: _Optional[float] = None,
           sample_rate: float = 48000) -> _NDArray[_numpy.float32]:
    """Returns the sound [frames, 2] of one strike, heard at the struck place (full scale 1 m/s).

    `body` is a modal object, or a pair of an object and a size. `impulse` is in N s. Without a `point` (m) or a `vertex`
    the middle of the object's upper side is struck, where some modes may stand still. `contact_time` is in s. Without
    `seconds` the sound lasts until it is silent, at most 30 s.
    """
    if point is None and vertex is None:
        struck, size = body if isinstance(body, tuple) else (body, 1.0)
        low, high = struck.vertices.min(axis=0) * size, struck.vertices.max(axis=0) * size
        point = (*((low + high) / 2)[:2], high[2])
    return render([body], [{"body": 0, "impulse": impulse, "point": point, "vertex": vertex,
                            "contact_time": contact_time}], seconds=seconds, sample_rate=sample_rate)


def render(bodies: _Sequence[_Body], impacts: _Iterable[_Mapping[str, _Any]], *, seconds: _Optional[float] = None,
           sample_rate: float = 48000) -> _NDArray[_numpy.float32]:
    """Returns the sound [frames, 2] of impacts on bodies, as `idiophone render --impulses` does.

    `bodies` are as of World. Each impact is a dictionary of the arguments of World.strike. All are heard at the struck
    places (full scale 1 m/s). Without `seconds` the sound lasts until it is silent, at most 30 s after the last impact.
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
