// A surface of the instrument: its finish, its light, and what the sound adds.
uniform mat4 pose;
uniform vec3 eye;
uniform vec3 colour; // linear
uniform vec3 boxMiddle; // of the object, in its own coordinates
uniform vec3 boxHalf;
uniform float bevel; // radius of a box's edges in metres; 0: none
uniform vec3 along; // axis of the grain, in own coordinates
uniform float turned; // 1: worked on a lathe about z
uniform float seed;
uniform sampler2DShadow shadowMap;
uniform mat4 shadowFrom;
uniform float shadowTexel; // metres
uniform vec3 glowPlace;
uniform vec3 accent;
uniform vec3 ink;
uniform float glow; // brightness, 0 to 1
uniform float glowRadius; // metres
uniform float nodes;
in vec3 ownPlace;
in vec3 ownNormal;
in vec3 seenPlace;
in float outward;
in float seenSky;
out vec4 shown;

// FINISH is one of these, as enum Finish.
#define WOOD 0
#define METAL 1
#define GLASS 2
#define STONE 3
#define CERAMIC 4
#define PLASTIC 5
#define CLOTH 6

struct Surface {
    vec3 colour;
    vec3 normal; // own coordinates
    float rough;
    float mirrors; // reflectance head-on
};

// 1 where a pattern of this wavelength is coarser than a pixel.
float visible(vec3 at) { vec3 width = fwidth(at); return 1.0 - smoothstep(0.35, 1.1, max(width.x, max(width.y, width.z))); }

// The coordinates along the grain, across it and through the object.
vec3 grained(vec3 at) { return along.x > 0.5 ? at : along.y > 0.5 ? at.yxz : at.zxy; }

// Edges of a box, rounded: near an edge the normal turns towards the other side.
vec3 bevelled(vec3 normal)
{
    vec3 at = ownPlace - boxMiddle;
    float pixel = length(fwidth(ownPlace)); // an edge thinner than a pixel would sparkle
    float width = min(max(bevel, 1.5 * pixel), 0.6 * min(boxHalf.x, min(boxHalf.y, boxHalf.z)));
    vec3 over = max(abs(at) - (boxHalf - width), 0.0) * sign(at);
    over -= dot(over, normal) * normal;
    return normalize(normal * width + over * min(1.0, bevel / pixel));
}

#if FINISH == WOOD
Surface surfaceOf(vec3 normal)
{
    vec3 at = grained(ownPlace - boxMiddle) + vec3(seed * 0.37, seed * 0.011, seed * 0.007);
    float wave = noise(at * vec3(5.0, 30.0, 30.0)) + 0.4 * noise(at * vec3(14.0, 120.0, 120.0));
    vec2 pith = vec2(0.035 + 0.06 * fract(seed * 5.3), -0.06 - 0.05 * fract(seed * 3.7));
    float age = length(at.yz + pith) / 0.0031 + 2.6 * wave;
    float year = fract(age);
    float strength = 0.35 + 0.65 * hash(vec3(floor(age) * 3.7, seed, 0.5));
    float late = strength * smoothstep(0.1, 0.85, year) * (1.0 - smoothstep(0.86, 1.0, year));
    late = mix(0.28, late, 1.0 - smoothstep(0.25, 0.8, fwidth(age)));
    vec3 fine = at * vec3(40.0, 1300.0, 1300.0);
    float fibre = mix(0.5, noise(fine), visible(fine));
    float pore = 1.0 - smoothstep(0.10, 0.26, fibre);
    float figure = 0.6 * noise(at * vec3(3.0, 30.0, 30.0) + 7.0) + 0.4 * noise(at * vec3(5.0, 210.0, 210.0));
    vec3 shade = colour * mix(1.16, 0.52, late) * (0.84 + 0.32 * fibre) * (0.52 + 0.80 * figure);
    shade *= 0.84 + 0.32 * fract(seed * 7.13);
    shade *= 1.0 - 0.55 * pore;
    shade = 0.85 * mix(shade, vec3(dot(shade, vec3(0.5, 0.4, 0.1))), 0.16);
    float end = abs(dot(normal, along)); // end grain drinks the varnish
    return Surface(shade * (1.0 - 0.35 * end), normal, 0.14 + 0.10 * late + 0.3 * end, 0.055);
}
#elif FINISH == METAL
Surface surfaceOf(vec3 normal)
{
    vec3 at = ownPlace - boxMiddle;
    vec3 lines = turned > 0.5 ? vec3(0.0, length(at.xy) * 600.0, at.z * 900.0) + seed
                              : grained(at) * vec3(5.0, 650.0, 650.0) + seed;
    float brushed = (noise(lines) - 0.5) * visible(lines);
    vec3 across = turned > 0.5 ? vec3(0.0, 0.0, 1.0) : cross(along, normal);
    vec3 bent = normalize(normal + across * (0.11 * brushed));
    return Surface(colour * (1.0 + 0.30 * brushed), bent, 0.20, 0.9);
}
#elif FINISH == STONE
Surface surfaceOf(vec3 normal)
{
    vec3 at = ownPlace + seed * 0.13;
    vec3 coarse = at * 420.0, fine = at * 1300.0;
    float cloud = noise(at * 38.0) * 0.6 + noise(at * 95.0) * 0.4;
    float grains = mix(0.5, noise(coarse), visible(coarse));
    float specks = mix(0.5, noise(fine), visible(fine));
    float vein = 1.0 - smoothstep(0.0, 0.035, abs(noise(at * 17.0 + cloud * 0.9) - 0.5));
    float tone = 0.72 + 0.34 * cloud + 0.32 * (grains - 0.5) + 0.22 * (specks - 0.5);
    vec3 shade = colour * tone + vec3(0.07) * vein * (0.4 + 0.6 * cloud);
    return Surface(shade, normalize(normal + 0.10 * (vec3(grains, specks, cloud) - 0.5)),
                   0.42, 0.04);
}
#elif FINISH == CLOTH
Surface surfaceOf(vec3 normal)
{
    float twist = noise(grained(ownPlace) * vec3(500.0, 900.0, 900.0));
    return Surface(colour * (0.7 + 0.5 * twist), normal, 0.9, 0.02);
}
#elif FINISH == CERAMIC
Surface surfaceOf(vec3 normal)
{
    return Surface(colour * (0.97 + 0.06 * noise(ownPlace * 60.0)), normal, 0.05, 0.055);
}
#else
Surface surfaceOf(vec3 normal)
{
    return Surface(colour, normal, FINISH == GLASS ? 0.02 : 0.15, 0.045);
}
#endif

// The share of the lamp's light that arrives. The sampler mixes four comparisons.
float lampSeen(vec3 normal)
{
    vec3 from = seenPlace + normal * shadowTexel * 2.0;
    return texture(shadowMap, (shadowFrom * vec4(from, 1.0)).xyz * 0.5 + 0.5);
}

void main()
{
    vec3 view = normalize(eye - seenPlace);
    mat3 turn = mat3(pose);
    vec3 own = normalize(ownNormal + vec3(0.0, 0.0, 1e-6));
    bool faces = dot(turn * own, view) >= 0.0;
    if (!faces)
        own = -own;
    vec3 plain = own;
    if (bevel > 0.0)
        own = bevelled(own);
    Surface surface = surfaceOf(own);
    vec3 n = normalize(turn * surface.normal);

    float far = clamp(outward, -1.0, 1.0);
    vec3 swing = far > 0.0 ? vec3(0.79, 0.12, 0.05) : vec3(0.05, 0.23, 0.79);
    surface.colour = mix(surface.colour, swing, nodes * 0.85 * sqrt(abs(far)));
    float width = 1.5 * fwidth(far);
    float node = nodes * (1.0 - smoothstep(0.5 * width, width + 1e-6, abs(far)));

    float lit = max(dot(n, lamp), 0.0);
    lit *= lit > 0.0 ? lampSeen(normalize(turn * plain)) : 0.0;
    float open = faces ? seenSky : 0.6 * seenSky;
    vec3 ambient = mix(bounceColour() * (0.45 + 0.55 * open), skyColour() * open, 0.5 + 0.5 * n.z);
    vec3 fill = mix(vec3(0.16), vec3(0.13, 0.14, 0.17), dark) * max(dot(n, vec3(0.53, -0.80, 0.27)), 0.0);
    vec3 diffuse = ambient + fill * (0.4 + 0.6 * open) + lampColour() * lit;

    float grazing = 1.0 - max(dot(n, view), 0.0);
    float sheen = grazing * grazing * grazing * grazing * grazing;
    float fresnel = surface.mirrors + (1.0 - surface.mirrors) * sheen * (1.0 - 0.7 * surface.rough);
    vec3 mirrored = studio(reflect(-view, n), surface.rough) * (0.25 + 0.75 * open);
    vec3 halfway = normalize(lamp + view);
    float sharp = 2.0 / (surface.rough * surface.rough + 0.001);
    float lobe = 1.0 / (1.0 + 0.6 * sharp * (1.0 - max(dot(n, halfway), 0.0)));
    float gloss = lobe * lobe * (sharp + 2.0) / 40.0;
    vec3 reflected = mirrored * fresnel + min(gloss, 4.0) * surface.mirrors * lampColour() * lit;
    float alpha = 1.0;
#if FINISH == METAL
    vec3 tint = mix(surface.colour, vec3(1.0), 0.6 * sheen);
    vec3 seen = tint * (reflected + 0.16 * diffuse);
#elif FINISH == GLASS
    float edge = grazing * grazing;
    vec3 seen = reflected + surface.colour * diffuse * (0.10 + 0.30 * edge);
    alpha = clamp(0.16 + 0.62 * edge + fresnel, 0.0, 1.0);
    alpha = max(alpha, max(node, nodes * 0.8));
#else
    vec3 seen = surface.colour * diffuse * (1.0 - fresnel) + reflected;
#endif

    vec3 off = (seenPlace - glowPlace) / glowRadius;
    float near = 1.0 / (1.0 + 0.6 * dot(off, off));
    seen += accent * (mix(2.4, 0.9, dark) * glow * near * near);
    shown = vec4(mix(developed(seen), ink, node), alpha);
}
