// Ring and handle of a poi, a plastic solid with a pose. The light that changes little between two
// vertices is computed here. CAP draws a disc over paper and ring, which only writes depth.
layout(location = 0) in vec3 position;  // Position in ring radii.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // x: position around the ring, from 0 to 1.
uniform mat4 pose;
uniform vec4 paint;                     // w: number of white marks that distinguish the player.
out vec3 face;
out vec3 view;      // Direction to the viewer.
out vec3 middle;    // Direction halfway between the viewer and the lamps.
out vec3 left;      // Fraction of the light that passes through the water.
out vec4 mark;      // x: a mark lies where the fraction of x is near 0.5. y: half of the width of a
                    // mark. z: brightness below the fans. w: height above the water surface in m.
out float foam;     // Strength of the water line, which a level ring almost lacks.

const float RING_END = 1.19;            // Coordinate z at which the handle leaves the ring.

void main()
{
#ifdef CAP
    gl_Position = view_projection * (pose * vec4(1.15 * position.x, 0.0, 1.15 * position.y, 1.0));
    gl_Position.z = -gl_Position.w; // On the near plane, so that nothing covers the disc.
#else
    vec3 world = (pose * vec4(position, 1.0)).xyz;
    face = mat3(pose) * normal;
    view = normalize(eye.xyz - world);
    middle = normalize(view + LAMP_DIRECTION);
    left = water_passes(-world.y * 1.2);
    // The marks of the ring are evenly spaced. The marks of the handle are 0.3 ring radii apart.
    bool is_ring = position.z < RING_END;
    mark.x = is_ring ? (surface.x + 0.25) * paint.w : clamp((position.z - 2.0) / 0.30, 0.0, paint.w);
    mark.y = paint.w < 0.5 ? -1.0 : is_ring ? 0.05 * paint.w : 0.24;
    mark.z = 1.0 - 0.7 * shade_above(world);
    // The ring is darker and bluer in the water.
    float sunk = clamp(-world.y * 400.0, 0.0, 1.0);
    left *= 1.0 - sunk * vec3(0.22, 0.10, 0.05);
    mark.z *= 1.0 - 0.18 * sunk;
    mark.w = world.y;
    foam = clamp(length(pose[1].xz) / length(pose[0].xyz) * 5.0 - 0.75, 0.15, 1.0);
    gl_Position = view_projection * vec4(world, 1.0);
#endif
}
