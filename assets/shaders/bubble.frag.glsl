// A bubble is a bright rim around a transparent middle, with a reflection of the lamp. The air
// stone is a rough ball.
in vec2 corner;
in float grey;
in float whole;
out vec4 color;

void main()
{
    float r = length(corner);
    float pixel = fwidth(r);
    float inside = clamp((1.0 - r) / pixel, 0.0, 1.0);
    float rim = smoothstep(0.45, 0.95, r);
    float lamp = max(1.0 - 3.2 * length(corner - vec2(-0.35, 0.40)), 0.0);
    vec4 bubble = vec4(vec3(0.75, 0.95, 1.0) * (0.10 + 0.62 * rim) + lamp, 0.14 + 0.40 * rim);
    vec3 n = vec3(corner, sqrt(max(1.0 - r * r, 0.0)));
    float lit = 0.30 + 0.90 * max(dot(n, vec3(-0.30, 0.55, 0.78)), 0.0);
    vec3 left = water_passes(tank.y * 1.2);
    vec4 ball = vec4(mix(WATER_COLOR, vec3(0.30, 0.42, 0.62) * lit, left), 1.0);
    color = mix(bubble * whole, ball, grey) * inside;
}
