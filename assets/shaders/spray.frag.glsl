// The variant SCRAP draws a scrap of wet paper with a torn edge. The other variant draws drops and
// rings. A drop is transparent, with a bright lower end and a reflection of the lamp. A ring is one
// wave crest, and its slopes toward the lamp are bright.
in vec3 corner;     // As in spray.vert.glsl.
in vec3 paper;      // Not SCRAP: x is the sharpness of a ring's crest. y is the phase of
                    // its gaps.
out vec4 color;

void main()
{
#ifdef SCRAP
    float r = length(corner.xy);
    float torn = 0.78 + 0.16 * sin(corner.x * 7.0 + corner.y * 3.0) + 0.10 * sin(corner.y * 13.0);
    float cover = clamp((torn - r) / fwidth(r), 0.0, 1.0) * corner.z;
    color = vec4(paper * (0.9 + 0.1 * corner.x), 1.0) * (0.72 * cover);
#else
    // A drop is narrow at its upper end. Its lower end gathers the light.
    float narrow = corner.z < 0.0 ? 1.0 : 1.0 + 0.3 * max(corner.y, 0.0);
    float r = length(vec2(corner.x * narrow, corner.y));
    float inside = clamp((1.0 - r) / fwidth(r), 0.0, 1.0) * abs(corner.z);
    float rim = smoothstep(0.35, 0.95, r);
    float low = max(-0.2 - corner.y, 0.0) * (1.25 - r);
    float lamp = max(1.0 - 3.0 * length(corner.xy - vec2(-0.2, 0.35)), 0.0);
    vec4 drop = vec4(vec3(0.80, 0.96, 1.0) * (0.16 + 0.34 * rim + 1.9 * low) + lamp, 0.24 + 0.30 * rim + low);
    float x = (r - 0.72) * paper.x;
    float broken = 0.55 + 0.75 * sin(corner.x * 3.1 + paper.y) * sin(corner.y * 3.7 + 1.7 * paper.y);
    float crest = -x * max(1.0 - x * x, 0.0) * dot(corner.xy, vec2(0.447, 0.894)) * 1.25 * max(broken, 0.0);
    float light = max(crest, 0.0);
    vec4 ring = vec4(vec3(0.95, 1.0, 1.0) * light, light * 0.6 + max(-crest, 0.0) * 0.6);
    color = (corner.z < 0.0 ? ring : drop) * inside;
#endif
}
