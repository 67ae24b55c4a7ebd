// The wooden rim and the stall's counter around the rim. The coordinates of corners are small
// integers.
layout(location = 0) in vec3 corner;   // x, z: +-1 at the tank's wall, +-2 at the rim's outer edge,
                                       // +-3 far away. y: 0 at the water, 1 at the rim's top, -1 at
                                       // the counter.
layout(location = 1) in vec3 normal;
out vec3 world; // Position in the player's axes (from_world()). KEPT: position in the world.
out vec3 face;
#ifdef KEPT
uniform vec4 to_kept[3]; // Rows of the matrix from the world to the texture of the kept picture.
out vec3 place_in_kept;
#endif

const float RIM_M = 0.032;
const float FAR_M = 1.2;
const float BACK_M = 0.02;  // Breadth of the counter behind the far edge of the rim.
const float STREET_M = 0.8; // Height of the picture of the street.

float step_out(float corner_step, float half_size, float counter_m)
{
    float beyond = max(abs(corner_step) - 1.0, 0.0);
    float out_m = min(beyond, 1.0) * RIM_M + max(beyond - 1.0, 0.0) * counter_m;
    return sign(corner_step) * (half_size + out_m);
}

void main()
{
    vec2 size = abs(from_world(tank.xz));
    world = vec3(step_out(corner.x, size.x, FAR_M), 0.0,
                 step_out(corner.z, size.y, corner.z < 0.0 ? BACK_M : FAR_M));
    world.y = corner.y > 0.5 ? tank.w : corner.y < -0.5 ? -0.012 : -0.02;
    world.y = corner.y > 1.5 ? STREET_M : world.y;
    face = normal;
    vec3 place = vec3(to_world(world.xz), world.y).xzy;
#ifdef KEPT
    world = place;
    vec4 at = vec4(place, 1.0);
    place_in_kept = vec3(dot(to_kept[0], at), dot(to_kept[1], at), dot(to_kept[2], at));
#endif
    gl_Position = view_projection * vec4(place, 1.0);
}
