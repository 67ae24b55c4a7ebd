// The water surface as a flat quad. Only the slopes contain the waves.
layout(location = 0) in vec3 corner;
invariant gl_Position; // The strips join the rest of the water without a gap.
out vec3 world;
#ifdef MIRROR
out vec2 grid;  // Coordinates in the texture of the slopes.
#endif

const float EDGE_M = 0.008; // Width of the strips at the walls, which the variant EDGE draws.

void main()
{
    world = vec3(corner.x * tank.x, 0.0, corner.z * tank.z);
#ifdef MIRROR
    world *= 1.02; // The picture of the reflections extends beyond the water, because the texels at
                   // its edge are interpolated.
    grid = corner.xz * 0.51 + 0.5;
#else
    // Corners inside the walls have the coordinates +-0.5.
    vec2 inward = step(abs(corner.xz), vec2(0.75));
    world.xz = sign(corner.xz) * (tank.xz - EDGE_M * inward);
#endif
    gl_Position = view_projection * vec4(world, 1.0);
}
