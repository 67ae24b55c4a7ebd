// The water surface: the refracted picture of the objects below it, and the reflections of the
// stall's lanterns in the waves.
in vec3 world;
uniform sampler2D ground;       // Picture of floor and walls, at low resolution.
uniform sampler2D life;         // Picture of fish and other objects below the surface,
                                // premultiplied.
uniform sampler2D slopes;
uniform sampler2D environment;
out vec4 color;

const vec3 WET_WOOD = vec3(0.07, 0.035, 0.02);

void main()
{
    vec4 slopes_here = texture(slopes, world.xz / tank.xz * 0.5 + 0.5);
    vec2 slope = slopes_here.rg;
    vec2 bends = mat2(placed) * (slopes_here.ba * bend.xy); // The limited slopes of basin_pass.c.
    vec2 at = gl_FragCoord.xy * screen.xy + bends;
    vec4 swims = texture(life, at);
    vec3 below = texture(ground, at).rgb * (1.0 - swims.a) + swims.rgb;

    vec3 view = normalize(eye.xyz - world);
    vec3 normal = normalize(vec3(-slope.x * 1.5, 1.0, -slope.y * 1.5));
    float facing = dot(normal, view);
    vec3 mirror = 2.0 * facing * normal - view;
    float away = 1.0 - facing;
    float away2 = away * away;
    float fresnel = 0.02 + 0.98 * away2 * away2 * away;
    // The lanterns are only about two metres away, so that their reflections move with the position
    // on the water. Only light sources are drawn as reflections, because only they are visible on
    // lit water. A light source is far brighter than the maximum of a texel.
    vec3 toward = mirror + world * 0.55;
    float lantern = texture(environment, toward.xz / (length(toward) + toward.y) * 0.5 + 0.5).r;
    lantern = max(lantern - 0.42, 0.0);
    float glint = max(dot(mirror, vec3(0.100, 0.619, -0.779)), 0.0);
    glint *= glint; glint *= glint; glint *= glint; glint *= glint;
    glint *= glint; glint *= glint; glint *= glint; glint *= glint;
    float edge = min(tank.x - abs(world.x), tank.z - abs(world.z));
    float line = 1.0 - smoothstep(0.0, 0.004, edge);  // Bright line where the water meets the walls
                                                      // (the meniscus).
    float lit = 1.0 - shade_above(world);      // A fan also hides the lamps from the water.
    lantern *= lit;
    glint *= lit;
    below *= 1.0 + clamp((slope.x + slope.y) * 0.6, -0.10, 0.14);
    below += vec3(1.0, 0.86, 0.62) * min(lantern * (0.10 + 3.0 * fresnel), 0.30)
        + glint * vec3(0.55, 0.48, 0.36) + line * vec3(0.10, 0.13, 0.14);
    // The last pixel at the wall is a mix with the wet side of the rim, which smooths the edge
    // without multisampling.
    color = vec4(mix(WET_WOOD, below, clamp(edge / fwidth(edge), 0.0, 1.0)), 1.0);
}
