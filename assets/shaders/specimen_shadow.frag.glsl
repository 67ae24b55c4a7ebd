in vec2 lens;
uniform vec3 look;
out vec4 color;

void main()
{
    float k = max(1.0 - dot(lens, lens), 0.0);
    color = vec4(0.0, 0.02, 0.04, 1.0) * (k * k * look.x);
}
