// The bowl: a lathed shell, in radii of its mouth and depths below it.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // x: 0 inside, 1 outside; y: 0 bottom .. 1 lip.
uniform vec4 mouth;                     // Centre; w: radius.
uniform vec4 form;                      // x: depth, m; y: from the water's disc to the mouth's.
out vec3 world;
out vec3 face;
out vec2 shell;

void main()
{
#ifdef HOLE
    vec3 local = vec3(position.x * form.y, 0.0, position.z * form.y);
#else
    vec3 local = position;
#endif
    world = mouth.xyz + local * vec3(mouth.w, form.x, mouth.w);
    face = normalize(normal / vec3(mouth.w, form.x, mouth.w));
    shell = surface;
    gl_Position = view_projection * vec4(world, 1.0);
#ifdef HOLE
    gl_Position.z = gl_Position.w; // The far plane: what a bowl holds shows over the tank's water.
#endif
}
