"""A game's loop: pymunk throws boxes about, SDL draws and plays them, idiophone makes the sound.

    pip install pymunk pysdl2 pysdl2-dll
    python boxes.py OBJECT.modal [SECONDS]

A click or a key throws them again. The boxes move in a plane, x to the right and z upwards. docs/library/boxes.cpp is
the same game in C++ with Bullet, in three dimensions.
"""
import ctypes
import math
import random
import sys

import idiophone
import numpy
import pymunk
import sdl2

COUNT = 12
STEP_SECONDS = 1 / 240
WALL_METRES = 0.6
PIXELS_PER_METRE, GROUND_PIXELS, MIDDLE_PIXELS = 450, 500, 400


def make_space(half_width, half_height, mass):
    """Returns a space with a ground and two walls, and the boxes in it."""
    space = pymunk.Space()
    space.gravity = 0, -9.81
    space.collision_slop = 0.0005  # metres
    for a, b in (((-10, -1), (10, -1)), ((-WALL_METRES - 1, -1), (-WALL_METRES - 1, 10)),
                 ((WALL_METRES + 1, -1), (WALL_METRES + 1, 10))):
        space.add(pymunk.Segment(space.static_body, a, b, radius=1))
    boxes = []
    for k in range(COUNT):
        box = pymunk.Body(mass, pymunk.moment_for_box(mass, (2 * half_width, 2 * half_height)))
        box.position, box.angle = (0.2 * (k % 4) - 0.3, 0.4 + 0.2 * (k // 4)), k
        space.add(box, pymunk.Poly.create_box(box, (2 * half_width, 2 * half_height)))
        boxes.append(box)
    for shape in space.shapes:
        shape.elasticity, shape.friction = 0.6, 0.5
    return space, boxes


def report_impacts(space, boxes, world, half_depth):
    """Strikes the bodies of the world where the boxes of the space hit something."""
    numbers = {box: number for number, box in enumerate(boxes)}
    resting_impulse = 5 * boxes[0].mass * 9.81 * STEP_SECONDS  # what bears a few boxes for a step

    def report(arbiter, space, data):
        impulse = arbiter.total_impulse
        if not arbiter.is_first_contact and impulse.length < resting_impulse:
            return
        for shape, sign in zip(arbiter.shapes, (1, -1)):
            if shape.body in numbers:
                contact = arbiter.contact_point_set.points[0].point_a
                depth = random.uniform(-half_depth, half_depth)  # the plane does not know it
                world.strike(numbers[shape.body], impulse=(sign * impulse.x, 0, sign * impulse.y),
                             point=(contact.x, depth, contact.y), contact_time=0.0004)
    space.on_collision(post_solve=report)


def play(world):
    """Opens the sound device. Returns it and the callback, which must live as long as the device."""
    @sdl2.SDL_AudioCallback
    def callback(_, stream, size):  # the audio thread
        samples = numpy.tanh(world.render(size // 8))  # limits several impacts at once
        ctypes.memmove(stream, samples.ctypes.data, size)
    wanted = sdl2.SDL_AudioSpec(48000, sdl2.AUDIO_F32SYS, 2, 512, callback)
    device = sdl2.SDL_OpenAudioDevice(None, 0, wanted, None, 0)
    sdl2.SDL_PauseAudioDevice(device, 0)
    return device, callback


def draw(picture, boxes, half_width, half_height):
    sdl2.SDL_SetRenderDrawColor(picture, 20, 20, 24, 255)
    sdl2.SDL_RenderClear(picture)
    sdl2.SDL_SetRenderDrawColor(picture, 230, 180, 90, 255)
    for box in boxes:
        corners = [box.local_to_world((x * half_width, z * half_height))
                   for x, z in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
        places = (sdl2.SDL_FPoint * len(corners))(
            *((MIDDLE_PIXELS + PIXELS_PER_METRE * corner.x, GROUND_PIXELS - PIXELS_PER_METRE * corner.y)
              for corner in corners))
        sdl2.SDL_RenderDrawLinesF(picture, places, len(corners))
    sdl2.SDL_RenderPresent(picture)


def main(path, last_second=math.inf):
    die = idiophone.load(path)
    low, high = die.vertices.min(axis=0).astype(float), die.vertices.max(axis=0).astype(float)
    half_width, half_depth, half_height = (high - low) / 2
    middle_x, middle_y, middle_z = (high + low) / 2
    world = idiophone.World([die] * COUNT)
    world.listen(position=(0, -2, 0.3), towards=(0, 0, 0.3))
    world.set_gain(0.05)
    space, boxes = make_space(half_width, half_height, die.mass)
    report_impacts(space, boxes, world, half_depth)

    if sdl2.SDL_Init(sdl2.SDL_INIT_VIDEO | sdl2.SDL_INIT_AUDIO) != 0:
        sys.exit(sdl2.SDL_GetError().decode())
    window, picture = ctypes.POINTER(sdl2.SDL_Window)(), ctypes.POINTER(sdl2.SDL_Renderer)()
    sdl2.SDL_CreateWindowAndRenderer(800, 600, 0, window, picture)
    device, callback = play(world)
    event, runs, seconds = sdl2.SDL_Event(), True, 0.0
    while runs and seconds < last_second:
        while sdl2.SDL_PollEvent(event):
            runs = runs and event.type != sdl2.SDL_QUIT
            if event.type in (sdl2.SDL_MOUSEBUTTONDOWN, sdl2.SDL_KEYDOWN):
                for box in boxes:
                    box.velocity = random.randint(-2, 2), 4
        while seconds < sdl2.SDL_GetTicks() / 1000:
            space.step(STEP_SECONDS)
            seconds += STEP_SECONDS
        for number, box in enumerate(boxes):
            x, z = box.local_to_world((-middle_x, -middle_z))
            # A turn about the y axis takes x to -z, an angle of the space takes x to z.
            world.place(number, (x, -middle_y, z), (0, -math.sin(box.angle / 2), 0, math.cos(box.angle / 2)))
        draw(picture, boxes, half_width, half_height)
        sdl2.SDL_Delay(4)
    sdl2.SDL_CloseAudioDevice(device)  # waits for the last callback
    sdl2.SDL_Quit()


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], *map(float, sys.argv[2:]))
