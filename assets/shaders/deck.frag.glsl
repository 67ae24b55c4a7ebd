// The rim and the counter. The shader is compiled in three variants, so that each variant computes
// only its own part: COUNTER for the counter, RIM for the top of the rim, and neither for the sides
// of the rim. The picture is kept while the camera rests. KEPT draws the kept picture, and SHADED
// adds the shades of the fans.
in vec3 world; // Position in the player's axes. KEPT: position in the world.
in vec3 face;
uniform sampler2D wood;
out vec4 color;

const float RIM_M = 0.032;

float grain(vec2 at)
{
    return texture(wood, at).r;
}

float lamp_pool(float falloff)
{
    return 1.0 / (1.0 + dot(world.xz, world.xz) * falloff);
}

#if defined(KEPT)
void main()
{
    vec4 kept = texture(wood, gl_FragCoord.xy * screen.xy);
#ifdef SHADED
    kept.rgb *= 1.0 - 0.8 * shade_above(world);
#endif
    color = kept;
}
#elif defined(COUNTER)
void main()
{
    vec2 past = abs(world.xz) - abs(from_world(tank.xz)) - RIM_M;
    float contact = smoothstep(0.0, 0.055, max(past.x, past.y));
    float t = grain(world.xz * vec2(2.2, 6.2));
    vec3 tint = mix(vec3(0.075, 0.042, 0.030), vec3(0.33, 0.20, 0.12), t);
    float pool = lamp_pool(2.2);
    // Two paper lanterns stand at the far corners of the stall. The lamps of the stall hang over
    // the middle.
    vec2 lantern = vec2(abs(world.x) - 0.66, world.z + 0.30);
    float glow = 1.0 / (1.0 + dot(lantern, lantern) * 26.0);
    vec3 light = lamp_light(world) * (0.12 + 0.85 * pool * pool)
        + vec3(1.25, 0.62, 0.26) * (glow * glow);
    color = vec4(tint * light * (0.35 + 0.65 * contact), 1.0);
}
#elif defined(RIM)
void main()
{
    // The grain runs along each plank. At the corners two planks meet in a mitre.
    vec2 past = max(abs(world.xz) - abs(from_world(tank.xz)), 0.0);
    bool across = past.x > past.y;
    vec2 along = across ? world.zx : world.xz;
    float t = grain(vec2(along.x * 1.5, along.y * 7.0 + (across ? 0.37 : 0.0)));
    vec3 tint = mix(vec3(0.30, 0.14, 0.06), vec3(0.80, 0.48, 0.25), t);
    float width = max(past.x, past.y) / RIM_M;     // 0 at the edge beside the water, 1 at the outer
                                                   // edge.
    float bevel = 0.35 * (1.0 - smoothstep(0.0, 0.10, width) - smoothstep(0.88, 1.0, width));
    float mitre = 1.0 - 0.45 * (1.0 - smoothstep(0.0, 0.0012, abs(past.x - past.y)));
    float joined = min(past.x, past.y) > 0.0 ? mitre : 1.0;
    float lamp = 0.70 + 0.46 * lamp_pool(3.0);
    // The last pixel of a plank fades into its background, which is the water at the inner edge of
    // the near plank and the counter at the outer edges of the other planks. The inner edges of the
    // other planks fade into their own dark sides.
    float pixel = fwidth(width);
    float inner = clamp(width / pixel, 0.0, 1.0);
    bool near_plank = !across && world.z > 0.0;
    float seen = near_plank ? inner : clamp((1.0 - width) / pixel, 0.0, 1.0);
    lamp *= near_plank ? 1.0 : 0.4 + 0.6 * inner;
    color = vec4(tint * ((1.0 + bevel) * joined * lamp) * vec3(1.10, 0.99, 0.86)
        * sqrt(lamp_light(world)), 1.0) * seen;
}
#else
void main()
{
    vec2 along = vec2(abs(face.x) > 0.5 ? world.z : world.x, world.y);
    float t = grain(along * vec2(1.5, 6.0));
    vec3 tint = mix(vec3(0.20, 0.09, 0.04), vec3(0.56, 0.32, 0.16), t);
    float height = smoothstep(-0.012, tank.w, world.y);
    float wet = 0.55 + 0.45 * smoothstep(0.004, 0.010, world.y);
    wet = mix(wet, 1.0, max(face.z, 0.0));
    color = vec4(tint * (0.42 + 0.50 * height) * (0.85 + 0.25 * face.z) * wet * lamp_light(world), 1.0);
}
#endif
