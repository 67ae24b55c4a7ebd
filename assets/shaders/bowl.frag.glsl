// The bowl in four variants: INSIDE, CAP (bowl_pass_cap()), WATER, and the outside with the lip.
in vec3 shell;   // As in bowl.vert.glsl.
in vec4 light;
in vec3 left;
in vec3 grid;
uniform vec4 form;
uniform vec4 paint;
uniform sampler2D caustics;
out vec4 color;

#ifdef CAP
void main()
{
    color = vec4(0.0); // The colour mask of bowl_pass_cap() discards the colour.
}
#elif defined(WATER)
void main()
{
    float r = length(grid.xy);
    vec2 ring = grid.xy * 0.035 * sin(r * 24.0 - eye.w * 5.0);
    // The normal (ring.x, 1, ring.y) has almost the length 1.
    float shine = max(light.z + dot(ring, light.xy), 0.0);
    shine = pow(shine, 90.0);
    float alpha = 0.10 + 0.28 * smoothstep(0.76, 0.93, r) + light.w;
    color = vec4(vec3(0.22, 0.66, 0.80) * alpha + shine * 0.25, alpha);
}
#else
void main()
{
    vec3 enamel = vec3(1.0, 0.995, 0.97);
    float painted = smoothstep(0.90, 0.925, shell.y);
#ifdef INSIDE
    float stripe = clamp((0.030 - abs(shell.y - 0.82)) * (1.0 / 0.015), 0.0, 1.0);
    painted = max(painted, 0.8 * stripe);
#endif
    float gap = clamp(shell.z, 0.0, 1.0);
    vec3 tint = mix(enamel, paint.rgb, painted * (1.0 - gap)) * light.x;
    float shine = pow(max(light.y, 0.0), 60.0) * 0.22 * light.w;
#ifdef INSIDE
    // The water in the bowl is shallow. It has a blue tint, but is clear enough for the fish in the
    // bowl to be visible.
    float drowned = clamp(grid.z, 0.0, 1.0);
    float caustic = texture(caustics, grid.xy).r;
    tint *= mix(vec3(1.0), vec3(0.70, 0.94, 1.02) * (0.8625 + 0.55 * caustic), drowned);
    color = vec4(tint + shine, 1.0);
#else
    // The outline of the bowl is where its surface turns away from the viewer. The outline fades
    // there, which smooths it, as on the poi.
    float cover = clamp(light.z / fwidth(light.z) + 0.15, 0.0, 1.0);
    color = vec4(mix(WATER_COLOR, tint + shine, left), 1.0) * cover;
#endif
}
#endif
