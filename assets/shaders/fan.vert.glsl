// A fan, which is one flat strip of triangles with a pose: an octagon around the paper, then a
// rectangle around the handle. The fragment shader reads the picture of the fan.
uniform mat4 pose;   // Pose. The unit of length is the fan's radius. x is to the right, z toward
                     // the player's hand.
out vec2 at;

const vec2 LOW = vec2(-1.15, -1.15);
const vec2 HIGH = vec2(1.15, 2.35);

void main()
{
    vec2 place = disc_and_handle(gl_VertexID, 1.03, 0.10, 2.28);
    at = (place - LOW) / (HIGH - LOW);
    vec3 world = (pose * vec4(place.x, 0.0, place.y, 1.0)).xyz;
    gl_Position = view_projection * vec4(world, 1.0);
}
