// The water surface as a flat quad. Only the slopes contain the waves.
layout(location = 0) in vec3 corner;
out vec3 world;

void main()
{
    world = vec3(corner.x * tank.x, 0.0, corner.z * tank.z);
#ifdef MIRROR
    world *= 1.02; // The picture of the reflections extends beyond the water, because the texels at
                   // its edge are interpolated.
#endif
    gl_Position = view_projection * vec4(world, 1.0);
}
