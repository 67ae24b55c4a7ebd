// The water surface as a flat quad. Only the slopes contain the waves.
layout(location = 0) in vec3 corner;
invariant gl_Position; // The strips join the rest of the water without a gap.
#ifdef MIRROR
out vec2 grid;   // Coordinates in the texture of the slopes.
out vec2 shaded; // Coordinates in the texture of the shades.
out vec2 place;  // Position in the player's axes.
out vec3 view;   // Direction to the camera in the player's axes, not normalized.
out vec2 ripple; // Phases of the small waves.
#else
out vec3 world;
#endif

const float EDGE_M = 0.008; // Width of the strips at the walls, which the variant EDGE draws.

void main()
{
#ifdef MIRROR
    // The picture of the reflections extends beyond the water, because the texels at its edge are
    // interpolated.
    vec3 world = vec3(corner.x * tank.x, 0.0, corner.z * tank.z) * 1.02;
    grid = corner.xz * 0.51 + 0.5;
    shaded = world.xz * shade_map.xy + 0.5;
    place = from_world(world.xz);
    view = vec3(from_world(eye.xz) - place, eye.y).xzy;
    // The waves are as wide as a few texels of this picture at any distance of the camera.
    vec2 near = place * (260.0 / (eye.y + 0.1));
    ripple = vec2(dot(near, vec2(0.30, 0.95)), dot(near, vec2(-0.25, 0.60))) - eye.w * vec2(5.0, 3.7);
#else
    world = vec3(corner.x * tank.x, 0.0, corner.z * tank.z);
    // Corners inside the walls have the coordinates +-0.5.
    vec2 inward = step(abs(corner.xz), vec2(0.75));
    world.xz = sign(corner.xz) * (tank.xz - EDGE_M * inward);
#endif
    gl_Position = view_projection * vec4(world, 1.0);
}
