in vec3 face;
in vec3 view;
in vec3 middle;
in vec3 left;
in vec4 mark;
in float foam;
uniform vec4 paint;             // Colour of the player.
out vec4 color;

void main()
{
#ifdef CAP
    color = vec4(0.0); // The colour mask of poi_pass_cap() discards the colour.
#else
    vec3 n = normalize(face);
    float lit = (0.52 + 0.55 * max(dot(n, LAMP_DIRECTION), 0.0)) * mark.z;
    float shine = max(dot(n, middle), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
    float facing = dot(n, view);
    float edge = 1.0 - max(facing, 0.0);
    // The outline of a round solid is where its surface turns away from the viewer. The outline
    // fades there over one pixel, which smooths it with or without multisampling.
    float cover = clamp(facing / fwidth(facing), 0.0, 1.0);
    // White bands around handle and ring distinguish the players without colour.
    float band = clamp((mark.y - abs(fract(mark.x) - 0.5)) * 30.0 + 0.5, 0.0, 1.0);
    vec3 plastic = mix(paint.rgb, vec3(1.0, 0.98, 0.94), band);
    vec3 tint = plastic * (lit + edge * edge * 0.25) + vec3(1.0, 0.95, 0.9) * (0.55 * shine);
    // The water climbs on the ring where it crosses the surface, as a bright line of foam.
    float line = foam * max(1.0 - abs(mark.w - 0.0005) * 520.0, 0.0);
    color = vec4(mix(mix(WATER_COLOR, tint, left), vec3(0.95, 1.0, 1.0), line), 1.0) * cover;
#endif
}
