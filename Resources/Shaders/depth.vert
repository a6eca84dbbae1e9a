in vec3 place;
uniform mat4 viewProjection;
uniform mat4 pose;

void main()
{
    gl_Position = viewProjection * pose * vec4(place, 1.0);
}
