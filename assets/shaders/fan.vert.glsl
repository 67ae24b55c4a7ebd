// A fan, which is one flat quad with a pose. The fragment shader reads the picture of the
// fan.
uniform mat4 pose;   // Pose. The unit of length is the fan's radius. x is to the right, z toward
                     // the player's hand.
out vec2 at;

const vec2 LOW = vec2(-1.15, -1.15);
const vec2 HIGH = vec2(1.15, 2.35);

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    at = corner;
    vec2 place = mix(LOW, HIGH, corner);
    vec3 world = (pose * vec4(place.x, 0.0, place.y, 1.0)).xyz;
    gl_Position = view_projection * vec4(world, 1.0);
}
