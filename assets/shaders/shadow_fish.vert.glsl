// A fish's shadow: one soft ellipse on the floor, softer and farther aside the higher the fish
// swims.
layout(location = 0) in vec4 place;      // World position; w: length, m.
layout(location = 1) in vec4 right_phase;
layout(location = 2) in vec4 up_amplitude;
out vec2 lens;
out float strength;

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    float height = max(place.y + tank.y, 0.0);
    float soft = 0.003 + height * 0.075;
    float half_length = place.w * 0.40 + soft * 0.8;
    float half_breadth = place.w * 0.115 + soft * 0.6;
    vec2 right = normalize(right_phase.xz + vec2(1e-5, 0.0));
    vec2 back = vec2(-right.y, right.x);
    // The body's centre lies in front of the box's centre, because only a thin tail is behind it.
    vec2 local = corner * 1.35 * vec2(half_breadth, half_length) - vec2(0.0, place.w * 0.07);
    vec2 at = place.xz + right * local.x + back * local.y - shadow.zw * height;
    lens = corner * 1.35;
    strength = min(place.w * 0.115 / half_breadth * 1.35, 0.85);
    gl_Position = vec4(at * shadow.xy, 0.0, 1.0);
}
