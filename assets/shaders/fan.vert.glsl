// A fan: one flat quad, transformed by its pose. The fragment shader draws the whole picture.
uniform mat4 pose;   // Unit: the fan's radius. x right, z toward the hand.
out vec2 at;

const vec2 LOW = vec2(-1.15, -1.15);
const vec2 HIGH = vec2(1.15, 2.35);

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    at = mix(LOW, HIGH, corner);
    vec3 world = (pose * vec4(at.x, 0.0, at.y, 1.0)).xyz;
    gl_Position = view_projection * vec4(world, 1.0);
}
