in vec2 lens;
in float strength;
out vec4 color;

void main()
{
    float k = max(1.0 - dot(lens, lens) * 0.55, 0.0);
#ifdef IN_BOWL
    color = vec4(0.0, 0.0, 0.0, 0.75 * k * k * strength);
#else
    color = vec4(k * k * strength);
#endif
}
