// A drop, transparent with a bright lower rim and a reflection of the lamp in its upper half.
in vec2 corner;
in float shown;
out vec4 color;

void main()
{
    float r = length(corner);
    float inside = clamp((1.0 - r) / fwidth(r), 0.0, 1.0);
    float rim = smoothstep(0.3, 0.95, r) * (0.55 - 0.45 * corner.y);
    float lamp = max(1.0 - 2.6 * length(corner - vec2(-0.25, 0.45)), 0.0);
    color = vec4(vec3(0.80, 0.96, 1.0) * (0.22 + 0.6 * rim) + lamp, 0.35 + 0.4 * rim)
        * (inside * shown);
}
