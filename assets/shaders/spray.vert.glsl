// A drop of a splash, which faces the viewer, or the ring that it makes on the water.
layout(location = 0) in vec4 place;     // World position. w: radius in m.
layout(location = 1) in vec2 form;      // x: length in widths, or 0 for a ring. y: opacity.
out vec3 corner;                        // xy: position in the square. z: opacity, negative for a
                                        // ring.

void main()
{
    corner.xy = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    bool is_ring = form.x < 0.5;
    corner.z = is_ring ? -form.y : form.y;
    vec3 view = normalize(eye.xyz - place.xyz);
    vec3 side = is_ring ? vec3(1.0, 0.0, 0.0) : normalize(vec3(view.z, 0.0, -view.x));
    vec3 up = is_ring ? vec3(0.0, 0.0, -1.0) : cross(view, side) * form.x;
    vec3 world = place.xyz + place.w * (corner.x * side + corner.y * up);
    gl_Position = view_projection * vec4(world, 1.0);
}
