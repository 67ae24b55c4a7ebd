// The shadow of a poi or a bowl: a tilted disc with a handle, projected onto the floor.
uniform mat4 pose;      // Matrix that transforms the unit disc in its xz plane to the world.
uniform vec4 softness;  // x: margin in disc radii. y: end of the handle; 1 means no handle.
uniform float slant;    // Factor of the shadow's sideways drift. 1 means light from the lamps, 0
                        // means light from straight above.
out vec2 disc;

void main()
{
    disc = disc_and_handle(gl_VertexID, 1.05 + softness.x, 0.16 + 0.5 * softness.x,
                           softness.y + softness.x);
    vec3 world = (pose * vec4(disc.x, 0.0, disc.y, 1.0)).xyz;
    vec2 at = world.xz - slant * shadow.zw * max(world.y + tank.y, 0.0);
    gl_Position = vec4(at * shadow.xy, 0.0, 1.0);
}
