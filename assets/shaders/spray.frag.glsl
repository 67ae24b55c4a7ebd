// The variant SCRAP draws a scrap of wet paper with a torn edge. The other variant draws drops and
// rings. A drop is transparent, with a bright lower rim and a reflection of the lamp. A ring is one
// wave crest, and its slopes toward the lamp are bright.
in vec3 corner;     // As in spray.vert.glsl.
in vec3 paper;
out vec4 color;

void main()
{
    float r = length(corner.xy);
#ifdef SCRAP
    float torn = 0.78 + 0.16 * sin(corner.x * 7.0 + corner.y * 3.0) + 0.10 * sin(corner.y * 13.0);
    float cover = clamp((torn - r) / fwidth(r), 0.0, 1.0) * corner.z;
    color = vec4(paper * (0.9 + 0.1 * corner.x), 1.0) * (0.72 * cover);
#else
    float inside = clamp((1.0 - r) / fwidth(r), 0.0, 1.0) * abs(corner.z);
    float rim = smoothstep(0.3, 0.95, r) * (0.55 - 0.45 * corner.y);
    float lamp = max(1.0 - 2.6 * length(corner.xy - vec2(-0.25, 0.45)), 0.0);
    vec4 drop = vec4(vec3(0.80, 0.96, 1.0) * (0.30 + 0.6 * rim) + lamp, 0.40 + 0.4 * rim);
    float x = (r - 0.72) * 4.0;
    float crest = -x * max(1.0 - x * x, 0.0) * dot(corner.xy, vec2(0.447, 0.894)) * 1.6;
    float light = max(crest, 0.0);
    vec4 ring = vec4(vec3(0.95, 1.0, 1.0) * light, light * 0.6 + max(-crest, 0.0) * 0.6);
    color = (corner.z < 0.0 ? ring : drop) * inside;
#endif
}
