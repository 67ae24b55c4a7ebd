// Ring and handle of a poi, a plastic solid with a pose.
layout(location = 0) in vec3 position;  // Position in ring radii.
layout(location = 1) in vec3 normal;
uniform mat4 pose;
out vec3 world;
out vec3 face;
out vec3 at;

void main()
{
    at = position;
    world = (pose * vec4(position, 1.0)).xyz;
    face = normalize(mat3(pose) * normal);
    gl_Position = view_projection * vec4(world, 1.0);
}
