in vec3 world;
in vec3 face;
in vec3 at;                     // Position in ring radii.
uniform vec4 paint;             // Colour of the player. w: number of white marks that distinguish
                                // the player.
out vec4 color;

// Returns the coverage of the white bands around handle and ring, which distinguish the players
// without colour.
float marks()
{
    float along = (at.z - 2.0) / 0.30;
    float band = step(0.0, along) * step(along, paint.w)
        * (1.0 - smoothstep(0.22, 0.26, abs(fract(along) - 0.5)));
    float turn = fract(atan(at.x, -at.z) / 6.2831853 * paint.w) - 0.5;
    float on_ring = 1.0 - smoothstep(0.045, 0.055, abs(turn) / max(paint.w, 1.0));
    return min(paint.w, 1.0) * (at.z > 1.19 ? band : on_ring);
}

void main()
{
    vec3 n = normalize(face);
    vec3 view = normalize(eye.xyz - world);
    float lit = 0.52 + 0.55 * max(dot(n, LAMP_DIRECTION), 0.0);
    lit *= 1.0 - 0.7 * shade_above(world);
    float shine = max(dot(n, normalize(view + LAMP_DIRECTION)), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
    float facing = dot(n, view);
    float edge = 1.0 - max(facing, 0.0);
    // The outline of a round solid is where its surface turns away from the viewer. The outline
    // fades there over one pixel, which smooths it with or without multisampling.
    float cover = clamp(facing / fwidth(facing), 0.0, 1.0);
    vec3 plastic = mix(paint.rgb, vec3(1.0, 0.98, 0.94), marks());
    vec3 tint = plastic * (lit + edge * edge * 0.25) + vec3(1.0, 0.95, 0.9) * (0.55 * shine);
    vec3 left = water_passes(-world.y * 1.2);
    color = vec4(mix(WATER_COLOR, tint, left), 1.0) * cover;
}
