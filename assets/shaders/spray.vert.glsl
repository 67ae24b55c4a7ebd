// A drop of a splash, which faces the viewer, or the ring that it makes on the water. SCRAP draws a
// scrap of paper below the water.
layout(location = 0) in vec4 place;     // World position. w: radius in m.
layout(location = 1) in vec2 form;      // x: length in widths, or 0 for a ring. Angle of a scrap.
                                        // y: opacity.
out vec3 corner;                        // xy: position in the square. z: opacity, negative for a
                                        // ring.
out vec3 paper;                         // SCRAP: light on the paper that passes through the water.
                                        // Otherwise x: sharpness of a ring's crest. y: phase of
                                        // the gaps in the ring.

void main()
{
    corner.xy = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
#ifdef SCRAP
    float c = cos(form.x);
    float s = sin(form.x);
    corner.z = form.y;
    paper = water_passes(-place.y * 1.2);
    paper = mix(WATER_COLOR, vec3(0.86, 0.90, 0.90) * min(lamp_light(place.xyz), 1.0), paper);
    vec3 side = vec3(c, 0.35 * sin(1.7 * form.x), s);
    vec3 up = vec3(-s, 0.45 * cos(2.3 * form.x), c);
#else
    // The crest of a ring with a radius above 6 cm keeps its width in m.
    paper = vec3(max(6.0, 95.0 * place.w), 700.0 * (place.x + place.z), 0.0);
    bool is_ring = form.x < 0.5;
    corner.z = is_ring ? -form.y : form.y;
    vec3 view = normalize(eye.xyz - place.xyz);
    vec3 side = is_ring ? vec3(1.0, 0.0, 0.0) : normalize(vec3(view.z, 0.0, -view.x));
    vec3 up = is_ring ? vec3(0.0, 0.0, -1.0) : cross(view, side) * form.x;
#endif
    vec3 world = place.xyz + place.w * (corner.x * side + corner.y * up);
    gl_Position = view_projection * vec4(world, 1.0);
}
