#!/usr/bin/env python3
"""Writes Resources/Scenes/07-bell-under-a-hand.json: a hand taps a bell and scrapes it.

    python3 docs/make_hand_scene.py

In place of a hand that was recorded one that moves as hands do: from place to place with the least
jerk (Flash & Hogan 1985), and with a tremor of about 10 Hz.
"""
import json
import math
import pathlib

ROWS_PER_SECOND = 50
FILE = pathlib.Path(__file__).parents[1] / "Resources/Scenes/07-bell-under-a-hand.json"

# The outer wall of the factory's handbell: height over the mouth and radius, in metres.
WALL = ((0.0, 0.0685), (0.0105, 0.0651), (0.0218, 0.0589), (0.033, 0.0537), (0.0442, 0.0496),
        (0.0555, 0.0468), (0.0667, 0.0453))


def on_wall(degrees, height):
    for (low, wide), (high, narrow) in zip(WALL, WALL[1:]):
        if low <= height <= high:
            radius = wide + (narrow - wide) * (height - low) / (high - low)
            angle = math.radians(degrees)
            return radius * math.cos(angle), radius * math.sin(angle), height
    raise ValueError(height)


def least_jerk(share):
    return share ** 3 * (10 - 15 * share + 6 * share ** 2)


def stroke(start, seconds, begin, end, newtons):
    """From one place (degrees, height) to another; the hand comes down and lifts within 60 ms."""
    rows = []
    count = round(seconds * ROWS_PER_SECOND)
    for k in range(count + 1):
        time = k / ROWS_PER_SECOND
        way = least_jerk(k / count)
        tremor = math.sin(2 * math.pi * 9.7 * (start + time)) + \
            0.6 * math.sin(2 * math.pi * 11.3 * (start + time) + 1)
        degrees = begin[0] + way * (end[0] - begin[0]) + 0.25 * tremor
        height = min(max(begin[1] + way * (end[1] - begin[1]) + 0.0002 * tremor, 0), 0.066)
        pressed = min(time / 0.06, (seconds - time) / 0.06, 1) * newtons * (1 + 0.12 * tremor)
        x, y, z = on_wall(degrees, height)
        rows.append([round(start + time, 3), round(x, 5), round(y, 5), round(z, 5),
                     round(max(pressed, 0), 3)])
    return rows


def tap(seconds, degrees, height, speed):
    return [seconds, *(round(x, 5) for x in on_wall(degrees, height)), speed]


def main():
    # The part before the hand is written by people, and stays.
    head = FILE.read_text().split(',\n    "hand"')[0].removesuffix("\n}\n")
    hand = {
        "taps": [tap(0.3, -90, 0.006, 0.8), tap(1.0, -75, 0.02, 0.5), tap(1.5, -100, 0.045, 0.6),
                 tap(1.75, -100, 0.045, 0.25), tap(8.2, -90, 0.006, 0.4)],
        "path": [*stroke(2.6, 1.6, (-170, 0.012), (-20, 0.012), 1.5),
                 *stroke(4.5, 0.5, (-90, 0.008), (-90, 0.06), 2.5),
                 *stroke(5.2, 0.35, (-85, 0.06), (-85, 0.008), 2.5),
                 *stroke(5.8, 0.3, (-80, 0.008), (-80, 0.06), 3),
                 *stroke(6.5, 1.2, (-20, 0.02), (-160, 0.03), 1)]}
    rows = {name: ",\n".join("            " + json.dumps(row) for row in hand[name])
            for name in hand}
    FILE.write_text(head + f''',
    "hand": {{
        "kind": "bell",
        "tool": "rod",
        "taps": [
{rows["taps"]}
        ],
        "path": [
{rows["path"]}
        ]
    }}
}}
''')


if __name__ == "__main__":
    main()
