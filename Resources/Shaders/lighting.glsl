// The studio: a lamp above and behind the instrument, an even sky, and what surfaces mirror. The
// picture's shaders all begin with this file. Light is linear.
uniform float dark; // 1 in the dark look, 0 in the light one
uniform vec3 backdrop; // the window's panel, linear

const vec3 lamp = vec3(-0.449, 0.323, 0.833); // as SceneLight::lamp
const float pi = 3.14159265;

vec3 lampColour() { return mix(vec3(1.60, 1.52, 1.40), vec3(2.05, 1.86, 1.58), dark); }
vec3 skyColour() { return mix(vec3(0.78, 0.80, 0.84), vec3(0.40, 0.45, 0.54), dark); }
vec3 bounceColour() { return mix(vec3(0.42, 0.39, 0.35), vec3(0.10, 0.085, 0.075), dark); }

float band(float value, float from, float to, float soft)
{
    return smoothstep(from - soft, from + soft, value) * (1.0 - smoothstep(to - soft, to + soft, value));
}

// The light from a direction, blurred by a rough surface: a wide lamp overhead, a strip at each
// side, walls and floor.
vec3 studio(vec3 direction, float rough)
{
    float soft = 0.04 + 0.9 * rough;
    vec3 wall = mix(vec3(0.44, 0.45, 0.47), vec3(0.085, 0.095, 0.115), dark);
    vec3 high = mix(vec3(0.60, 0.62, 0.66), vec3(0.20, 0.23, 0.28), dark);
    vec3 ground = mix(vec3(0.30, 0.29, 0.275), vec3(0.035, 0.033, 0.033), dark);
    vec3 light = mix(wall, high, smoothstep(0.0, 1.0, direction.z));
    light = mix(ground, light, smoothstep(-0.08 - soft, 0.08 + soft, direction.z));
    float fade = 1.0 / (1.0 + 2.5 * rough);
    if (direction.z > 0.02) {
        vec2 at = direction.xy / direction.z - lamp.xy / lamp.z;
        float box = band(at.x, -1.6, 1.3, soft) * band(at.y, -0.30, 0.75, soft);
        box *= 0.35 + 0.65 * smoothstep(-0.35, 0.7, at.y);
        light += fade * box * lampColour();
    }
    vec2 around = normalize(direction.xy + vec2(1e-4));
    float left = band(dot(around, vec2(-0.94, -0.34)), 0.90, 2.0, 0.05 + 0.3 * rough);
    float right = band(dot(around, vec2(0.88, -0.47)), 0.965, 2.0, 0.03 + 0.3 * rough);
    float standing = band(direction.z, -0.1, 0.78, 0.05 + 0.3 * rough)
                     + 0.75 * band(direction.z, -0.96, -0.16, 0.06 + 0.2 * rough); // in the floor
    light += fade * standing * (left * vec3(1.15, 1.15, 1.2) + right * vec3(0.75, 0.72, 0.66));
    return light;
}

float hash(vec3 cell)
{
    cell = fract(cell * vec3(0.1031, 0.1030, 0.0973));
    cell += dot(cell, cell.yzx + 33.33);
    return fract((cell.x + cell.y) * cell.z);
}

// Value noise, 0 to 1, one cell a unit.
float noise(vec3 at)
{
    vec3 cell = floor(at), part = at - cell;
    part = part * part * (3.0 - 2.0 * part);
    vec2 step = vec2(0.0, 1.0);
    vec4 near = vec4(hash(cell), hash(cell + step.yxx), hash(cell + step.xyx), hash(cell + step.yyx));
    vec4 far = vec4(hash(cell + step.xxy), hash(cell + step.yxy), hash(cell + step.xyy),
                    hash(cell + step.yyy));
    vec4 mixed = mix(near, far, part.z);
    vec2 row = mix(mixed.xz, mixed.yw, part.x);
    return mix(row.x, row.y, part.y);
}

// Linear light to the screen: a filmic curve (Narkowicz 2015), then a gamma of 2, which costs a
// square root where sRGB costs a power.
vec3 developed(vec3 light)
{
    light *= mix(0.66, 0.70, dark);
    return sqrt(clamp(light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14), 0.0, 1.0));
}
