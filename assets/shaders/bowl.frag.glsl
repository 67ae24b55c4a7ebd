in vec3 world;
in vec3 face;
in vec3 shell;
uniform vec4 mouth;
uniform vec4 form;
uniform vec4 paint;
uniform sampler2D caustics;
out vec4 color;

#ifdef HOLE
void main()
{
    color = vec4(0.0); // The colour mask of bowl_pass_hole() discards the colour.
}
#elif defined(WATER)
void main()
{
    vec3 view = normalize(eye.xyz - world);
    vec2 d = (world.xz - mouth.xz) / mouth.w;
    float r = length(d);
    vec2 ring = d * 0.035 * sin(r * 24.0 - eye.w * 5.0);
    vec3 n = normalize(vec3(ring.x, 1.0, ring.y));
    float shine = max(dot(n, normalize(view + LAMP_DIRECTION)), 0.0);
    shine = pow(shine, 90.0);
    float away = 1.0 - max(dot(n, view), 0.0);
    float alpha = 0.10 + 0.28 * smoothstep(0.76, 0.93, r) + 0.4 * away * away * away;
    color = vec4(vec3(0.22, 0.66, 0.80) * alpha + shine * 0.25, alpha);
}
#else
void main()
{
    vec3 n = normalize(face);
    vec3 view = normalize(eye.xyz - world);
    float lit = 0.58 + 0.50 * max(dot(n, LAMP_DIRECTION), 0.0);
    vec3 enamel = vec3(1.0, 0.995, 0.97);
    float band = smoothstep(0.90, 0.925, shell.y);
    float stripe = (1.0 - smoothstep(0.015, 0.030, abs(shell.y - 0.82))) * (1.0 - shell.x);
    float gap = min(paint.w, 1.0)
        * smoothstep(cos(0.21 * paint.w), cos(0.16 * paint.w) + 1e-4, shell.z);
    vec3 tint = mix(enamel, paint.rgb, max(band, 0.8 * stripe) * (1.0 - gap));
    float inside = 1.0 - shell.x;
    float light = texture(caustics, world.xz * CAUSTIC_TILES * 1.6).r;
    tint *= lit * mix(1.0, 0.62 + 0.38 * shell.y, inside * 0.55);
    // The water in the bowl is shallow. It has a blue tint, but is clear enough for the fish in the
    // bowl to be visible.
    float under = form.y - (world.y - mouth.y) / form.x;
    float drowned = inside * smoothstep(-0.02, 0.04, under);
    tint *= mix(vec3(1.0), vec3(0.70, 0.94, 1.02), drowned);
    tint *= 1.0 + inside * (light - 0.25) * 0.55 * drowned;
    float shine = max(dot(n, normalize(view + LAMP_DIRECTION)), 0.0);
    float lamps = 1.0 - 0.7 * shade_above(world);
    tint = (tint + pow(shine, 60.0) * 0.22) * lamps;
    float depth = inside > 0.5 ? 0.0 : -world.y;
    vec3 left = water_passes(depth * 1.2);
    // The outline of the bowl is where its surface turns away from the viewer. The outline fades
    // there, which smooths it, as on the poi.
    float facing = dot(n, view);
    float cover = clamp(facing / fwidth(facing) + 0.15, 0.0, 1.0);
    color = vec4(mix(WATER_COLOR, tint, left), 1.0) * cover;
}
#endif
