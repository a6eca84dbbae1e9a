/* One hit on a modal object, from C.
 *
 *     hit OBJECT.modal SOUND.f32        (32-bit float, left and right in turn, 48 kHz)
 */
#include <idiophone.h>
#include <stdio.h>

int main(int count, char** arguments) {
    static float samples[2 * 48000];
    idiophone_body body = IDIOPHONE_BODY_DEFAULTS;
    idiophone_impact hit = IDIOPHONE_IMPACT_DEFAULTS;
    idiophone_object* object;
    idiophone_world* world;
    FILE* sound;
    if (count != 3)
        return fprintf(stderr, "hit OBJECT.modal SOUND.f32\n"), 1;
    object = idiophone_object_load(arguments[1]);
    body.object = object;
    world = object == NULL ? NULL : idiophone_world_create(&body, 1, NULL);
    if (world == NULL)
        return fprintf(stderr, "%s\n", idiophone_error()), 1;

    hit.impulse[2] = -0.01f; /* downwards, at the origin, at once */
    hit.contact_time = 0.0005;
    idiophone_world_strike(world, &hit);
    idiophone_world_render(world, samples, samples + 1, 48000, 2);

    sound = fopen(arguments[2], "wb");
    if (sound == NULL || fwrite(samples, sizeof samples, 1, sound) != 1)
        return fprintf(stderr, "%s cannot be written\n", arguments[2]), 1;
    fclose(sound);
    idiophone_world_free(world);
    idiophone_object_free(object);
    return 0;
}
