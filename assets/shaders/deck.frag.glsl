// The rim, the counter and the street. The shader is compiled in variants, so that each variant
// computes only its own part: BACKDROP for the street, COUNTER for the counter, RIM for the top of
// the rim, and none of them for the sides of the rim. The picture of a camera at rest is kept. KEPT
// draws the kept picture as the camera of this frame sees it, and SHADED adds the shades of the fans.
in vec3 world; // Position in the player's axes. KEPT: position in the world.
in vec3 face;
#ifdef KEPT
in vec3 place_in_kept; // u and v in the kept picture, both multiplied by w, and w.
#endif
uniform sampler2D wood;
uniform sampler2DArray backdrop; // Street behind the stall by night and by day (backdrop.c).
out vec4 color;

const float RIM_M = 0.032;
const float DROP_CELL_M = 0.028; // Side of a square of wet wood that has at most one drop.

float grain(vec2 at)
{
    return texture(wood, at).r;
}

// Returns the picture of the street at a place of its plane, blurred by `blur` mipmap levels. The
// picture is a good deal wider than the far edge of the rim. Beyond its sides follows its mirror
// image.
vec3 street(vec2 at, float blur)
{
    float wide = 3.3 * abs(from_world(tank.xz).x);
    float is_day = step(0.9, evening.w);
    vec3 texel = vec3(at.x / wide + 0.5, (at.y + 0.012) * 4.0 / wide, is_day);
    return textureLod(backdrop, texel, blur).rgb;
}

// Returns the colour of wet wood: `dry` with a film of water that reflects the lamps of the street,
// and with drops.
vec3 wet(vec3 dry, vec3 at)
{
    vec3 viewer = vec3(from_world(eye.xz), eye.y).xzy;
    vec3 ray = at - viewer;
    float far = (abs(from_world(tank.xz).y) + at.z) / max(-ray.z, 0.05);
    float film = smoothstep(0.44, 0.60, textureLod(wood, at.xz * vec2(1.3, 2.6) + 0.31, 4.0).r);
    // One drop, or none, lies in each cell. Most drops lie near the water. The lamps make a bright
    // point on the far side of a drop, and the drop gathers their light on its near side.
    vec2 cell = floor(at.xz / DROP_CELL_M);
    vec3 chance = fract(sin(dot(cell, vec2(12.9898, 78.233)) + vec3(0.0, 1.3, 2.9)) * 43758.5453);
    vec2 drop = at.xz / DROP_CELL_M - cell - mix(vec2(0.3), vec2(0.7), chance.xy);
    vec2 past = abs(at.xz) - abs(from_world(tank.xz));
    float rare = mix(0.74, 0.985, smoothstep(0.0, 0.10, max(past.x, past.y)));
    float radius = mix(0.05, 0.20, fract(37.0 * chance.z)) * step(rare, chance.z);
    float r = length(drop) / max(radius, 0.001);
    float inside = 1.0 - smoothstep(0.85, 1.0, r);
    float point = 1.0 - smoothstep(0.1, 0.3, length(drop / max(radius, 0.001) - vec2(0.15, -0.45)));
    vec2 tilt = drop * inside * 0.9;
    float high = -0.7 * far * ray.y;
    vec3 lamps = street(vec2(at.x + far * ray.x, high) + tilt, 4.0 - 3.0 * inside);
    lamps *= lamps * (0.05 + 0.40 * film + 0.25 * inside) / (1.0 + 5.0 * high * high);
    vec3 soaked = dry * (1.0 - 0.45 * film) * (1.0 + inside * clamp(3.0 * drop.y, -0.15, 0.6));
    return soaked + lamps + lamp_light(at).g * (0.45 * point * inside);
}

float lamp_pool(float falloff)
{
    return 1.0 / (1.0 + dot(world.xz, world.xz) * falloff);
}

#if defined(KEPT)
void main()
{
    vec4 kept = textureProj(wood, place_in_kept);
#ifdef SHADED
    kept.rgb *= 1.0 - 0.8 * shade_above(world);
#endif
    color = kept;
}
#elif defined(BACKDROP)
void main()
{
    // The street is darkest right behind the rim, which hides the light of the bulbs.
    float low = smoothstep(-0.02, 0.10, world.y);
    color = vec4(street(world.xy, 0.0) * (0.55 + 0.45 * low), 1.0);
}
#elif defined(COUNTER)
void main()
{
    vec2 past = abs(world.xz) - abs(from_world(tank.xz)) - RIM_M;
    float away = max(max(past.x, past.y), 0.0);
    float contact = smoothstep(-0.01, world.z > 0.0 && past.y > past.x ? 0.025 : 0.045, away);
    float t = grain(world.xz * vec2(1.4, 3.4));
    vec3 tint = mix(vec3(0.14, 0.082, 0.056), vec3(0.47, 0.31, 0.20), t);
    // The bulbs over the tank light the counter beside it. Lanterns hang at the far corners.
    vec2 lantern = vec2(abs(world.x) - abs(from_world(tank.xz).x) - 0.22, world.z + 0.30);
    float glow = 1.0 / (1.0 + dot(lantern, lantern) * 22.0);
    float beside = 1.0 / (1.0 + away * away * 26.0);
    vec3 light = evening.rgb * (0.30 + 0.70 * evening.w * evening.w)
        + bulbs.rgb * (0.62 * beside + 0.02) + bulbs.r * vec3(0.60, 0.28, 0.11) * (glow * glow);
    color = vec4(wet(tint * light, world) * (0.30 + 0.70 * contact), 1.0);
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
    vec3 dry = tint * ((1.0 + bevel) * joined * lamp) * vec3(1.10, 0.99, 0.86)
        * sqrt(lamp_light(world));
    color = vec4(wet(dry, world), 1.0) * seen;
}
#else
void main()
{
    vec2 along = vec2(abs(face.x) > 0.5 ? world.z : world.x, world.y);
    float t = grain(along * vec2(1.5, 6.0));
    vec3 tint = mix(vec3(0.20, 0.09, 0.04), vec3(0.56, 0.32, 0.16), t);
    float height = smoothstep(-0.012, tank.w, world.y);
    float damp = 0.55 + 0.45 * smoothstep(0.004, 0.010, world.y);
    damp = mix(damp, 1.0, max(face.z, 0.0));
    float lit = (0.42 + 0.50 * height) * (0.85 + 0.25 * face.z) * damp;
    color = vec4(tint * lit * lamp_light(world), 1.0);
}
#endif
