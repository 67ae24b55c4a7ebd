// A bubble is a bright rim around a transparent middle, with a reflection of the lamp. The air
// stone is a rough, pale cylinder with rounded edges, and its hose is a clear tube.
in vec2 corner;
in float grey;
in float high_m;
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
    // The stone is twice as high as wide.
    vec2 at = vec2(corner.x * 1.7, corner.y);
    vec2 round_at = at * at;
    float solid = clamp((1.0 - dot(round_at, round_at)) * 4.0, 0.0, 1.0);
    float rough = fract(sin(dot(floor(corner * 9.0), vec2(12.9898, 78.233))) * 43758.5453);
    float lit = 0.75 - 0.35 * at.x + 0.25 * corner.y - 0.18 * rough;
    vec3 left = water_passes(tank.y * 1.2);
    vec4 rock = vec4(mix(WATER_COLOR, vec3(0.80, 0.78, 0.72) * lit, left), 1.0) * solid;
    float edge = abs(corner.x);
    float gleam = max(1.0 - 4.0 * abs(corner.x + 0.35), 0.0);
    vec3 tube = vec3(0.62, 0.74, 0.70) * (0.75 - 0.35 * edge * edge) + 0.45 * gleam;
    tube = mix(WATER_COLOR, tube, water_passes(-high_m * 1.2));
    vec4 hose = vec4(0.7 * tube, 1.0) * (0.65 + 0.25 * edge);
    color = grey > 1.5 ? hose : mix(bubble * whole * inside, rock, grey);
}
