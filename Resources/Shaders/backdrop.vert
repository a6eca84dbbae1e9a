// Covers the window with one triangle.
uniform vec3 rayMiddle, rayRight, rayUp; // directions through the window's middle and to its edges
out vec3 ray;

void main()
{
    vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    ray = rayMiddle + at.x * rayRight + at.y * rayUp;
    gl_Position = vec4(at, 1.0, 1.0);
}
