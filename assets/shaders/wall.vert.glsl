// The walls of the tank, a unit box that is scaled to the tank's size.
layout(location = 0) in vec3 corner;  // x, z: -1 to 1. y: -1 at the floor, 0 at the water surface.
out vec3 world;

void main()
{
    world = corner * tank.xyz;
    gl_Position = view_projection * vec4(world, 1.0);
}
