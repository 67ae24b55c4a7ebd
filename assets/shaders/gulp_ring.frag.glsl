// Two crests run outward and fade; the film clings to the snout. What leans to the lamp shines.
in vec2 from;
in float phase;
out vec4 color;

float crest(float r, float share)
{
    float at = (r - 0.05 - 0.52 * share) / 0.035;
    return -at * exp(-at * at) * (1.0 - share) * step(0.0, share);
}

void main()
{
    float r = length(from);
    float running = phase > 0.0 ? crest(r, phase) + 0.7 * crest(r, phase - 0.22)
        + 0.5 * crest(r, phase + 0.45) * step(phase, 0.55) : 0.0;
    float clings = (r - 0.075) / 0.030;
    float slope = running + 0.55 * exp(-clings * clings);
    float lean = slope * dot(from / max(r, 1e-4), normalize(vec2(0.5, -1.0)));
    float fade = 1.0 - smoothstep(0.40, 0.60, r);
    float light = max(lean, 0.0) * 0.95 * fade;
    float dark = max(-lean, 0.0) * 0.42 * fade;
    color = vec4(vec3(0.95, 1.0, 1.0) * light, light * 0.6 + dark);
}
