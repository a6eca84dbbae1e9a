// The floor, which fades into the backdrop, with the instrument's shadow.
uniform vec3 eye;
uniform float floorHeight;
uniform vec3 middle; // of the scene
uniform float reach; // its radius
uniform sampler2D floorLight; // red: share of the lamp, green: of the sky
uniform vec4 floorArea; // left, front, width, depth
uniform float usesMap; // 1 if floorLight lacks shadows: of moving bodies, or all of a new scene
uniform sampler2DShadow shadowMap;
uniform mat4 shadowFrom;
uniform float shadowTexel; // metres
in vec3 ray;
out vec4 shown;

// The share of the lamp by the shadow map, softened over five texels.
float mappedShadow(vec3 at)
{
    float sum = 0.0;
    for (int i = 0; i < 9; ++i) {
        vec3 from = at + 2.0 * shadowTexel * vec3(float(i % 3) - 1.0, float(i / 3) - 1.0, 0.0);
        vec3 onMap = (shadowFrom * vec4(from, 1.0)).xyz * 0.5 + 0.5;
        bool beside = any(lessThan(onMap, vec3(0.0))) || any(greaterThan(onMap, vec3(1.0)));
        sum += beside ? 1.0 : texture(shadowMap, onMap);
    }
    return sum / 9.0;
}

void main()
{
    vec3 direction = normalize(ray);
    vec3 wall = backdrop * mix(mix(0.90, 1.0, smoothstep(-0.3, 0.4, direction.z)),
                               mix(0.62, 1.05, smoothstep(-0.5, 0.3, -direction.z)), dark);
    vec3 colour = wall;
    if (direction.z < -1e-4) {
        vec3 at = eye + direction * ((floorHeight - eye.z) / direction.z);
        float away = length(at.xy - middle.xy) / reach;
        vec2 onMap = (at.xy - floorArea.xy) / floorArea.zw;
        vec2 seen = texture(floorLight, onMap).rg;
        vec2 inside = smoothstep(vec2(0.0), vec2(0.06), onMap) * (1.0 - smoothstep(vec2(0.94), vec2(1.0), onMap));
        seen = mix(vec2(1.0), seen, inside.x * inside.y);
        if (usesMap > 0.5)
            seen.x = min(seen.x, mappedShadow(at));
        float pool = exp(-0.35 * away * away);
        vec3 ground = mix(mix(backdrop * 0.86, backdrop * 1.02, pool),
                          mix(backdrop * 0.70, backdrop * 2.6 + vec3(0.006, 0.005, 0.003), pool), dark);
        float sky = mix(0.42, 0.34, dark);
        vec3 lit = ground * mix(sky * seen.y * seen.y + (1.0 - sky) * seen.x, 1.0, 0.04);
        colour = mix(lit, wall, smoothstep(1.6, 5.0, away));
    }
    // Noise below one step of the screen hides bands in the gradients.
    float grain = hash(vec3(gl_FragCoord.xy, 1.0)) - 0.5;
    shown = vec4(sqrt(colour) + grain / 255.0, 1.0);
}
