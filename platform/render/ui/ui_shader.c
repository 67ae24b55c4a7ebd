/* ui_shader.c -- source code of the user interface's shaders.
 *
 * Every shape is defined by its signed distance in pixels, so that each edge is smoothed over
 * exactly one pixel. The output has premultiplied alpha. Additive light has alpha 0. Names in the
 * shaders: `at` is (u, v) of struct ui_vertex, `s` is `shape`, `inner` is `fill`, and `outer` is
 * `line`. */
#include "platform/render/ui/ui.h"

/* clang-format off */
const char *const ui_vertex_source =
    "#version 300 es\n"
    "layout(location = 0) in vec2 position;\n"
    "layout(location = 1) in vec2 uv;\n"
    "layout(location = 2) in vec4 shape;\n"
    "layout(location = 3) in vec4 fill;\n"
    "layout(location = 4) in vec4 line;\n"
    "uniform vec2 to_clip;\n" /* Factors from pixels to clip space: 2 / width and -2 / height. */
    "uniform mat2 turn;\n"    /* Rotation and scale of the picture on the screen. */
    "uniform vec2 move;\n"
    "out highp vec2 at;\n"
    "flat out highp vec4 s;\n"
    "flat out mediump vec4 inner, outer;\n"
    "void main() {\n"
    "    gl_Position = vec4(turn * (position * to_clip + vec2(-1.0, 1.0)) + move, 0.0, 1.0);\n"
    "    at = uv;\n"
    "    s = shape;\n"
    "    inner = fill;\n"
    "    outer = line;\n"
    "}\n";

const char *const ui_fragment_head =
    "precision highp float;\n"
    "uniform lowp sampler2DArray font;\n"
    "uniform sampler2D paper;\n"
    "in highp vec2 at;\n"
    "flat in highp vec4 s;\n"
    "flat in mediump vec4 inner, outer;\n"
    "out vec4 colour;\n"
    "float cover(float d) { return clamp(0.5 - d, 0.0, 1.0); }\n"
    "vec4 over(vec4 top, vec4 under) { return top + under * (1.0 - top.a); }\n"
    "vec4 paint(vec4 c, float amount) { return vec4(c.rgb, 1.0) * (c.a * amount); }\n"
    "float fibre(vec2 p) { return texture(paper, p).r; }\n"
    "float box(vec2 p, vec2 half_size, float radius) {\n"
    "    vec2 d = abs(p) - half_size + radius;\n"
    "    return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0) - radius;\n"
    "}\n"
    "vec4 framed(vec4 body) {\n"
    "    float d = box(at, s.xy, s.z);\n"
    "    float edge = s.w > 0.0 ? 1.0 - cover(d + s.w) : 0.0;\n"
    "    return over(paint(outer, edge), paint(body, 1.0)) * cover(d);\n"
    "}\n";

#define GLYPH                                                                                      \
    "void main() {\n"                                                                              \
    "    float page = floor(at.y / FONT_SIZE.y);\n"                                                \
    "    vec3 place = vec3(at / FONT_SIZE - vec2(0.0, page), page);\n"                             \
    "    float d = (texture(font, place).r * 255.0 - FONT_EDGE) / FONT_STEP + s.x;\n"              \
    "    if (outer.a == 0.0) {\n"                                                                  \
    "        colour = paint(inner, cover(-d * s.w));\n"                                            \
    "        return;\n"                                                                            \
    "    }\n"                                                                                      \
    "    d += s.y;\n"                                                                              \
    "    float soft = s.z > 0.0 ? smoothstep(-s.z, 0.0, d) : 0.0;\n"                               \
    "    colour = paint(outer, max(cover(-d * s.w), soft * soft * 0.8));\n"                        \
    "}\n"

#define PANEL "void main() { colour = framed(inner); }\n"

/* Fragment shader of paper (UI_WASHI). Paper with a border also has a second, finer line inside the
 * border. */
#define WASHI                                                                                      \
    "void main() {\n"                                                                              \
    "    float f = fibre(at * 0.0034) - 0.5;\n"                                                    \
    "    vec2 q = at / s.xy;\n"                                                                    \
    "    vec4 body = vec4(inner.rgb * (1.0 + 0.13 * f - 0.06 * dot(q, q)), inner.a);\n"            \
    "    float thread = abs(box(at, s.xy, s.z) + 3.6 * s.w) - 0.28 * s.w;\n"                       \
    "    body.rgb = mix(body.rgb, outer.rgb, 0.7 * cover(thread) * step(1.0, s.w));\n"             \
    "    colour = framed(body);\n"                                                                 \
    "}\n"

/* Fragment shader of planed cedar (UI_WOOD), with soft bands of grain along the tag and a bevel
 * with a bright upper edge. */
#define WOOD                                                                                       \
    "void main() {\n"                                                                              \
    "    vec2 p = at / s.y;\n"                                                                     \
    "    float slow = fibre(vec2(p.x * 0.09 + inner.r, p.y * 0.035));\n"                           \
    "    float year = fract((p.x + 0.16 * p.y * p.y * p.x) * 5.0 + 5.0 * slow);\n"                 \
    "    float fine = fibre(vec2(p.x * 2.6, p.y * 0.13)) - 0.5;\n"                                 \
    "    float d = box(at, s.xy, s.z);\n"                                                          \
    "    float bevel = smoothstep(-2.2 * s.w - 3.0, -s.w, d);\n"                                   \
    "    float grain = 0.10 * year * year * (1.0 - smoothstep(0.86, 1.0, year));\n"                \
    "    vec3 body = inner.rgb * (1.03 - grain * vec3(0.8, 1.1, 1.4) + 0.20 * fine);\n"            \
    "    body *= (1.0 - 0.06 * p.y) * (1.0 - 0.22 * bevel * (p.y + 0.3 * at.x / s.x));\n"          \
    "    colour = framed(vec4(body, inner.a));\n"                                                  \
    "}\n"

/* Fragment shader of the stress colours (UI_HEAT). The colours equal those in
 * assets/shaders/poi_paper.frag.glsl. */
#define HEAT                                                                                       \
    "void main() {\n"                                                                              \
    "    float t = clamp(at.x / s.x * 0.5 + 0.5, 0.0, 1.0);\n"                                     \
    "    vec3 c = mix(vec3(0.12, 0.18, 0.62), vec3(0.20, 0.66, 0.30),\n"                           \
    "                 smoothstep(0.05, 0.36, t));\n"                                               \
    "    c = mix(c, vec3(0.98, 0.82, 0.16), smoothstep(0.36, 0.66, t));\n"                         \
    "    c = mix(c, vec3(1.0, 1.0, 0.94), smoothstep(0.70, 1.0, t));\n"                            \
    "    colour = framed(vec4(c, inner.a));\n"                                                     \
    "}\n"

/* Fragment shader of cloth with sea waves (UI_WAVES). Each wave consists of three arcs, and each
 * row of waves hides a part of the row above. The cloth has two soft folds. */
#define WAVES                                                                                      \
    "float arcs(vec2 p) {\n"                                                                       \
    "    float row = floor(p.y * 2.0);\n"                                                          \
    "    float result = 0.0;\n"                                                                    \
    "    for (int i = 0; i < 3; i++) {\n"                                                          \
    "        float r = row + float(i);\n"                                                          \
    "        vec2 c = vec2(mod(p.x + mod(r, 2.0), 2.0) - 1.0, p.y - 0.5 * r - 1.0);\n"             \
    "        float d = length(c);\n"                                                               \
    "        if (d < 1.0) {\n"                                                                     \
    "            result = smoothstep(0.10, 0.22, 0.5 - abs(fract(d * 3.0) - 0.5));\n"              \
    "        }\n"                                                                                  \
    "    }\n"                                                                                      \
    "    return 1.0 - result;\n"                                                                   \
    "}\n"                                                                                          \
    "void main() {\n"                                                                              \
    "    float thread = fibre(at * vec2(0.021, 0.004)) - 0.5;\n"                                   \
    "    float fold = sin(at.x / s.x * 4.7 + 0.6) * (0.4 + 0.3 * at.y / s.y);\n"                   \
    "    vec3 cloth = inner.rgb * (1.0 + 0.16 * fold + 0.18 * thread);\n"                          \
    "    cloth += vec3(0.045, 0.055, 0.095) * arcs((at + s.xy) / clamp(s.z * 1.7, 14.0, 96.0));\n" \
    "    colour = framed(vec4(cloth, inner.a));\n"                                                 \
    "}\n"

#define RING                                                                                       \
    "void main() {\n"                                                                              \
    "    float r = length(at), half_width = 0.5 * s.y;\n"                                          \
    "    float body = cover(abs(r - s.x + half_width) - half_width);\n"                            \
    "    float turn = fract(atan(at.x, -at.y) / 6.2831853);\n"                                     \
    "    float part = clamp((s.z - turn) * 6.2831853 * r + 0.5, 0.0, 1.0);\n"                      \
    "    colour = mix(paint(outer, body), paint(inner, body), part);\n"                            \
    "}\n"

#define GLOW                                                                                       \
    "void main() {\n"                                                                              \
    "    float fade = max(1.0 - length(at / s.xy), 0.0);\n"                                        \
    "    vec4 light = paint(inner, fade * fade * (3.0 - 2.0 * fade));\n"                           \
    "    colour = vec4(light.rgb, light.a * (1.0 - s.z));\n"                                       \
    "}\n"

/* Fragment shader of a lantern (UI_LANTERN): paper over bamboo ribs, brightest at the candle. */
#define LANTERN                                                                                    \
    "void main() {\n"                                                                              \
    "    vec2 q = at / s.xy;\n"                                                                    \
    "    float f = pow(abs(q.x), 2.6) + pow(abs(q.y), 2.8);\n"                                     \
    "    float edge = clamp(0.5 + (1.0 - f) * 0.36 * min(s.x, s.y), 0.0, 1.0);\n"                  \
    "    float bow = q.y * 5.5 + 0.10 * q.x * q.x * sign(q.y);\n"                                  \
    "    float rib = smoothstep(0.36, 0.5, abs(fract(bow) - 0.5));\n"                              \
    "    float bulb = exp(-2.2 * dot(q - vec2(0.0, 0.12), q - vec2(0.0, 0.12)));\n"                \
    "    vec3 lit = inner.rgb * (0.50 + 0.22 * s.z + 0.62 * s.z * bulb);\n"                        \
    "    lit += vec3(1.0, 0.72, 0.34) * (0.30 * s.z * bulb * bulb);\n"                             \
    "    lit *= (1.0 - 0.20 * rib) * (1.0 - 0.38 * f * f);\n"                                      \
    "    colour = vec4(lit, 1.0) * (edge * inner.a);\n"                                            \
    "}\n"

/* Fragment shader of a goldfish (UI_FISH), seen from above with the nose to the left: body, fan
 * tail, two fins, white patches and eyes. */
#define FISH                                                                                       \
    "float fin(vec2 p, vec2 root, float lean, vec2 size) {\n"                                      \
    "    p = vec2(p.x, abs(p.y)) - root;\n"                                                        \
    "    p = vec2(p.x * cos(lean) + p.y * sin(lean), p.y * cos(lean) - p.x * sin(lean));\n"        \
    "    p = (p - vec2(size.x, 0.0)) / size;\n"                                                    \
    "    return (length(p) - 1.0) * size.y;\n"                                                     \
    "}\n"                                                                                          \
    "void main() {\n"                                                                              \
    "    vec2 p = at / s.x;\n"                                                                     \
    "    float back = max(p.x + 0.5, 0.0);\n"                                                      \
    "    p.y -= s.z * 0.085 * back * back;\n"                                                      \
    "    float t = clamp((p.x + 0.95) / 1.34, 0.0, 1.0);\n"                                        \
    "    float girth = 0.245 * pow(sin(3.1416 * pow(t, 0.66)), 0.72) * (1.0 - 0.12 * t) + 0.022;\n"\
    "    float body = max(abs(p.y) - girth, max(-0.95 - p.x, p.x - 0.36));\n"                      \
    "    vec2 k = p - vec2(0.22, 0.0);\n"                                                          \
    "    float turn = abs(atan(k.y, k.x));\n"                                                      \
    "    float lobe = turn - 0.44;\n"                                                              \
    "    float tail = length(k) - 0.74 * exp(-3.0 * lobe * lobe) - 0.015 * cos(turn * 40.0);\n"    \
    "    tail = max(tail, (turn - 1.0) * length(k));\n"                                            \
    "    float fins = min(fin(p, vec2(-0.42, 0.16), 0.95, vec2(0.17, 0.075)),\n"                   \
    "                     fin(p, vec2(-0.02, 0.12), 0.70, vec2(0.10, 0.045)));\n"                  \
    "    float ray = 0.62 + 0.16 * cos(turn * 34.0) - 0.28 * length(k);\n"                         \
    "    float rough = 0.16 * (fibre(p * 0.35) - 0.5);\n"                                          \
    "    float white = min(length((p - vec2(-0.10, 0.05)) * vec2(0.8, 1.0)) - 0.17,\n"             \
    "                      length(p - vec2(-0.62, -0.12)) - 0.10) + rough;\n"                      \
    "    float round_ = clamp(abs(p.y) / girth, 0.0, 1.0);\n"                                      \
    "    vec3 skin = mix(outer.rgb, inner.rgb, clamp(0.5 + white * s.x * 0.5, 0.0, 1.0));\n"       \
    "    skin *= 1.06 - 0.34 * round_ * round_;\n"                                                 \
    "    skin += 0.16 * exp(-60.0 * (p.y + 0.05) * (p.y + 0.05)) * (1.0 - t);\n"                   \
    "    float eye = length(vec2(p.x, abs(p.y)) - vec2(-0.73, 0.135)) - 0.042;\n"                  \
    "    colour = over(paint(inner, ray * 1.25 * cover(tail * s.x)),\n"                            \
    "                  paint(inner, 0.72 * cover(fins * s.x)));\n"                                 \
    "    colour = over(paint(vec4(skin, inner.a), cover(body * s.x * 0.9)), colour);\n"            \
    "    colour = over(paint(vec4(0.07, 0.04, 0.05, inner.a), cover(eye * s.x)), colour);\n"       \
    "}\n"

/* Fragment shader of a poi (UI_POI): the ring, the handle, and the paper, whose torn hole is in the
 * middle. */
#define POI                                                                                        \
    "void main() {\n"                                                                              \
    "    float r = length(at), width = 0.15 * s.x;\n"                                              \
    "    vec2 q = at / s.x;\n"                                                                     \
    "    float rough = 0.34 * (fibre(q * 0.23) - 0.5);\n"                                          \
    "    float hole = min(length(q - vec2(0.18, 0.12)), length(q + vec2(0.34, 0.26)) * 1.5);\n"    \
    "    float lost = 1.0 - s.y;\n"                                                                \
    "    float torn = lost > 0.0 ? 0.62 * sqrt(lost) + 0.48 * lost * lost * lost : -1.0;\n"        \
    "    float sheet = cover(r - s.x + width) * cover((torn - hole - rough) * s.x);\n"             \
    "    sheet *= step(0.004, s.y);\n"                                                             \
    "    vec3 washi = vec3(0.99, 0.96, 0.90) * (0.95 + 0.3 * (fibre(q * 0.31) - 0.5));\n"          \
    "    vec2 h = vec2(at.x - at.y, at.x + at.y) * 0.70711;\n"                                     \
    "    float handle = box(h - vec2(0.0, 1.42 * s.x), vec2(0.085, 0.50) * s.x, 0.07 * s.x);\n"    \
    "    float body = min(abs(r - s.x + 0.5 * width) - 0.5 * width, handle);\n"                    \
    "    colour = over(paint(inner, cover(body)), paint(vec4(washi, inner.a * 0.94), sheet));\n"   \
    "}\n"

/* Fragment shader of an aquarium (UI_WATER): slow shafts of light from above, water that becomes
 * darker downward, and drifting particles. */
#define WATER                                                                                      \
    "float shaft(float x, float t) {\n"                                                            \
    "    return 0.5 + 0.5 * sin(x * 5.0 + 0.9 * sin(x * 2.3 + t * 0.21) + t * 0.13);\n"            \
    "}\n"                                                                                          \
    "void main() {\n"                                                                              \
    "    vec2 q = at / s.xy;\n"                                                                    \
    "    vec2 p = at / s.y;\n"                                                                     \
    "    float depth = 0.5 + 0.5 * q.y;\n"                                                         \
    "    vec3 water = mix(inner.rgb, outer.rgb, smoothstep(0.0, 1.0, depth));\n"                   \
    "    float slant = p.x + 0.42 * p.y;\n"                                                        \
    "    float light = shaft(slant, s.w) * shaft(slant * 1.7 + 3.0, s.w * 1.3);\n"                 \
    "    water += vec3(0.10, 0.17, 0.17) * light * (1.0 - depth) * (1.0 - 0.4 * depth);\n"         \
    "    float pool = max(1.0 - dot(q * vec2(0.85, 1.05), q * vec2(0.85, 1.05)), 0.0);\n"          \
    "    water += vec3(0.05, 0.10, 0.11) * pool;\n"                                                \
    "    vec2 m = p * 7.0 + vec2(0.06 * s.w, 0.11 * s.w);\n"                                       \
    "    float mote = fibre(floor(m) * 0.37) - 0.62;\n"                                            \
    "    vec2 f = fract(m) - 0.5;\n"                                                               \
    "    float spark = step(0.0, mote) * smoothstep(0.08, 0.0, length(f));\n"                      \
    "    water += vec3(0.18, 0.21, 0.19) * spark;\n"                                               \
    "    colour = vec4(water, 1.0) * (inner.a * cover(box(at, s.xy, s.z)));\n"                     \
    "}\n"
/* clang-format on */

const char *const ui_fragment_sources[UI_KIND_COUNT] = {
    [UI_GLYPH] = GLYPH, [UI_PANEL] = PANEL, [UI_WASHI] = WASHI,     [UI_WAVES] = WAVES,
    [UI_RING] = RING,   [UI_GLOW] = GLOW,   [UI_LANTERN] = LANTERN, [UI_FISH] = FISH,
    [UI_POI] = POI,     [UI_WOOD] = WOOD,   [UI_HEAT] = HEAT,       [UI_WATER] = WATER,
};
