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
    // The water is clear. It shows only the reflection of a lamp, of the dark night or the bright day,
    // and its edge at the wall (the meniscus): a bright ring in a darker one.
    float r = length(grid.xy);
    vec2 ring = grid.xy * (0.012 * sin(r * 15.0 - eye.w * 4.0));
    // The normal (ring.x, 1, ring.y) has almost the length 1.
    float shine = pow(max(light.z + dot(ring, light.xy), 0.0), 90.0);
    float edge = (r / form.z - 0.985) * 70.0;
    float line = max(1.0 - edge * edge, 0.0);
    float dark = clamp(edge * 0.22 + 1.5, 0.0, 1.0);
    float alpha = 0.03 + light.w + 0.20 * dark * dark;
    vec3 sky = mix(vec3(0.10, 0.13, 0.20), vec3(0.85, 0.92, 0.95), evening.w * evening.w);
    color = vec4(sky * alpha + (shine * 0.3 + line * 0.50) * grid.z, alpha);
}
#else
void main()
{
    vec3 enamel = vec3(1.07, 1.02, 0.95);
    float painted = smoothstep(0.90, 0.925, shell.y) * (1.0 - form.w);
#ifdef INSIDE
    float stripe = clamp((0.030 - abs(shell.y - 0.82)) * (1.0 / 0.015), 0.0, 1.0);
    painted = max(painted, 0.8 * stripe);
#endif
    float gap = clamp(shell.z, 0.0, 1.0);
    vec3 tint = mix(enamel, paint.rgb, painted * (1.0 - gap)) * light.x;
    float shine = pow(max(light.y, 0.0), 60.0) * 0.22 * light.w;
#ifdef INSIDE
    // The water in the bowl is shallow and clear, with a little colour where it is deep. The enamel
    // has a dark line right above the water.
    float drowned = clamp(grid.z, 0.0, 1.0);
    float caustic = texture(caustics, grid.xy).g;
    vec3 deep = mix(vec3(1.0), vec3(0.79, 0.92, 0.94), min(grid.z * 0.08, 1.0));
    tint *= mix(vec3(1.0), deep * (0.86 + 0.38 * caustic), drowned);
    float line = abs(grid.z - 0.10) * 4.0;
    tint *= 1.0 - 0.28 * max(1.0 - line * line, 0.0);
    color = vec4(tint + shine * (1.0 - drowned), 1.0);
#else
    // The outline of the bowl is where its surface turns away from the viewer. The outline fades
    // there, which smooths it, as on the poi.
    float cover = clamp(light.z / fwidth(light.z) + 0.15, 0.0, 1.0);
    // The water of the tank rises at the wall, in a bright ring.
    float ring = max(1.0 - abs(grid.x), 0.0);
    vec3 seen = mix(WATER_COLOR, tint + shine, left);
    color = vec4(mix(seen, WATER_COLOR + 0.45 * light.w, 0.75 * ring), 1.0) * cover;
#endif
}
#endif
