// The bowl, a surface of revolution. Units are the radius of its mouth and its depth.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // x: 0 inside, 1 outside. y: 0 at the bottom, 1 at the lip.
uniform vec4 mouth;                     // Centre of the mouth. w: radius of the mouth.
uniform vec4 form;                      // x: depth of the bowl in m. y: height, and z: radius, of
                                        // the water in the bowl.
uniform mat3 heel;                      // Tilt of the bowl. The water in the bowl stays level.
uniform vec4 paint;                     // Colour. w: number of white gaps in the bowl's coloured
                                        // band.
out vec3 world;
out vec3 face;
out vec3 shell;                         // z: 1 in the middle of a gap of the band.

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
    world = mouth.xyz + local;
    face = heel * normalize(normal / vec3(mouth.w, form.x, mouth.w));
    shell = vec3(surface, cos(paint.w * atan(position.x, position.z)));
    gl_Position = view_projection * vec4(world, 1.0);
#ifdef HOLE
    gl_Position.z = gl_Position.w; // The bowl's mouth is drawn at the far plane, so that the bowl's
                                   // contents are visible over the tank's water.
#endif
}
