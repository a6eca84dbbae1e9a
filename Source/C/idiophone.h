/* Idiophone: the sound of bodies that are struck, scraped and rolled, for games and other programs.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * A modal object (a .modal file) is what the shape and the material of a body make of its sound. A
 * world holds bodies made of such objects. A physics engine says where they are and what hits them,
 * and the world renders what a listener hears. docs/c-interface.md has a program.
 *
 * Units are metres, seconds, newtons, kilograms. Coordinates are the program's own, right-handed.
 *
 * Threads: one thread, the audio thread, may call idiophone_world_render and
 * idiophone_world_silent. One other thread at a time may call all other functions of the same
 * world. Neither waits for the other. idiophone_world_render neither allocates nor locks nor calls
 * the system. Objects may be used by any number of threads. Nothing throws.
 *
 * All structures begin with their size, so that programs built with an older header keep working.
 * Begin with the structure's defaults, then set fields:
 *
 *     idiophone_impact hit = IDIOPHONE_IMPACT_DEFAULTS;
 *     hit.body = 3;
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#if defined(IDIOPHONE_BUILDS_LIBRARY)
#define IDIOPHONE_API __declspec(dllexport)
#else
#define IDIOPHONE_API __declspec(dllimport)
#endif
#else
#define IDIOPHONE_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this interface. It grows when a function or a field is added. A library of another
 * major version (the file's name has it) is not compatible. */
#define IDIOPHONE_INTERFACE_VERSION 1
IDIOPHONE_API uint32_t idiophone_interface_version(void);

/* The result of a call. If it is not IDIOPHONE_DONE, nothing changed. */
typedef enum idiophone_result {
    IDIOPHONE_DONE = 0,
    IDIOPHONE_INVALID = 1, /* an argument is null or out of range, or does not exist */
    IDIOPHONE_BUSY = 2     /* too many calls wait for idiophone_world_render, or no touch is free */
} idiophone_result;

/* Returns one sentence that says why the last function of this thread that returns an object or a
 * world returned null. It is valid until the next such call. */
IDIOPHONE_API const char* idiophone_error(void);

/* ---- Objects ---- */

typedef struct idiophone_object idiophone_object;

/* Loads a .modal file, or the first modal model (KHR_audio_rigid_bodies) of a .gltf or .glb file.
 * The path is UTF-8. Returns null on failure. */
IDIOPHONE_API idiophone_object* idiophone_object_load(const char* path);
/* Reads the bytes of a .modal file, or of a .glb file with all its buffers. `name` stands for the
 * file in errors. */
IDIOPHONE_API idiophone_object*
idiophone_object_read(const void* bytes, size_t byte_count, const char* name);
/* Worlds keep the objects that they use. Ignores null. */
IDIOPHONE_API void idiophone_object_free(idiophone_object* object);

IDIOPHONE_API const char* idiophone_object_name(const idiophone_object* object);
IDIOPHONE_API double idiophone_object_mass(const idiophone_object* object);
/* Writes the corners of the box around the object's mesh, in the object's coordinates. */
IDIOPHONE_API void
idiophone_object_box(const idiophone_object* object, float low[3], float high[3]);
IDIOPHONE_API size_t idiophone_object_mode_count(const idiophone_object* object);
/* Writes the frequencies in Hz and the decay rates in 1/s (the amplitude falls as e^(-rate t)) of
 * the first `capacity` modes. Either may be null. Returns how many it wrote. */
IDIOPHONE_API size_t idiophone_object_modes(const idiophone_object* object,
                                            double* frequencies,
                                            double* decay_rates,
                                            size_t capacity);

/* ---- Worlds ---- */

typedef struct idiophone_world idiophone_world;

/* A body of a world. */
typedef struct idiophone_body {
    uint32_t struct_size;
    const idiophone_object* object;
    double size; /* factor of the object's size, 0.001 to 1000 */
} idiophone_body;
#define IDIOPHONE_BODY_DEFAULTS                                                                    \
    { sizeof(idiophone_body), NULL, 1 }

/* How a surface sounds when something slides or rolls on it (docs/surfaces.md). */
typedef struct idiophone_surface {
    uint32_t struct_size;
    double spectrum_exponent; /* -4 to 1 */
    double frequency;         /* of its resonance at the reference speed, 10 to 20000 Hz */
    double damping;           /* of that resonance, 1 to 100000 1/s */
    double reference_speed;   /* 0.001 to 100 m/s: faster contacts get louder but not higher */
    double slowest_speed;     /* slower contacts are silent, 0 to the reference speed */
    double roughness;         /* in N at the reference speed under 1 N, 0 to 100 */
} idiophone_surface;
#define IDIOPHONE_SURFACE_DEFAULTS                                                                 \
    { sizeof(idiophone_surface), -1.4, 500, 1000, 1, 0.1, 0.5 }

typedef struct idiophone_world_settings {
    uint32_t struct_size;
    double sample_rate; /* 8000 to 384000 Hz */
    /* How touches sound. Null: one surface with the defaults. */
    const idiophone_surface* surfaces;
    size_t surface_count;
    /* Calls that may wait for idiophone_world_render, 16 to 1048576. */
    size_t event_capacity;
    /* Not 0: no listener. Everything is heard as at the struck place, wherever the bodies are. */
    int without_listener;
} idiophone_world_settings;
#define IDIOPHONE_WORLD_SETTINGS_DEFAULTS                                                          \
    { sizeof(idiophone_world_settings), 48000, NULL, 0, 4096, 0 }

/* Makes a world of bodies, which are numbered from 0 and stay. A game that spawns and destroys
 * bodies takes numbers that are not in use. All stand at the origin; the listener stands 1.5 m in
 * front of it (y = -1.5) and 1.5 m above it (z = 1.5). `settings` may be null. Returns null on
 * failure. */
IDIOPHONE_API idiophone_world* idiophone_world_create(const idiophone_body* bodies,
                                                      size_t body_count,
                                                      const idiophone_world_settings* settings);
/* Call it while no other function of the world runs. Ignores null. */
IDIOPHONE_API void idiophone_world_free(idiophone_world* world);

/* Returns the world's clock in seconds: how much sound has been rendered. Any thread. */
IDIOPHONE_API double idiophone_world_seconds(const idiophone_world* world);

/* Says where a body is: the origin of its object's coordinates, and a rotation as a unit quaternion
 * (x, y, z, w), or null for none. */
IDIOPHONE_API idiophone_result idiophone_world_place(idiophone_world* world,
                                                     size_t body,
                                                     const float position[3],
                                                     const float rotation[4]);
/* Says where the listener is, a direction ahead, and one up, of any length. */
IDIOPHONE_API idiophone_result idiophone_world_listen(idiophone_world* world,
                                                      const float position[3],
                                                      const float ahead[3],
                                                      const float up[3]);

/* A hit. */
typedef struct idiophone_impact {
    uint32_t struct_size;
    size_t body;
    double time;      /* by the world's clock; a time that has passed means at once */
    float point[3];   /* in the world */
    float impulse[3]; /* in N s, on the body; an impact into a surface points against its normal */
    double contact_time; /* 0 to 1 s; 0: shorter than anything that is heard */
} idiophone_impact;
#define IDIOPHONE_IMPACT_DEFAULTS                                                                  \
    { sizeof(idiophone_impact), 0, 0, {0, 0, 0}, {0, 0, 0}, 0 }
IDIOPHONE_API idiophone_result idiophone_world_strike(idiophone_world* world,
                                                      const idiophone_impact* impact);

#define IDIOPHONE_NO_BODY ((size_t)-1)
/* A body that slides or rolls on another. */
typedef struct idiophone_contact {
    uint32_t struct_size;
    size_t body;
    size_t other_body;       /* sounds too; IDIOPHONE_NO_BODY: only `body` sounds */
    float point[3];          /* in the world */
    float slide_velocity[3]; /* of the other surface past the body's, in m/s */
    double roll_speed;       /* in m/s */
    double force;            /* presses the bodies together, in N */
    size_t surface;          /* number of the world's surface that is heard */
} idiophone_contact;
#define IDIOPHONE_CONTACT_DEFAULTS                                                                 \
    { sizeof(idiophone_contact), 0, IDIOPHONE_NO_BODY, {0, 0, 0}, {0, 0, 0}, 0, 0, 0 }

/* Takes one of 24 touches. It sounds from the first idiophone_world_touch, which is called once a
 * frame, until idiophone_world_end_touch. */
IDIOPHONE_API idiophone_result idiophone_world_begin_touch(idiophone_world* world, size_t* touch);
IDIOPHONE_API idiophone_result idiophone_world_touch(idiophone_world* world,
                                                     size_t touch,
                                                     const idiophone_contact* contact);
IDIOPHONE_API idiophone_result idiophone_world_end_touch(idiophone_world* world, size_t touch);

/* The material of a body. */
typedef struct idiophone_material {
    uint32_t struct_size;
    double youngs_modulus;       /* in Pa */
    double density;              /* in kg/m^3 */
    double damping_fluid;        /* gamma, in 1/s, of gamma + chi omega + eta omega^2 */
    double damping_viscoelastic; /* eta, in s */
    double damping_loss_factor;  /* chi */
} idiophone_material;
#define IDIOPHONE_MATERIAL_DEFAULTS                                                                \
    { sizeof(idiophone_material), 0, 0, 0, 0, 0 }
/* Fills in a material of the library, such as "Glass". Its name may be in upper or lower case. */
IDIOPHONE_API idiophone_result idiophone_material_named(const char* name,
                                                        idiophone_material* material);
/* Replaces the material of a body while it plays. Null restores its object's. */
IDIOPHONE_API idiophone_result idiophone_world_set_material(idiophone_world* world,
                                                            size_t body,
                                                            const idiophone_material* material);
/* Damps a body further: its sound falls as e^(-rate t). 0: no more. A body that a hand grasps, or
 * that leaves the game. */
IDIOPHONE_API idiophone_result idiophone_world_set_damping(idiophone_world* world,
                                                           size_t body,
                                                           double rate);

/* The accelerations of Raghuvanshi and Lin, which bound the cost of any number of bodies. */
typedef struct idiophone_quality {
    uint32_t struct_size;
    double mode_budget; /* modes mixed by all bodies together */
    double truncation;  /* tau: modes below it end, in steps of 16 bits; 0: never */
    double slope;       /* S: how far loud bodies come before soft ones */
    double compression; /* how far close modes are merged, in what the ear can tell apart */
} idiophone_quality;
#define IDIOPHONE_QUALITY_DEFAULTS                                                                 \
    { sizeof(idiophone_quality), 4096, 0.01, 1, 1 }
IDIOPHONE_API idiophone_result idiophone_world_set_quality(idiophone_world* world,
                                                           const idiophone_quality* quality);
/* Sets the gain of everything, at first 1: full scale is then 1 Pa at the listener's ears. */
IDIOPHONE_API idiophone_result idiophone_world_set_gain(idiophone_world* world, double gain);

/* Writes the next samples of both ears: frame k goes to left[k * stride] and right[k * stride]. For
 * interleaved samples pass `samples`, `samples + 1` and 2. The same calls at the same times give
 * the same bits, whatever the sizes of the blocks. */
IDIOPHONE_API void idiophone_world_render(
    idiophone_world* world, float* left, float* right, size_t frame_count, size_t stride);
/* Returns whether nothing sounds or waits. */
IDIOPHONE_API int idiophone_world_silent(const idiophone_world* world);

#ifdef __cplusplus
}
#endif
