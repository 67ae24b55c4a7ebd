// The wooden rim and the stall's counter around it. Corners are in steps relative to the tank's
// walls.
layout(location = 0) in vec3 corner;   // x, z: +-1 wall, +-2 rim's outer edge, +-3 far away; y: 0
                                       // water, 1 rim, -1 counter.
layout(location = 1) in vec3 normal;
out vec3 world;
out vec3 face;

const float RIM_M = 0.032;
const float FAR_M = 1.2;

float step_out(float corner_step, float half_size)
{
    float beyond = max(abs(corner_step) - 1.0, 0.0);
    float out_m = min(beyond, 1.0) * RIM_M + max(beyond - 1.0, 0.0) * FAR_M;
    return sign(corner_step) * (half_size + out_m);
}

void main()
{
    world = vec3(step_out(corner.x, tank.x), 0.0, step_out(corner.z, tank.z));
    world.y = corner.y > 0.5 ? tank.w : corner.y < -0.5 ? -0.012 : -0.02;
    face = normal;
    gl_Position = view_projection * vec4(world, 1.0);
}
