// The ring on the surface around a gulping mouth. Two wave crests spread outward and fade, and the
// water film clings to the snout. Slopes toward the lamp are bright.
in vec2 from;
in float phase;
out vec4 color;

// Approximates -x exp(-x x) without an exponential function.
float crest(float x)
{
    float k = max(1.0 - 0.25 * x * x, 0.0);
    return -x * k * k;
}

void main()
{
    float r = length(from);
    float first = crest((r - 0.05 - 0.38 * phase) * 30.0) * (1.0 - 0.85 * phase);
    float second = crest((r + 0.02 - 0.38 * phase) * 30.0) * (1.0 - 0.85 * phase) * 0.7;
    float runs = phase > 0.0 ? first + second : 0.0;
    float clings = max(1.0 - abs(r - 0.075) * 28.0, 0.0);
    float lean = (runs + 0.55 * clings * clings) * dot(from, vec2(0.447, -0.894)) / max(r, 1e-4);
    lean *= clamp((0.46 - r) * 8.0, 0.0, 1.0);
    float light = max(lean, 0.0) * 0.75;
    color = vec4(vec3(0.85, 1.0, 0.97) * light, light * 0.5 + max(-lean, 0.0) * 0.55);
}
