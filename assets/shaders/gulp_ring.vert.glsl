// The ring that a gulping mouth makes on the surface. The shader draws a square around the point
// where the snout breaks the surface.
layout(location = 0) in vec4 place;      // World position, w: length in m, as in fish.vert.glsl.
layout(location = 1) in vec4 right_phase;
layout(location = 2) in vec4 up_amplitude;
layout(location = 3) in vec2 gulp;
out vec2 from;      // Position relative to the snout, in body lengths.
out float phase;

const float REACH = 0.46; // Half of the square's side, in body lengths.

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    vec3 ahead = -cross(right_phase.xyz, up_amplitude.xyz);
    vec3 nose = place.xyz + 0.47 * place.w * ahead;
    vec2 breaks = nose.xz - ahead.xz * (nose.y / max(ahead.y, 0.2));
    from = corner * REACH;
    phase = gulp.y;
    gl_Position = view_projection * vec4(breaks.x + from.x * place.w, 0.0004,
                                         breaks.y + from.y * place.w, 1.0);
}
