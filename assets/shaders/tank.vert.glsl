// Floor and walls of a unit box, scaled to the tank.
layout(location = 0) in vec3 corner;  // x, z in -1 .. 1; y -1 at the floor, 0 at the surface.
layout(location = 1) in vec3 normal;
out vec3 world;

void main()
{
    world = corner * tank.xyz;
    gl_Position = view_projection * vec4(world, 1.0);
}
