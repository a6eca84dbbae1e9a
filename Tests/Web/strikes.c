/* Strikes bodies in turn, as engine.mjs does in the WebAssembly module, and renders them in blocks
 * of 128 frames. Writes both ears of each frame as floats. Prints the processor seconds.
 *
 *     strikes OUTPUT SECONDS STRIKES_PER_SECOND OBJECT.modal...
 */
#include "idiophone.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { block = 128, rate = 48000, most_bodies = 64 };

static int fail(const char* what) {
    fprintf(stderr, "%s: %s\n", what, idiophone_error());
    return 1;
}

/* Returns strike number k on a body that stands at x. */
static idiophone_impact
strike(size_t k, size_t body, double x, const float* low, const float* high) {
    idiophone_impact hit = IDIOPHONE_IMPACT_DEFAULTS;
    int axis;
    hit.body = body;
    hit.contact_time = 0.0005;
    for (axis = 0; axis < 3; ++axis) {
        const double share = axis == 2 ? 1 : (double)((k * (axis == 0 ? 7 : 5)) % 11) / 10;
        const double place = low[axis] + share * (high[axis] - low[axis]);
        hit.point[axis] = (float)(place + (axis == 0 ? x : 0));
    }
    hit.impulse[2] = (float)(-0.001 * (double)(1 + k % 5));
    return hit;
}

int main(int count, char** arguments) {
    idiophone_body bodies[most_bodies];
    float low[most_bodies][3], high[most_bodies][3];
    float samples[2 * block];
    const size_t body_count = (size_t)(count - 4);
    idiophone_world* world;
    size_t k, done = 0;
    double frames, strikes_per_second;
    clock_t spent = 0;
    FILE* file;
    if (count < 5 || body_count > most_bodies) {
        fprintf(stderr, "strikes OUTPUT SECONDS STRIKES_PER_SECOND OBJECT.modal...\n");
        return 2;
    }
    frames = atof(arguments[2]) * rate;
    strikes_per_second = atof(arguments[3]);
    for (k = 0; k < body_count; ++k) {
        const idiophone_body fresh = IDIOPHONE_BODY_DEFAULTS;
        idiophone_object* object = idiophone_object_load(arguments[4 + k]);
        if (object == NULL)
            return fail(arguments[4 + k]);
        idiophone_object_box(object, low[k], high[k]);
        bodies[k] = fresh;
        bodies[k].object = object;
    }
    world = idiophone_world_create(bodies, body_count, NULL);
    file = fopen(arguments[1], "wb");
    if (world == NULL || file == NULL)
        return fail("world");
    for (k = 0; k < body_count; ++k) {
        const float position[3] = {(float)(0.05 * (double)k), 0, 0};
        if (idiophone_world_place(world, k, position, NULL) != IDIOPHONE_DONE)
            return fail("place");
    }
    for (k = 0; (double)done < frames; done += block) {
        const clock_t begin = clock();
        for (; (double)k < (double)done / rate * strikes_per_second + 1; ++k) {
            const size_t body = k % body_count;
            const idiophone_impact hit =
                strike(k, body, (float)(0.05 * (double)body), low[body], high[body]);
            if (idiophone_world_strike(world, &hit) != IDIOPHONE_DONE)
                return fail("strike");
        }
        idiophone_world_render(world, samples, samples + 1, block, 2);
        spent += clock() - begin;
        fwrite(samples, sizeof samples, 1, file);
    }
    printf("%.6f\n", (double)spent / CLOCKS_PER_SEC);
    return fclose(file);
}
