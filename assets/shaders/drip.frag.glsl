// A drop, transparent with a bright lower end and a reflection of the lamp in its upper half.
in vec2 corner;
in float shown;
out vec4 color;

void main()
{
    // A drop is narrow at its upper end. Its lower end gathers the light.
    vec2 form = vec2(corner.x * (1.0 + 0.4 * max(corner.y + 0.1, 0.0)), corner.y);
    float r = length(form);
    float inside = clamp((1.0 - r) / fwidth(r), 0.0, 1.0);
    float rim = smoothstep(0.35, 0.95, r);
    float low = max(-0.2 - corner.y, 0.0) * (1.25 - r);
    float lamp = max(1.0 - 3.0 * length(corner - vec2(-0.2, 0.35)), 0.0);
    color = vec4(vec3(0.80, 0.96, 1.0) * (0.14 + 0.34 * rim + 1.9 * low) + lamp, 0.22 + 0.30 * rim + low)
        * (inside * shown);
}
