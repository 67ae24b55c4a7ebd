// Fragment shader of the user interface. The shader is compiled once for each kind of quad (enum
// ui_kind), with the macro of this kind, for example UI_WOOD. The macros FONT_EDGE, FONT_STEP and
// FONT_SIZE describe the font atlas. The shader is compiled without common.glsl.
//
// Every shape is defined by its signed distance in pixels, so that each edge is smoothed over
// exactly one pixel. The output has premultiplied alpha. Additive light has alpha 0. Names: `at` is
// (u, v) of struct ui_vertex, `s` is `shape`, `inner` is `fill`, and `outer` is `line`.
precision highp float;
uniform lowp sampler2DArray font;
uniform sampler2D paper;
in highp vec2 at;
flat in highp vec4 s;
flat in mediump vec4 inner, outer;
out vec4 colour;
float cover(float d) { return clamp(0.5 - d, 0.0, 1.0); }
vec4 over(vec4 top, vec4 under) { return top + under * (1.0 - top.a); }
vec4 paint(vec4 c, float amount) { return vec4(c.rgb, 1.0) * (c.a * amount); }
float fibre(vec2 p) { return texture(paper, p).r; }
float box(vec2 p, vec2 half_size, float radius) {
    vec2 d = abs(p) - half_size + radius;
    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0) - radius;
}
vec4 framed(vec4 body) {
    float d = box(at, s.xy, s.z);
    float edge = s.w > 0.0 ? 1.0 - cover(d + s.w) : 0.0;
    return over(paint(outer, edge), paint(body, 1.0)) * cover(d);
}

#if defined(UI_GLYPH)
// A letter (UI_GLYPH).
void main() {
    float page = floor(at.y / FONT_SIZE.y);
    vec3 place = vec3(at / FONT_SIZE - vec2(0.0, page), page);
    float d = (texture(font, place).r * 255.0 - FONT_EDGE) / FONT_STEP + s.x;
    if (outer.a == 0.0) {
        colour = paint(inner, cover(-d * s.w));
        return;
    }
    d += s.y;
    float soft = s.z > 0.0 ? smoothstep(-s.z, 0.0, d) : 0.0;
    colour = paint(outer, max(cover(-d * s.w), soft * soft * 0.8));
}
#elif defined(UI_PANEL)
// A plain panel (UI_PANEL).
void main() { colour = framed(inner); }
#elif defined(UI_WASHI)
// Paper (UI_WASHI). Paper with a border also has a second, finer line inside the border.
void main() {
    float f = fibre(at * 0.0034) - 0.5;
    vec2 q = at / s.xy;
    vec4 body = vec4(inner.rgb * (1.0 + 0.13 * f - 0.06 * dot(q, q)), inner.a);
    float thread = abs(box(at, s.xy, s.z) + 3.6 * s.w) - 0.28 * s.w;
    body.rgb = mix(body.rgb, outer.rgb, 0.7 * cover(thread) * step(1.0, s.w));
    colour = framed(body);
}
#elif defined(UI_WOOD)
// Planed cedar (UI_WOOD), with soft bands of grain along the tag and a bevel with a bright upper
// edge.
void main() {
    vec2 p = at / s.y;
    float slow = fibre(vec2(p.x * 0.09 + inner.r, p.y * 0.035));
    float year = fract((p.x + 0.16 * p.y * p.y * p.x) * 5.0 + 5.0 * slow);
    float fine = fibre(vec2(p.x * 2.6, p.y * 0.13)) - 0.5;
    float d = box(at, s.xy, s.z);
    float bevel = smoothstep(-2.2 * s.w - 3.0, -s.w, d);
    float grain = 0.10 * year * year * (1.0 - smoothstep(0.86, 1.0, year));
    vec3 body = inner.rgb * (1.03 - grain * vec3(0.8, 1.1, 1.4) + 0.20 * fine);
    body *= (1.0 - 0.06 * p.y) * (1.0 - 0.22 * bevel * (p.y + 0.3 * at.x / s.x));
    colour = framed(vec4(body, inner.a));
}
#elif defined(UI_HEAT)
// The stress colours (UI_HEAT). The colours equal those in assets/shaders/poi_paper.frag.glsl.
void main() {
    float t = clamp(at.x / s.x * 0.5 + 0.5, 0.0, 1.0);
    vec3 c = mix(vec3(1.0, 0.95, 0.85), vec3(0.98, 0.66, 0.16),
                 smoothstep(0.05, 0.40, t));
    c = mix(c, vec3(0.82, 0.17, 0.09), smoothstep(0.36, 0.70, t));
    c = mix(c, vec3(0.24, 0.02, 0.08), smoothstep(0.70, 1.0, t));
    colour = framed(vec4(c, inner.a));
}
#elif defined(UI_WAVES)
// Cloth with sea waves (UI_WAVES), whose pattern ui.c draws. The cloth has two soft folds.
uniform lowp sampler2D waves;
void main() {
    float thread = fibre(at * vec2(0.021, 0.004)) - 0.5;
    float fold = sin(at.x / s.x * 4.7 + 0.6) * (0.4 + 0.3 * at.y / s.y);
    vec3 cloth = inner.rgb * (1.0 + 0.16 * fold + 0.18 * thread);
    vec2 unit = vec2(0.5, 1.0) / clamp(s.z * 1.7, 14.0, 96.0);
    cloth += vec3(0.045, 0.055, 0.095) * texture(waves, (at + s.xy) * unit).r;
    colour = framed(vec4(cloth, inner.a));
}
#elif defined(UI_RING)
// A ring (UI_RING).
void main() {
    float r = length(at), half_width = 0.5 * s.y;
    float body = cover(abs(r - s.x + half_width) - half_width);
    float turn = fract(atan(at.x, -at.y) / 6.2831853);
    float part = clamp((s.z - turn) * 6.2831853 * r + 0.5, 0.0, 1.0);
    colour = mix(paint(outer, body), paint(inner, body), part);
}
#elif defined(UI_GLOW)
// A glow (UI_GLOW).
void main() {
    float fade = max(1.0 - length(at / s.xy), 0.0);
    vec4 light = paint(inner, fade * fade * (3.0 - 2.0 * fade));
    colour = vec4(light.rgb, light.a * (1.0 - s.z));
}
#elif defined(UI_LANTERN)
// A lantern (UI_LANTERN): paper over bamboo ribs, brightest at the candle.
void main() {
    vec2 q = at / s.xy;
    float f = pow(abs(q.x), 2.6) + pow(abs(q.y), 2.8);
    float edge = clamp(0.5 + (1.0 - f) * 0.36 * min(s.x, s.y), 0.0, 1.0);
    float bow = q.y * 5.5 + 0.10 * q.x * q.x * sign(q.y);
    float rib = smoothstep(0.36, 0.5, abs(fract(bow) - 0.5));
    float bulb = exp(-2.2 * dot(q - vec2(0.0, 0.12), q - vec2(0.0, 0.12)));
    vec3 lit = inner.rgb * (0.50 + 0.22 * s.z + 0.62 * s.z * bulb);
    lit += vec3(1.0, 0.72, 0.34) * (0.30 * s.z * bulb * bulb);
    lit *= (1.0 - 0.20 * rib) * (1.0 - 0.38 * f * f);
    colour = vec4(lit, 1.0) * (edge * inner.a);
}
#elif defined(UI_FISH)
// A goldfish (UI_FISH), seen from above with the nose to the left: body, fan tail, two fins,
// white patches and eyes.
float fin(vec2 p, vec2 root, float lean, vec2 size) {
    p = vec2(p.x, abs(p.y)) - root;
    p = vec2(p.x * cos(lean) + p.y * sin(lean), p.y * cos(lean) - p.x * sin(lean));
    p = (p - vec2(size.x, 0.0)) / size;
    return (length(p) - 1.0) * size.y;
}
void main() {
    vec2 p = at / s.x;
    float back = max(p.x + 0.5, 0.0);
    p.y -= s.z * 0.085 * back * back;
    float t = clamp((p.x + 0.95) / 1.34, 0.0, 1.0);
    float girth = 0.245 * pow(sin(3.1416 * pow(t, 0.66)), 0.72) * (1.0 - 0.12 * t) + 0.022;
    float body = max(abs(p.y) - girth, max(-0.95 - p.x, p.x - 0.36));
    vec2 k = p - vec2(0.22, 0.0);
    float turn = abs(atan(k.y, k.x));
    float lobe = turn - 0.44;
    float tail = length(k) - 0.74 * exp(-3.0 * lobe * lobe) - 0.015 * cos(turn * 40.0);
    tail = max(tail, (turn - 1.0) * length(k));
    float fins = min(fin(p, vec2(-0.42, 0.16), 0.95, vec2(0.17, 0.075)),
                     fin(p, vec2(-0.02, 0.12), 0.70, vec2(0.10, 0.045)));
    float ray = 0.62 + 0.16 * cos(turn * 34.0) - 0.28 * length(k);
    float rough = 0.16 * (fibre(p * 0.35) - 0.5);
    float white = min(length((p - vec2(-0.10, 0.05)) * vec2(0.8, 1.0)) - 0.17,
                      length(p - vec2(-0.62, -0.12)) - 0.10) + rough;
    float round_ = clamp(abs(p.y) / girth, 0.0, 1.0);
    vec3 skin = mix(outer.rgb, inner.rgb, clamp(0.5 + white * s.x * 0.5, 0.0, 1.0));
    skin *= 1.06 - 0.34 * round_ * round_;
    skin += 0.16 * exp(-60.0 * (p.y + 0.05) * (p.y + 0.05)) * (1.0 - t);
    float eye = length(vec2(p.x, abs(p.y)) - vec2(-0.73, 0.135)) - 0.042;
    colour = over(paint(inner, ray * 1.25 * cover(tail * s.x)),
                  paint(inner, 0.72 * cover(fins * s.x)));
    colour = over(paint(vec4(skin, inner.a), cover(body * s.x * 0.9)), colour);
    colour = over(paint(vec4(0.07, 0.04, 0.05, inner.a), cover(eye * s.x)), colour);
}
#elif defined(UI_POI)
// A poi (UI_POI): the ring, the handle, and the paper, whose torn hole is in the middle.
void main() {
    float r = length(at), width = 0.15 * s.x;
    vec2 q = at / s.x;
    float rough = 0.34 * (fibre(q * 0.23) - 0.5);
    float hole = min(length(q - vec2(0.18, 0.12)), length(q + vec2(0.34, 0.26)) * 1.5);
    float lost = 1.0 - s.y;
    float torn = lost > 0.0 ? 0.62 * sqrt(lost) + 0.48 * lost * lost * lost : -1.0;
    float sheet = cover(r - s.x + width) * cover((torn - hole - rough) * s.x);
    sheet *= step(0.004, s.y);
    vec3 washi = vec3(0.99, 0.96, 0.90) * (0.95 + 0.3 * (fibre(q * 0.31) - 0.5));
    vec2 h = vec2(at.x - at.y, at.x + at.y) * 0.70711;
    float handle = box(h - vec2(0.0, 1.42 * s.x), vec2(0.085, 0.50) * s.x, 0.07 * s.x);
    float body = min(abs(r - s.x + 0.5 * width) - 0.5 * width, handle);
    colour = over(paint(inner, cover(body)), paint(vec4(washi, inner.a * 0.94), sheet));
}
#elif defined(UI_GHOST)
// A ghost poi (UI_GHOST): a poi whose ring is flattened by its slant, and the pale hand that holds
// its handle. The ring is left of and above the middle of the quad.
float rod(vec2 p, vec2 a, vec2 b, float radius) {
    vec2 way = b - a, q = p - a;
    return length(q - way * clamp(dot(q, way) / dot(way, way), 0.0, 1.0)) - radius;
}
void main() {
    vec2 p = at / s.x + vec2(0.55, 1.6);
    vec2 q = vec2(p.x, p.y / s.y);
    float r = length(q), flat_ = mix(s.y, 1.0, abs(q.x) / max(r, 0.01));
    float ring = (abs(r - 0.94) - 0.06) * flat_;
    float handle = rod(p, vec2(0.10, s.y), vec2(0.55, 2.75), 0.085);
    float fist = min(rod(p, vec2(0.62, 2.35), vec2(0.80, 2.75), 0.40),
                     rod(p, vec2(0.85, 2.9), vec2(1.20, 4.1), 0.34));
    float digits = rod(p, vec2(0.60, 2.05), vec2(0.16, 1.62), 0.13);
    for (int i = 0; i < 4; i++) {
        float k = float(i);
        vec2 knuckle = vec2(0.55 + 0.07 * k, 2.12 + 0.22 * k);
        digits = min(digits, rod(p, knuckle, knuckle + vec2(-0.36, 0.10), 0.125));
    }
    float palm = min(fist, digits);
    vec4 skin = vec4(mix(vec3(0.45, 0.30, 0.25), vec3(1.0, 0.93, 0.84),
                         cover((palm + 0.05) * s.x)), 1.0);
    skin.rgb *= 1.0 - 0.30 * cover((abs(digits + 0.01) - 0.025) * s.x);
    vec4 poi = over(paint(vec4(inner.rgb, 1.0), cover(min(ring, handle) * s.x)),
                    paint(vec4(1.0, 0.98, 0.93, 0.42), cover((r - 0.92) * flat_ * s.x)));
    // Under water (`s.z`) the poi has the colour of the water.
    poi.rgb = mix(poi.rgb, vec3(0.25, 0.70, 0.82) * poi.a, 0.45 * s.z);
    colour = over(paint(skin, cover(palm * s.x)), poi) * inner.a;
}
#elif defined(UI_WATER)
// An aquarium (UI_WATER): slow shafts of light from above, water that becomes darker downward,
// and drifting particles.
float shaft(float x, float t) {
    return 0.5 + 0.5 * sin(x * 5.0 + 0.9 * sin(x * 2.3 + t * 0.21) + t * 0.13);
}
void main() {
    vec2 q = at / s.xy;
    vec2 p = at / s.y;
    float depth = 0.5 + 0.5 * q.y;
    vec3 water = mix(inner.rgb, outer.rgb, smoothstep(0.0, 1.0, depth));
    float slant = p.x + 0.42 * p.y;
    float light = shaft(slant, s.w) * shaft(slant * 1.7 + 3.0, s.w * 1.3);
    water += vec3(0.10, 0.17, 0.17) * light * (1.0 - depth) * (1.0 - 0.4 * depth);
    float pool = max(1.0 - dot(q * vec2(0.85, 1.05), q * vec2(0.85, 1.05)), 0.0);
    water += vec3(0.05, 0.10, 0.11) * pool;
    vec2 m = p * 7.0 + vec2(0.06 * s.w, 0.11 * s.w);
    float mote = fibre(floor(m) * 0.37) - 0.62;
    vec2 f = fract(m) - 0.5;
    float spark = step(0.0, mote) * smoothstep(0.08, 0.0, length(f));
    water += vec3(0.18, 0.21, 0.19) * spark;
    colour = vec4(water, 1.0) * (inner.a * cover(box(at, s.xy, s.z)));
}
#endif
