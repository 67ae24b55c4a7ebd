// The paper of a poi, a disc that sags under its load.
layout(location = 0) in vec2 position;  // Position in ring radii. y increases toward the handle.
uniform mat4 pose;
uniform vec4 paper;                     // x: sag in ring radii. y: layer of `sheet`.
out vec3 world;
out vec3 face;
out vec2 at;

void main()
{
    float r2 = dot(position, position);
    vec3 local = vec3(position.x, -paper.x * (1.0 - r2), position.y);
    world = (pose * vec4(local, 1.0)).xyz;
    vec2 slope = -2.0 * paper.x * position;
    face = normalize(mat3(pose) * vec3(slope.x, 1.0, slope.y));
    at = position * 0.5 + 0.5;
    gl_Position = view_projection * vec4(world, 1.0);
}
