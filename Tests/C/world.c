/* Uses all of the C interface as a game would, and as it must not.
 *
 *     world OBJECT.modal
 */
#include "idiophone.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                                           \
    ((condition) ? (void)0                                                                         \
                 : (void)(++failures, fprintf(stderr, "line %d: %s\n", __LINE__, #condition)))

enum { block = 480 };

static float largest(idiophone_world* world, int blocks) {
    static float samples[2 * block];
    float most = 0;
    int k, i;
    for (k = 0; k < blocks; ++k) {
        idiophone_world_render(world, samples, samples + 1, block, 2);
        for (i = 0; i < 2 * block; ++i)
            most = fmaxf(most, fabsf(samples[i]));
    }
    return most;
}

static void test_layout(void) {
    /* A field may be added at the end; none may move. */
    CHECK(offsetof(idiophone_body, object) == 8 && offsetof(idiophone_body, size) == 16);
    CHECK(offsetof(idiophone_surface, roughness) == 48);
    CHECK(offsetof(idiophone_world_settings, surfaces) == 16);
    CHECK(offsetof(idiophone_world_settings, without_listener) == 40);
    CHECK(offsetof(idiophone_impact, point) == 24 && offsetof(idiophone_impact, contact_time) == 48);
    CHECK(offsetof(idiophone_contact, point) == 24 && offsetof(idiophone_contact, surface) == 64);
    CHECK(offsetof(idiophone_material, damping_loss_factor) == 40);
    CHECK(offsetof(idiophone_quality, compression) == 32);
}

static void test_objects(const char* path) {
    double frequencies[3], rates[3];
    float low[3], high[3];
    idiophone_object* object = idiophone_object_load(path);
    CHECK(object != NULL);
    CHECK(idiophone_object_mode_count(object) > 3);
    CHECK(idiophone_object_modes(object, frequencies, rates, 3) == 3);
    CHECK(frequencies[0] > 20 && frequencies[2] >= frequencies[1] && rates[0] > 0);
    CHECK(idiophone_object_modes(object, NULL, NULL, 2) == 2);
    idiophone_object_box(object, low, high);
    CHECK(high[0] - low[0] > 0.001f && high[2] - low[2] < 1);
    CHECK(idiophone_object_mass(object) > 0 && strlen(idiophone_object_name(object)) > 0);
    idiophone_object_free(object);

    CHECK(idiophone_object_load("no such file.modal") == NULL);
    CHECK(strstr(idiophone_error(), "no such file.modal") != NULL);
    CHECK(idiophone_object_load(NULL) == NULL);
    CHECK(idiophone_object_read("rubbish", 7, "a game's file") == NULL);
    CHECK(strstr(idiophone_error(), "a game's file") != NULL);
    CHECK(idiophone_object_read(NULL, 7, NULL) == NULL);
    idiophone_object_free(NULL);
}

static void test_bad_worlds(const idiophone_object* object) {
    idiophone_body body = IDIOPHONE_BODY_DEFAULTS;
    idiophone_world_settings settings = IDIOPHONE_WORLD_SETTINGS_DEFAULTS;
    idiophone_surface surface = IDIOPHONE_SURFACE_DEFAULTS;
    CHECK(idiophone_world_create(NULL, 0, NULL) == NULL && strlen(idiophone_error()) > 0);
    CHECK(idiophone_world_create(&body, 1, NULL) == NULL); /* no object */
    body.object = object;
    body.size = 0;
    CHECK(idiophone_world_create(&body, 1, NULL) == NULL);
    body.size = 1;
    settings.sample_rate = NAN;
    CHECK(idiophone_world_create(&body, 1, &settings) == NULL);
    settings.sample_rate = 44100;
    surface.roughness = -1;
    settings.surfaces = &surface;
    settings.surface_count = 1;
    CHECK(idiophone_world_create(&body, 1, &settings) == NULL);
    idiophone_world_free(NULL);
}

static void test_bad_calls(idiophone_world* world) {
    const float here[3] = {0, 0, 0}, nowhere[3] = {NAN, 0, 0}, bent[4] = {1, 1, 1, 1};
    idiophone_impact hit = IDIOPHONE_IMPACT_DEFAULTS;
    idiophone_contact contact = IDIOPHONE_CONTACT_DEFAULTS;
    idiophone_material material = IDIOPHONE_MATERIAL_DEFAULTS;
    idiophone_quality quality = IDIOPHONE_QUALITY_DEFAULTS;
    size_t touch;
    CHECK(idiophone_world_place(world, 2, here, NULL) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_place(world, 0, nowhere, NULL) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_place(world, 0, here, bent) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_place(world, 0, NULL, NULL) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_listen(world, here, nowhere, here) == IDIOPHONE_INVALID);
    hit.body = 2;
    CHECK(idiophone_world_strike(world, &hit) == IDIOPHONE_INVALID);
    hit.body = 0;
    hit.impulse[1] = INFINITY;
    CHECK(idiophone_world_strike(world, &hit) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_strike(world, NULL) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_begin_touch(world, NULL) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_touch(world, 5, &contact) == IDIOPHONE_INVALID); /* not begun */
    CHECK(idiophone_world_end_touch(world, 5) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_begin_touch(world, &touch) == IDIOPHONE_DONE);
    contact.surface = 1;
    CHECK(idiophone_world_touch(world, touch, &contact) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_end_touch(world, touch) == IDIOPHONE_DONE);
    CHECK(idiophone_material_named("Unobtainium", &material) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_set_material(world, 0, &material) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_set_damping(world, 0, -1) == IDIOPHONE_INVALID);
    quality.truncation = -1;
    CHECK(idiophone_world_set_quality(world, &quality) == IDIOPHONE_INVALID);
    CHECK(idiophone_world_set_gain(world, NAN) == IDIOPHONE_INVALID);
    CHECK(largest(world, 1) == 0 && idiophone_world_silent(world));
}

static void test_play(idiophone_world* world) {
    const float right[3] = {1, 0, 0}, ear[3] = {0, 0, 0}, ahead[3] = {0, 1, 0}, up[3] = {0, 0, 1};
    const float turned[4] = {0, 0, 0.70710678f, 0.70710678f};
    idiophone_impact hit = IDIOPHONE_IMPACT_DEFAULTS;
    idiophone_contact contact = IDIOPHONE_CONTACT_DEFAULTS;
    idiophone_material glass = IDIOPHONE_MATERIAL_DEFAULTS;
    idiophone_quality quality = IDIOPHONE_QUALITY_DEFAULTS;
    size_t touch;
    float loud;
    int k;
    CHECK(idiophone_world_listen(world, ear, ahead, up) == IDIOPHONE_DONE);
    CHECK(idiophone_world_place(world, 0, right, turned) == IDIOPHONE_DONE);
    CHECK(idiophone_material_named("glass", &glass) == IDIOPHONE_DONE && glass.density > 1000);
    CHECK(idiophone_world_set_material(world, 0, &glass) == IDIOPHONE_DONE);
    quality.mode_budget = 200;
    CHECK(idiophone_world_set_quality(world, &quality) == IDIOPHONE_DONE);
    CHECK(idiophone_world_set_gain(world, 2) == IDIOPHONE_DONE);

    hit.time = idiophone_world_seconds(world) + 0.01;
    memcpy(hit.point, right, sizeof hit.point);
    hit.impulse[2] = -0.01f;
    hit.contact_time = 0.0005;
    CHECK(idiophone_world_strike(world, &hit) == IDIOPHONE_DONE);
    CHECK(!idiophone_world_silent(world));
    loud = largest(world, 10);
    CHECK(loud > 1e-4f && loud < 100);

    CHECK(idiophone_world_begin_touch(world, &touch) == IDIOPHONE_DONE);
    memcpy(contact.point, right, sizeof contact.point);
    contact.other_body = 1;
    contact.slide_velocity[0] = 0.5f;
    contact.force = 5;
    for (k = 0; k < 10; ++k) {
        CHECK(idiophone_world_touch(world, touch, &contact) == IDIOPHONE_DONE);
        CHECK(largest(world, 2) > 0);
    }
    CHECK(idiophone_world_end_touch(world, touch) == IDIOPHONE_DONE);
    CHECK(idiophone_world_set_material(world, 0, NULL) == IDIOPHONE_DONE);
    for (k = 0; k < 2; ++k)
        CHECK(idiophone_world_set_damping(world, (size_t)k, 200) == IDIOPHONE_DONE);
    (void)largest(world, 200);
    CHECK(idiophone_world_silent(world));
}

/* A structure of a program that knows only its first fields. */
static void test_older_program(idiophone_world* world) {
    idiophone_quality quality = IDIOPHONE_QUALITY_DEFAULTS;
    quality.struct_size = offsetof(idiophone_quality, slope);
    quality.slope = NAN; /* not read */
    CHECK(idiophone_world_set_quality(world, &quality) == IDIOPHONE_DONE);
}

static void test_too_many_calls(const idiophone_object* object) {
    idiophone_body body = IDIOPHONE_BODY_DEFAULTS;
    idiophone_world_settings settings = IDIOPHONE_WORLD_SETTINGS_DEFAULTS;
    idiophone_impact hit = IDIOPHONE_IMPACT_DEFAULTS;
    idiophone_world* world;
    int taken = 0;
    body.object = object;
    settings.event_capacity = 16;
    settings.without_listener = 1;
    world = idiophone_world_create(&body, 1, &settings);
    CHECK(world != NULL);
    hit.impulse[2] = -0.001f;
    while (taken < 100 && idiophone_world_strike(world, &hit) == IDIOPHONE_DONE)
        ++taken;
    CHECK(taken >= 16 && taken < 100);
    CHECK(idiophone_world_strike(world, &hit) == IDIOPHONE_BUSY);
    CHECK(largest(world, 1) > 0);
    CHECK(idiophone_world_strike(world, &hit) == IDIOPHONE_DONE);
    idiophone_world_free(world);
}

int main(int count, char** arguments) {
    idiophone_body bodies[2] = {IDIOPHONE_BODY_DEFAULTS, IDIOPHONE_BODY_DEFAULTS};
    idiophone_object* object;
    idiophone_world* world;
    if (count != 2) {
        fprintf(stderr, "world OBJECT.modal\n");
        return 2;
    }
    CHECK(idiophone_interface_version() == IDIOPHONE_INTERFACE_VERSION);
    test_layout();
    test_objects(arguments[1]);
    object = idiophone_object_load(arguments[1]);
    test_bad_worlds(object);
    test_too_many_calls(object);
    bodies[0].object = bodies[1].object = object;
    bodies[1].size = 0.5;
    world = idiophone_world_create(bodies, 2, NULL);
    CHECK(world != NULL);
    idiophone_object_free(object); /* the world keeps it */
    test_bad_calls(world);
    test_play(world);
    test_older_program(world);
    idiophone_world_free(world);
    return failures == 0 ? 0 : 1;
}
