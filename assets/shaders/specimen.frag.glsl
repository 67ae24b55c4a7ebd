// A specimen's skin in the light of a studio: a soft lamp above its face, water light from below,
// a cool edge. The keys' sheets of paint are mixed as the keys' shapes are.
in vec3 normal;
in vec2 paint_uv;
in vec4 skin;

uniform sampler2DArray paints; // A layer a key: colour, and how clear.
uniform sampler2DArray shines; // How silvery.
uniform float coats[8];        // How much of each key's; sum 1.
uniform vec3 look;             // Opacity, scales along the body, keys.
uniform vec4 tint;

out vec4 color;

const vec3 KEY_LIGHT = vec3(-0.42, 0.74, 0.53);
const vec3 WARM = vec3(1.10, 1.04, 0.94);
const vec3 ABOVE = vec3(0.46, 0.50, 0.54); // What comes from all over, above ...
const vec3 BELOW = vec3(0.14, 0.24, 0.28); // ... and below, through water.
const vec3 EDGE = vec3(0.36, 0.48, 0.56);

vec3 to_light(vec3 c)
{
    return c * c * (0.30 * c + 0.70);
}

vec3 to_screen(vec3 c)
{
    c = c / (1.0 + 0.16 * c); // The brightest bends over, and never burns out.
    return pow(max(c * 1.10, 0.0), vec3(1.0 / 2.2));
}

void mix_coats(out vec4 paint, out float shine)
{
    paint = vec4(0.0);
    shine = 0.0;
    for (int key = 0; key < int(look.z + 0.5); key++) {
        if (coats[key] > 0.002) {
            paint += coats[key] * texture(paints, vec3(paint_uv, float(key)));
            shine += coats[key] * texture(shines, vec3(paint_uv, float(key))).r;
        }
    }
}

// What a silvery skin mirrors: bright above, a dark band at its height, water below.
vec3 mirrored(vec3 n)
{
    float up = 2.0 * n.z * n.y;
    vec3 sky = mix(vec3(0.62, 0.74, 0.80), vec3(1.25, 1.24, 1.18), smoothstep(0.1, 0.8, up));
    vec3 deep = mix(vec3(0.30, 0.42, 0.48), vec3(0.10, 0.20, 0.25), smoothstep(0.0, -0.9, up));
    return mix(deep, sky, smoothstep(-0.12, 0.30, up));
}

vec3 lit(vec3 paint, vec3 n, float shine, float gloss)
{
    float lamp = max(dot(n, KEY_LIGHT) * 0.82 + 0.18, 0.0);
    vec3 light = WARM * lamp + mix(BELOW, ABOVE, 0.5 + 0.5 * n.y);
    vec3 half_way = normalize(KEY_LIGHT + vec3(0.0, 0.0, 1.0));
    float spot = pow(max(dot(n, half_way), 0.0), mix(26.0, 70.0, gloss));
    float edge = 1.0 - max(n.z, 0.0);
    edge *= edge * edge;
    vec3 dull = paint * light;
    vec3 silver = mirrored(n) * (0.35 + 0.80 * paint);
    return mix(dull, silver, 0.62 * shine) + WARM * spot * (0.05 + 0.34 * gloss)
        + EDGE * edge * 0.32;
}

#ifdef FIN
void main()
{
    vec4 paint;
    float shine;
    mix_coats(paint, shine);
    paint.rgb = mix(paint.rgb, tint.rgb, tint.a);
    vec3 n = normalize(normal);
    n = n.z < 0.0 ? -n : n;
    float rays = abs(fract(skin.x * 13.0) * 2.0 - 1.0);
    float fine = clamp(1.0 - 1.3 * fwidth(skin.x * 13.0), 0.0, 1.0);
    rays = mix(0.5, rays, fine);
    float root = 1.0 - skin.y;
    float alpha = (0.62 + 0.34 * root * root) * (0.84 + 0.26 * rays);
    alpha *= 1.0 - 0.60 * paint.a;
    float out_ = min(1.0 - skin.y, min(skin.x, 1.0 - skin.x) * 8.0);
    alpha *= clamp(out_ / max(fwidth(skin.y), 1e-4) + 0.15, 0.0, 1.0);
    alpha = clamp(alpha, 0.0, 1.0) * look.x;
    vec3 through = 0.30 * to_light(paint.rgb); // Light comes through it.
    vec3 light = lit(to_light(paint.rgb) * (0.82 + 0.30 * rays), n, 0.3 * shine, 0.25) + through;
    color = vec4(to_screen(light) * alpha, alpha);
}
#else
vec4 eyeball(vec3 n)
{
    vec3 iris = texture(paints, vec3(paint_uv, 0.0)).rgb;
    float soft = max(fwidth(skin.x), 0.01);
    float pupil = 1.0 - smoothstep(0.56 - soft, 0.56 + soft, skin.x);
    float rim = smoothstep(0.88, 1.02, skin.x);
    iris *= 0.80 + 0.45 * smoothstep(0.56, 0.72, skin.x) * (1.0 - rim);
    vec3 paint = mix(to_light(iris), vec3(0.006), max(pupil, 0.75 * rim));
    vec3 half_way = normalize(KEY_LIGHT + vec3(0.0, 0.0, 1.0));
    float spot = smoothstep(0.955, 0.985, dot(n, half_way));
    return vec4(lit(paint, n, 0.0, 0.0) + vec3(1.1 * spot), 1.0);
}

// Rows of scales, each over the next one's root; gone where a pixel no longer tells them apart.
float scales(vec2 uv)
{
    vec2 p = vec2(uv.x * look.y, uv.y * look.y * 0.9);
    float near_ = clamp(1.6 - 2.2 * max(fwidth(p.x), fwidth(p.y)), 0.0, 1.0);
    p.x += 0.5 * mod(floor(p.y), 2.0);
    vec2 q = fract(p) - vec2(0.0, 0.5);
    float d = length(q * vec2(0.92, 1.0));
    float edge = smoothstep(0.62, 0.95, d) - 0.6 * smoothstep(0.30, 0.62, d) * (1.0 - d);
    float trunk = smoothstep(0.23, 0.29, uv.x) * (1.0 - smoothstep(0.93, 1.0, uv.x));
    return edge * near_ * trunk * step(1.0, look.y);
}

vec4 body(vec3 n)
{
    vec4 paint;
    float shine;
    mix_coats(paint, shine);
    paint.rgb = mix(paint.rgb, tint.rgb, tint.a);
    float grown = (1.0 - paint.a) * (1.0 - tint.a);
    float scale = scales(skin.xy) * grown;
    float gill = max(1.0 - abs(skin.x - 0.235 + 0.5 * (skin.y - 0.5) * (skin.y - 0.5)) * 70.0, 0.0);
    float under = 1.0 - abs(skin.y * 2.0 - 1.0);
    gill *= smoothstep(0.18, 0.34, under) * (1.0 - smoothstep(0.75, 0.95, under)) * grown;
    gill *= step(1.0, look.y);
    vec3 base = to_light(paint.rgb) * (1.0 - 0.34 * scale) * (1.0 - 0.45 * gill);
    vec3 light = lit(base, n, shine * (1.0 - 0.5 * scale), 0.35 + 0.5 * shine);
    float edge = 1.0 - max(n.z, 0.0);
    float alpha = mix(1.0, 0.20 + 0.62 * edge * edge, paint.a);
    return vec4(light, alpha);
}

void main()
{
    vec3 n = normalize(normal);
    vec4 light = skin.z > 0.5 ? eyeball(n) : body(n);
    // A round body ends where it turns away: fading there, about a pixel wide, smooths its outline.
    float cover = clamp(n.z / max(fwidth(n.z), 1e-4) + 0.35, 0.0, 1.0) * look.x * light.a;
    color = vec4(to_screen(light.rgb) * cover, cover);
}
#endif
