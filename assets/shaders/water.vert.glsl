// The water surface as a flat quad. Only the slopes contain the waves.
layout(location = 0) in vec3 corner;
out vec3 world;

void main()
{
    world = vec3(corner.x * tank.x, 0.0, corner.z * tank.z);
    gl_Position = view_projection * vec4(world, 1.0);
}
