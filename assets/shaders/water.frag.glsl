// The water surface: the refracted picture of the objects below it, and the reflections of the
// stall's lanterns in the waves.
in vec3 world;
uniform sampler2D ground;       // Picture of floor and walls, at low resolution.
uniform sampler2D life;         // Picture of fish and other objects below the surface,
                                // premultiplied.
uniform sampler2D slopes;
uniform sampler2D mirror;       // Reflections at low resolution (mirror.frag.glsl).
out vec4 color;

const vec3 WET_WOOD = vec3(0.07, 0.035, 0.02);
const vec2 MIRROR_GAIN = vec2(0.75, 0.5); // Converts the alpha of `mirror` to a brightness.

void main()
{
    vec2 limited = texture(slopes, world.xz / tank.xz * 0.5 + 0.5).ba; // The limited slopes of
                                                                       // basin_pass.c.
    vec2 bends = mat2(placed) * (limited * bend.xy);
    vec2 at = gl_FragCoord.xy * screen.xy + bends;
    vec4 swims = texture(life, at);
    vec3 below = texture(ground, at).rgb * (1.0 - swims.a) + swims.rgb;

    float edge = min(tank.x - abs(world.x), tank.z - abs(world.z));
    float line = 1.0 - smoothstep(0.0, 0.004, edge);  // Bright line where the water meets the walls
                                                      // (the meniscus).
    vec4 gleam = texture(mirror, gl_FragCoord.xy * screen.xy);
    below *= MIRROR_GAIN.x + MIRROR_GAIN.y * gleam.a;
    below += gleam.rgb + line * vec3(0.10, 0.13, 0.14);
    // The last pixel at the wall is a mix with the wet side of the rim, which smooths the edge
    // without multisampling.
    color = vec4(mix(WET_WOOD, below, clamp(edge / fwidth(edge), 0.0, 1.0)), 1.0);
}
