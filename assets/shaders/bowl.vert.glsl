// The bowl, a surface of revolution. Units are the radius of its mouth and its depth. The light
// that changes little between two vertices is computed here.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // y: 0 at the bottom, 1 at the lip.
uniform vec4 mouth;                     // Centre of the mouth. w: radius of the mouth.
uniform vec4 form;                      // x: depth of the bowl in m. y: height, and z: radius, of
                                        // the water in the bowl. w: 1 if the bowl is white.
uniform mat3 heel;                      // Tilt of the bowl. The water in the bowl stays level.
uniform vec4 paint;                     // Colour. w: number of white gaps in the bowl's coloured
                                        // band.
const float RING_M = 0.0022; // Half the height of the bright ring of water around the bowl.

out vec3 shell; // y: as surface.y. z: above 0.5 in a gap of the band.
out vec4 light; // For the shell: x: brightness. y: cosine of the angle between the normal and the
                // direction halfway to the lamps. z: cosine of the angle between the normal and the
                // direction to the viewer. w: brightness of the lamps. For the water: xy: change of
                // z for each unit of slope. z: as y of the shell. w: reflection of the sky.
out vec3 left;  // For the shell: fraction of the light that passes through the water.
out vec3 grid;  // For the shell: xy: coordinates in the texture of the caustics. z: depth below the
                // water in the bowl, in 0.06 depths of the bowl. For the outside: x: height above
                // the tank's water in RING_M. For the water: xy: position in mouth radii. z: light
                // of the lamps.

const float CAP_M = 0.001;  // Height of the cap above the tank's water surface.

void main()
{
#ifdef CAP
    // The lip, which is drawn later, covers the edge of the cap.
    vec3 local = heel * (position * (1.006 * mouth.w));
#elif defined(WATER)
    float wide = 1.015 * form.z * mouth.w; // The water surface extends into the wall.
    vec3 local = vec3(position.x * wide, form.y * form.x, position.z * wide);
#else
    vec3 local = heel * (position * vec3(mouth.w, form.x, mouth.w));
#endif
    vec3 world = mouth.xyz + local;
#ifdef CAP
    // The mouth is projected from the eye to a plane just above the tank's water surface and above
    // the rings of the fish that gulp there.
    vec3 ray = world - eye.xyz;
    world = eye.xyz + ray * ((CAP_M - eye.y) / ray.y);
#endif
    gl_Position = view_projection * vec4(world, 1.0);
    vec3 view = normalize(eye.xyz - world);
    vec3 middle = normalize(view + LAMP_DIRECTION);
    left = vec3(1.0);
#ifdef WATER
    float away = 1.0 - max(view.y, 0.0);
    light = vec4(middle.xz, middle.y, 0.4 * away * away);
    grid = vec3(local.xz / mouth.w, lamp_light(world).g);
#elif !defined(CAP)
    vec3 n = normalize(heel * (normal / vec3(mouth.w, form.x, mouth.w)));
    float lamps = (1.0 - 0.7 * shade_above(world)) * (0.4 + 0.6 * lamp_light(world).g);
    float lit = 0.58 + 0.50 * max(dot(n, LAMP_DIRECTION), 0.0);
    float gap = cos(paint.w * atan(position.x, position.z));
    float gap_edge = cos(0.21 * paint.w);
    shell = vec3(0.0, surface.y, (gap - gap_edge) / max(cos(0.16 * paint.w) - gap_edge, 1e-4));
    light = vec4(lit * lamps * (1.0 + 0.16 * form.w), dot(n, middle), dot(n, view), lamps);
#ifdef INSIDE
    light.x *= 0.791 + 0.209 * surface.y; // The bottom of the bowl is darker.
#else
    left = water_passes(-world.y * 1.2);
#endif
#ifdef INSIDE
    grid = vec3(world.xz * CAUSTIC_TILES * 1.6, (form.y + 0.02 - local.y / form.x) / 0.06);
#else
    grid = vec3(world.y / RING_M, 0.0, 0.0);
#endif
#endif
}
