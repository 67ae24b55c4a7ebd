// The floor of the tank with the caustics and the shadows.
in vec2 at;
in vec3 gain;
in vec3 added;
in float bright;
uniform sampler2D caustics;
uniform sampler2D shadows;
out vec4 color;

void main()
{
    float light = texture(caustics, at * CAUSTIC_TILES).r
        + texture(caustics, at.yx * CAUSTIC_TILES * 0.72 + 0.37).r;
    light *= (0.52 + 0.66 * light) * bright; // The lines of the caustics become brighter, and the
                                             // ground between them more even.
    float dark = texture(shadows, at * shadow.xy * 0.5 + 0.5).r;
    color = vec4(gain * (0.60 + light * 0.80) * (1.0 - 0.70 * dark * vec3(1.0, 0.93, 0.86)) + added,
                 1.0);
}
