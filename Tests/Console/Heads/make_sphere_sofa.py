#!/usr/bin/env python3
"""Writes sphere.sofa: the spherical head of HeadModel at 48 kHz, every 30 degrees, as a test file with
known responses. Also writes endless.sofa: the same file with one byte changed, which libmysofa 1.3
reads without end. Needs netCDF4 and numpy.

Each ear's response is the head's shadow by the bilinear transform. A separate delay is rounded to the
nearest sample and 60 samples late, as in files of minimum phase.
"""
import pathlib

import netCDF4
import numpy as np

RATE, LATE = 48000, 60
RADIUS, SPEED, EAR = 0.0875, 343.0, np.radians(100)


def response(direction, ear, length):
    """Returns (delay in samples, response)."""
    axis = np.array([np.cos(EAR), np.sin(EAR) if ear == 0 else -np.sin(EAR), 0])
    incidence = np.arccos(np.clip(direction @ axis, -1, 1))
    arrival = -np.cos(incidence) if incidence < np.pi / 2 else incidence - np.pi / 2
    high = 1.05 + 0.95 * np.cos(incidence * 180 / 150)
    warped = RATE / (SPEED / RADIUS)
    b = np.array([1 + high * warped, 1 - high * warped]) / (1 + warped)
    a = (1 - warped) / (1 + warped)
    out = np.zeros(length)
    out[0], out[1] = b[0], b[1] - a * b[0]
    for n in range(2, length):
        out[n] = -a * out[n - 1]
    return LATE + round(RADIUS / SPEED * (1 + arrival) * RATE), out


def write(file, step, length):
    places, delays, responses = [], [], []
    for elevation in range(-90, 91, step):
        for azimuth in range(0, 360, step):
            up, left = np.radians(elevation), np.radians(azimuth)
            direction = np.array([np.cos(up) * np.cos(left), np.cos(up) * np.sin(left), np.sin(up)])
            places.append([azimuth, elevation, 1.0])
            ears = [response(direction, ear, length) for ear in (0, 1)]
            delays.append([ear[0] for ear in ears])
            responses.append([ear[1] for ear in ears])
    sizes = {"C": 3, "I": 1, "R": 2, "E": 1, "N": length, "M": len(places)}
    with netCDF4.Dataset(file, "w", format="NETCDF4") as sofa:
        sofa.setncatts({
            "Conventions": "SOFA", "Version": "1.0", "SOFAConventions": "SimpleFreeFieldHRIR",
            "SOFAConventionsVersion": "1.0", "DataType": "FIR", "RoomType": "free field",
            "Title": "A spherical head", "License": "AGPL-3.0-or-later",
            "AuthorContact": "Idiophone", "Organization": "Idiophone", "DatabaseName": "Idiophone",
            "ListenerShortName": "sphere"})
        for name, size in sizes.items():
            sofa.createDimension(name, size)

        def variable(name, dimensions, data, **attributes):
            made = sofa.createVariable(name, "f8", tuple(dimensions), zlib=True, complevel=9)
            made[:] = np.asarray(data)
            made.setncatts(attributes)

        cartesian = {"Type": "cartesian", "Units": "metre"}
        variable("ListenerPosition", "IC", [[0, 0, 0]], **cartesian)
        variable("ListenerUp", "IC", [[0, 0, 1]])
        variable("ListenerView", "IC", [[1, 0, 0]], **cartesian)
        variable("ReceiverPosition", "RCI", [[[0], [RADIUS], [0]], [[0], [-RADIUS], [0]]], **cartesian)
        variable("EmitterPosition", "ECI", [[[0], [0], [0]]], **cartesian)
        variable("SourcePosition", "MC", places, Type="spherical", Units="degree, degree, metre")
        variable("Data.SamplingRate", "I", [RATE], Units="hertz")
        variable("Data.Delay", "MR", delays)
        variable("Data.IR", "MRN", responses)


write(pathlib.Path(__file__).with_name("sphere.sofa"), 30, 100)
