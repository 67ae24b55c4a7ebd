in vec3 world;
in vec3 face;
uniform vec4 paint;
out vec4 color;

void main()
{
    vec3 n = normalize(face);
    vec3 view = normalize(eye.xyz - world);
    float lit = 0.52 + 0.55 * max(dot(n, LAMP_DIRECTION), 0.0);
    lit *= 1.0 - 0.7 * shade_at(world, bend.z);
    float shine = max(dot(n, normalize(view + LAMP_DIRECTION)), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
    float facing = dot(n, view);
    float edge = 1.0 - max(facing, 0.0);
    // The outline of a round solid is where it turns away: fading there, one pixel wide, is its
    // anti-aliasing, with or without multisampling.
    float cover = clamp(facing / fwidth(facing), 0.0, 1.0);
    vec3 tint = paint.rgb * (lit + edge * edge * 0.25) + vec3(1.0, 0.95, 0.9) * (0.55 * shine);
    vec3 left = water_passes(-world.y * 1.2);
    color = vec4(mix(WATER_COLOR, tint, left), 1.0) * cover;
}
