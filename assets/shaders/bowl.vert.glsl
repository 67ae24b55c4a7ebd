// The bowl, a surface of revolution. Units are the radius of its mouth and its depth. The light
// that changes little between two vertices is computed here.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // x: 0 inside, 1 outside. y: 0 at the bottom, 1 at the lip.
uniform vec4 mouth;                     // Centre of the mouth. w: radius of the mouth.
uniform vec4 form;                      // x: depth of the bowl in m. y: height, and z: radius, of
                                        // the water in the bowl.
uniform mat3 heel;                      // Tilt of the bowl. The water in the bowl stays level.
uniform vec4 paint;                     // Colour. w: number of white gaps in the bowl's coloured
                                        // band.
out vec3 shell; // x: 1 inside, 0 outside. y: as surface.y. z: above 0.5 in a gap of the band.
out vec4 light; // For the shell: x: brightness. y: cosine of the angle between the normal and the
                // direction halfway to the lamps. z: cosine of the angle between the normal and the
                // direction to the viewer. w: brightness of the lamps. For the water: xy: change of
                // z for each unit of slope. z: as y of the shell. w: reflection of the sky.
out vec3 left;  // Fraction of the light that passes through the water.
out vec3 grid;  // For the shell: xy: coordinates in the texture of the caustics. z: above 0.5 below
                // the water in the bowl. For the water: xy: position in mouth radii.

void main()
{
#ifdef HOLE
    vec3 local = heel * (position * mouth.w);
#elif defined(WATER)
    float wide = 1.015 * form.z * mouth.w; // The water surface extends into the wall.
    vec3 local = vec3(position.x * wide, form.y * form.x, position.z * wide);
#else
    vec3 local = heel * (position * vec3(mouth.w, form.x, mouth.w));
#endif
    vec3 world = mouth.xyz + local;
    gl_Position = view_projection * vec4(world, 1.0);
    vec3 view = normalize(eye.xyz - world);
    vec3 middle = normalize(view + LAMP_DIRECTION);
    left = vec3(1.0);
#ifdef HOLE
    gl_Position.z = gl_Position.w; // The bowl's mouth is drawn at the far plane, so that the bowl's
                                   // contents are visible over the tank's water.
#elif defined(WATER)
    float away = 1.0 - max(view.y, 0.0);
    light = vec4(middle.xz, middle.y, 0.4 * away * away * away);
    grid = vec3(local.xz / mouth.w, 0.0);
#else
    vec3 n = normalize(heel * (normal / vec3(mouth.w, form.x, mouth.w)));
    float inside = 1.0 - surface.x;
    float lamps = (1.0 - 0.7 * shade_above(world)) * lamp_light(world).g;
    float lit = 0.58 + 0.50 * max(dot(n, LAMP_DIRECTION), 0.0);
    float gap = cos(paint.w * atan(position.x, position.z));
    float gap_edge = cos(0.21 * paint.w);
    shell = vec3(inside, surface.y, (gap - gap_edge) / max(cos(0.16 * paint.w) - gap_edge, 1e-4));
    light = vec4(lit * lamps * mix(1.0, 0.62 + 0.38 * surface.y, inside * 0.55), dot(n, middle),
                 dot(n, view), lamps);
    left = inside > 0.5 ? vec3(1.0) : water_passes(-world.y * 1.2);
    grid = vec3(world.xz * CAUSTIC_TILES * 1.6, (form.y + 0.02 - local.y / form.x) / 0.06);
#endif
}
