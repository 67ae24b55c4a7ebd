// The shadow of a fish, a soft ellipse on the floor. The shadow of a higher fish is softer and
// farther to the side.
layout(location = 0) in vec4 place;      // World position. w: length in m.
layout(location = 1) in vec4 right_phase;
layout(location = 2) in vec4 up_amplitude;
out vec2 lens;
out float strength;

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
#ifdef IN_BOWL
    float height = 0.012; // The floor of a bowl is about this far below its fish.
#else
    float height = max(place.y + tank.y, 0.0);
#endif
    float soft = 0.003 + height * 0.075;
    float half_length = place.w * 0.40 + soft * 0.8;
    float half_breadth = place.w * 0.115 + soft * 0.6;
    vec2 right = normalize(right_phase.xz + vec2(1e-5, 0.0));
    vec2 back = vec2(-right.y, right.x);
    // The body's centre is in front of the middle of the fish, because the rear part is only the
    // thin tail.
    vec2 local = corner * 1.35 * vec2(half_breadth, half_length) - vec2(0.0, place.w * 0.07);
    vec2 at = place.xz + right * local.x + back * local.y - shadow.zw * height;
    lens = corner * 1.35;
    strength = min(place.w * 0.115 / half_breadth * 1.35, 0.85);
#ifdef IN_BOWL
    gl_Position = view_projection * vec4(at.x, place.y - height, at.y, 1.0);
    // The shadow has the depth of a place above the fish, so that the curved floor of the bowl does
    // not hide the shadow, and a hand above the bowl does.
    vec4 above = view_projection * vec4(at.x, place.y + 0.012, at.y, 1.0);
    gl_Position.z = above.z / above.w * gl_Position.w;
#else
    gl_Position = vec4(at * shadow.xy, 0.0, 1.0);
#endif
}
