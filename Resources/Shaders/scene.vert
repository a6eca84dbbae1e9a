in vec3 place;
in vec3 normal;
in vec3 offset;
in float sky;
uniform mat4 viewProjection;
uniform mat4 pose;
uniform float offsetScale;
out vec3 ownPlace;
out vec3 ownNormal;
out vec3 seenPlace;
out float outward;
out float seenSky;

void main()
{
    vec4 moved = pose * vec4(place + offsetScale * offset, 1.0);
    ownPlace = place;
    ownNormal = normal;
    seenPlace = moved.xyz;
    outward = dot(offset, normal);
    seenSky = sky;
    gl_Position = viewProjection * moved;
}
