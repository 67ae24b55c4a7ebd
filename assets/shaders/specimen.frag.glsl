// Skin of a specimen in studio light: a soft lamp above and beside the viewer, light from the water
// below, and a cool edge light. Two neighbouring sheets of the fish texture are mixed.
in vec3 normal;
in vec2 paint_uv;
in vec4 skin;

uniform sampler2DArray paints; // Colour and transparency.
uniform sampler2DArray shines; // Reflectance.
uniform vec3 sheets;           // x, y: two layers of the fish texture. z: weight of the second
                               // layer.
uniform vec4 look; // Opacity, number of scales along the body, transparency of the body. w: 1 for
                   // parts behind a transparent body, otherwise 0.
uniform vec4 tint;
uniform sampler2DArray patterns; // Patterns of the individual goldfish.
uniform vec4 worn;               // Pattern layer, hue, visibility of the pattern, maturity.
uniform vec3 worn_red;           // Colour of the goldfish where its pattern is red.

out vec4 color;

const vec3 KEY_LIGHT = vec3(-0.42, 0.74, 0.53);
const vec3 WARM = vec3(1.10, 1.04, 0.94);
const vec3 ABOVE = vec3(0.46, 0.50, 0.54); // Ambient light from above.
const vec3 BELOW = vec3(0.14, 0.24, 0.28); // Ambient light from below, through water.
const vec3 EDGE = vec3(0.36, 0.48, 0.56);
const float PUPIL = 0.56; // Radius of the pupil, as a fraction of the eye's visible radius.

// Colour of a black goldfish where its pattern is white, as in fish_colours.c.
const vec3 BRONZE = vec3(0.42, 0.30, 0.16);

// Colour of a young goldfish.
const vec3 FRY = vec3(0.45, 0.36, 0.20);
// Returns the fraction of the young colour that a point of the skin has lost. `ahead` is above 0
// where the loss begins earlier, as on the belly.
float turned(float maturity, float ahead)
{
    return smoothstep(0.10, 0.42, maturity + ahead);
}

// Writes the skin colours of a goldfish: `pale` where its pattern is white, and `stain` where its
// pattern is red. `under` is 0 at the back and 1 at the belly. In the
// tank, fish_colours.c computes the same colours.
void goldfish_skin(float under, float maturity, float hue, out vec3 pale, out vec3 stain)
{
    float belly = smoothstep(0.36, 0.92, under);
    vec3 white = hue > 1.0 ? BRONZE : WHITE;
    vec3 below = mix(white, worn_red, 0.25);
    vec3 young = mix(FRY * (0.62 + 0.38 * under), vec3(0.82, 0.74, 0.56), belly);
    pale = mix(young, mix(white, below, 0.55 * belly), turned(maturity, 0.10 * belly - 0.06));
    stain = mix(young, mix(worn_red, below, 0.80 * belly), turned(maturity, 0.10 * belly + 0.06));
}

// Returns the colour of a goldfish's fins at (u, v), the coordinates of species.h. `layer` is the
// pattern layer of the fish's skin.
vec3 goldfish_fin(vec2 at, float maturity, float hue, float layer)
{
    float seed = fract(hue * 17.31);
    float root = 1.0 - at.y;
    float plain = fract(seed * 7.7 + layer * 0.37);
    plain = layer < 2.5 ? 0.45 + 0.55 * plain : plain;
    float stained = smoothstep(0.30, 0.72, plain + 0.20 * sin(at.x * 9.0 + hue * 20.0) + 0.25 * root);
    vec3 white = hue > 1.0 ? BRONZE : WHITE;
    vec3 tint = mix(white, worn_red, stained);
    return mix(mix(FRY * 1.25, tint, turned(maturity, 0.0)), WHITE, 0.22 * at.y);
}

vec3 to_light(vec3 c)
{
    return c * c * (0.30 * c + 0.70);
}

vec3 to_screen(vec3 c)
{
    c = c / (1.0 + 0.16 * c);
    c *= 1.12 - 0.06 * c;
    c /= 1.0 + 0.8 * max(c - 0.75, 0.0); // Compresses highlights, so that bright areas keep their
                                         // shading.
    return sqrt(c); // The square root is close to an exponent of 1 / 2.2 in this range, at a tenth
                    // of the cost.
}

vec4 mixed(sampler2DArray of, vec2 at)
{
    return mix(texture(of, vec3(at, sheets.x)), texture(of, vec3(at, sheets.y)), sheets.z);
}

// Returns the light that a silvery skin reflects: bright light from above, a dark band at eye
// level, and the colour of water from below.
vec3 mirrored(vec3 n)
{
    float up = 2.0 * n.z * n.y;
    vec3 sky = mix(vec3(0.62, 0.74, 0.80), vec3(1.25, 1.24, 1.18), smoothstep(0.1, 0.8, up));
    vec3 deep = mix(vec3(0.30, 0.42, 0.48), vec3(0.10, 0.20, 0.25), smoothstep(0.0, -0.9, up));
    return mix(deep, sky, smoothstep(-0.12, 0.30, up));
}

vec3 worn_body(vec3 paint)
{
    float under = 1.0 - abs(skin.y * 2.0 - 1.0);
    float belly = smoothstep(0.52, 0.96, under);
    float bow = (under - 0.52) * (under - 0.52);
    float gill = max(1.0 - abs(skin.x - 0.285 + 0.25 * bow) * 80.0, 0.0);
    gill *= smoothstep(0.15, 0.35, under) * (1.0 - belly);
    vec3 pale;
    vec3 stain;
    goldfish_skin(under, worn.w, worn.y, pale, stain);
    float is_red = texture(patterns, vec3(skin.xy, worn.x)).r;
    return mix(paint, mix(pale, stain, is_red) * (1.0 - 0.36 * gill), worn.z);
}

vec3 worn_fin(vec3 paint)
{
    return mix(paint, goldfish_fin(skin.xy, worn.w, worn.y, worn.x), worn.z);
}

vec3 lit(vec3 paint, vec3 n, float shine, float gloss)
{
    float lamp = max(dot(n, KEY_LIGHT) * 0.80 + 0.20, 0.0);
    vec3 light = WARM * 1.12 * lamp + mix(BELOW, ABOVE, 0.5 + 0.5 * n.y);
    vec3 half_way = normalize(KEY_LIGHT + vec3(0.0, 0.0, 1.0));
    float at_lamp = max(dot(n, half_way), 0.0);
    float spot = pow(at_lamp, mix(26.0, 70.0, gloss));
    float sheen = at_lamp * at_lamp;
    sheen *= sheen * sheen * gloss;
    float edge = 1.0 - max(n.z, 0.0);
    edge *= edge * edge;
    vec3 dull = paint * (light + 0.55 * sheen);
    vec3 pearl = 1.0 + 0.10 * sin(vec3(0.0, 2.1, 4.2) + 7.0 * n.y + 4.0 * n.x);
    vec3 silver = mirrored(n) * (0.35 + 0.80 * paint) * pearl;
    return mix(dull, silver, 0.62 * shine) + WARM * spot * (0.04 + 0.36 * gloss)
        + EDGE * edge * 0.26;
}

#ifdef FIN
void main()
{
    vec4 paint = mixed(paints, paint_uv);
    float shine = mixed(shines, paint_uv).r;
    paint.rgb = mix(worn_fin(paint.rgb), tint.rgb, tint.a);
    vec3 n = normalize(normal);
    n = n.z < 0.0 ? -n : n;
    float rays = abs(fract(skin.x * 13.0) * 2.0 - 1.0);
    float fine = clamp(1.0 - 1.3 * fwidth(skin.x * 13.0), 0.0, 1.0);
    rays = mix(0.5, rays, fine);
    float root = 1.0 - skin.y;
    float alpha = (0.62 + 0.34 * root * root) * (0.84 + 0.26 * rays);
    alpha *= 1.0 - 0.60 * paint.a;
    // The outline fades over about a pixel, at the fin's tip and beside its first and last ray.
    vec2 from_rim = vec2(min(skin.x, 1.0 - skin.x), 1.0 - skin.y) / max(fwidth(skin.xy), 1e-4);
    alpha *= clamp(min(from_rim.x, from_rim.y) + 0.15, 0.0, 1.0);
    // Of a median fin, only the root is behind a transparent body, and the root is not drawn there.
    float paired = step(4.5, skin.z) * step(skin.z, 6.5);
    alpha = clamp(alpha, 0.0, 1.0) * look.x * (1.0 - look.w * (1.0 - paired));
    vec3 through = 0.30 * to_light(paint.rgb); // Light that passes through the fin.
    vec3 light = lit(to_light(paint.rgb) * (0.82 + 0.30 * rays), n, 0.3 * shine, 0.25) + through;
    color = vec4(to_screen(light) * alpha, alpha);
}
#else
const float EYE_WIDTH = 63.0 / 256.0; // Fraction of the sheet's width that the range of u of an eye
                                      // covers.

// Returns the colour of an eye. The fish texture contains the iris. The pupil's edge is drawn here,
// at the screen's resolution.
vec4 eyeball(vec3 n)
{
    vec3 iris = mixed(paints, paint_uv + vec2((0.80 - skin.x) * EYE_WIDTH, 0.0)).rgb;
    iris = mix(iris, tint.rgb, tint.a);
    float soft = max(fwidth(skin.x), 0.01);
    float pupil = 1.0 - smoothstep(PUPIL - soft, PUPIL + soft, skin.x);
    float rim = smoothstep(0.86, 0.99, skin.x);
    float ring = smoothstep(PUPIL, PUPIL + 0.14, skin.x);
    vec3 paint = to_light(iris) * (0.70 + 0.50 * ring) * (1.0 - 0.80 * rim);
    paint = mix(paint, vec3(0.006), pupil);
    float spot = smoothstep(0.962, 0.984, dot(n, normalize(KEY_LIGHT + vec3(0.0, 0.10, 1.0))));
    float glow = 0.10 * pupil * max(-n.y, 0.0); // Light from the water in the lens of the eye.
    return vec4(lit(paint, n, 0.0, 0.0) + vec3(1.15 * spot) + glow * BELOW, 1.0);
}

// Returns a pattern of rows of round scales, in which each scale covers the root of the scale
// behind it. x: nearness of the point to a scale's edge, [0, 1]. y: tilt of the scale toward the
// tail, [0, 1].
vec2 scales(vec2 uv)
{
    vec2 p = vec2(uv.x, uv.y * 0.82) * look.y;
    float told = clamp(1.5 - 2.4 * max(fwidth(p.x), fwidth(p.y)), 0.0, 1.0);
    float row = floor(p.y * 2.0);
    // Four rows of scales reach this point: y has the height of each row beside the point.
    vec4 y = p.y - 0.5 * (row + vec4(-1.0, 0.0, 1.0, 2.0));
    float odd = fract(0.5 * row);
    vec2 x = fract(p.x - vec2(0.5 - odd, odd));
    vec4 wide = 0.62 - y * y;
    vec4 back = sqrt(max(wide, 0.0)) - 0.08 - x.xyxy; // Distance from the point to the end of the
                                                      // scale in each row.
    back += step(back, vec4(0.0)) + 9.0 * step(wide, vec4(0.0)); // A point behind that end lies on
                                                                 // the next scale, to whose end the
                                                                 // distance is then measured.
    float front = min(min(back.x, back.y), min(back.z, back.w));
    float edge = 1.0 - smoothstep(0.0, 0.22, front);
    float trunk = smoothstep(0.22, 0.30, uv.x) * (1.0 - smoothstep(0.90, 1.0, uv.x));
    return vec2(edge, clamp(1.2 - 1.3 * front, 0.0, 1.0)) * (told * trunk * step(1.0, look.y));
}

// Lines round the body that are too fine for a sheet (platform/render/fish_texture.h), which are
// the bands of core/morph/mark.c. Each line has its true width, even if that is below a pixel.
uniform vec4 line_place[2];
uniform vec4 line_shape[2];
uniform vec3 line_colour[2];

vec4 lined(vec4 paint)
{
    float high = 0.5 + 0.5 * cos(6.2831853 * skin.y);
    for (int i = 0; i < 2; i++) {
        float at = skin.x - line_place[i].w * (high - 0.5) - line_place[i].x;
        float wide = max(fwidth(at), 1e-5);
        float off = abs((clamp(floor(at / max(line_place[i].y, 1e-4)), 0.0, line_place[i].z - 1.0)
            + 0.5) * line_place[i].y - at);
        float here = min(off + 0.5 * wide, line_shape[i].x) - max(off - 0.5 * wide, -line_shape[i].x);
        float cover = clamp(here / wide, 0.0, 1.0) * line_shape[i].w * step(0.5, line_place[i].z)
            * smoothstep(line_shape[i].y - 0.03, line_shape[i].y + 0.03, high)
            * (1.0 - smoothstep(line_shape[i].z - 0.03, line_shape[i].z + 0.03, high));
        paint.rgb = mix(paint.rgb, line_colour[i], cover);
        paint.a *= 1.0 - 0.85 * cover;
    }
    return paint;
}

vec4 body(vec3 n)
{
    vec4 paint = lined(mixed(paints, paint_uv));
    float shine = mixed(shines, paint_uv).r;
    paint.rgb = mix(worn_body(paint.rgb), tint.rgb, tint.a);
    vec2 scale = scales(skin.xy) * (1.0 - smoothstep(0.02, 0.30, look.z)) * (1.0 - tint.a);
    n = normalize(n + vec3(0.10, 0.04, 0.0) * scale.y); // The tilt of each scale gives it a
                                                        // highlight of its own.
    vec3 base = to_light(paint.rgb) * (1.06 - 0.36 * scale.x);
    vec3 light = lit(base, n, shine * (1.0 - 0.5 * scale.x), 0.35 + 0.5 * shine);
    float edge = 1.0 - max(n.z, 0.0);
    // A transparent body transmits most light. Its outline and its painted marks remain visible.
    float through = paint.a * (1.5 - 0.5 * paint.a);
    float alpha = mix(1.0, 0.14 + 0.66 * edge * edge, through);
    return vec4(light, alpha);
}

void main()
{
    vec3 n = normalize(normal);
    vec4 light = skin.z > 0.5 ? eyeball(n) : body(n);
    // The outline of a round body is where its surface turns away from the viewer. The outline
    // fades there over about a pixel, which smooths it.
    float cover = clamp(n.z / max(fwidth(n.z), 1e-4) + 0.35, 0.0, 1.0) * look.x * light.a;
    color = vec4(to_screen(light.rgb) * cover, cover);
}
#endif
