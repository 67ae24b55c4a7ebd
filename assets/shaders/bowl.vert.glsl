// The bowl: a surface of revolution, in radii of its mouth and depths below it.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // x: 0 inside, 1 outside; y: 0 bottom .. 1 lip.
uniform vec4 mouth;                     // Centre; w: radius.
uniform vec4 form;                      // x: depth, m; of the bowl's water, y: height, z: radius.
uniform mat3 heel;                      // Tilt of the bowl. Its water stays level.
uniform vec4 paint;                     // w: number of white gaps in the bowl's band.
out vec3 world;
out vec3 face;
out vec3 shell;                         // z: 1 in the middle of a gap.

void main()
{
#ifdef HOLE
    vec3 local = heel * (position * mouth.w);
#elif defined(WATER)
    float wide = 1.015 * form.z * mouth.w; // Extends into the wall.
    vec3 local = vec3(position.x * wide, form.y * form.x, position.z * wide);
#else
    vec3 local = heel * (position * vec3(mouth.w, form.x, mouth.w));
#endif
    world = mouth.xyz + local;
    face = heel * normalize(normal / vec3(mouth.w, form.x, mouth.w));
    shell = vec3(surface, cos(paint.w * atan(position.x, position.z)));
    gl_Position = view_projection * vec4(world, 1.0);
#ifdef HOLE
    gl_Position.z = gl_Position.w; // The far plane, so that the bowl's contents are visible over
                                   // the tank's water.
#endif
}
