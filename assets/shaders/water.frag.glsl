// The water surface: the refracted picture of the objects below it, and the reflections of the
// stall's lanterns in the waves. The variant EDGE draws the strips at the walls.
in vec3 world;
uniform sampler2D ground;       // Picture of floor and walls, at low resolution.
uniform sampler2D life;         // Picture of fish and other objects below the surface,
                                // premultiplied.
uniform sampler2D mirror;       // Reflections and slopes at low resolution (mirror.frag.glsl).
out vec4 color;

const vec3 WET_WOOD = vec3(0.07, 0.035, 0.02);

void main()
{
    vec2 place = gl_FragCoord.xy * crop.xy + crop.zw;
    vec4 surface = texture(mirror, place);
    vec2 slope = surface.ba - 0.5; // In 2 * SEEN_SLOPE_MAX.
    vec2 at = place + mat2(bend) * slope;
    vec4 swims = texture(life, at);
    vec3 below = texture(ground, at).rgb * (1.0 - swims.a) + swims.rgb;
    // A wave that leans toward the lamps is brighter. A bright reflection replaces what is below it,
    // because the sum of amber light and the colour of the water would be beige. For the same reason,
    // the blue of the reflection is reduced.
    vec3 light = surface.rrg * surface.rgg;
    below *= (1.0 + 0.12 * (slope.x + slope.y)) * (1.0 - light.r);
    below += light * vec3(1.0, 1.0, 0.66);
#ifdef EDGE
    float edge = min(tank.x - abs(world.x), tank.z - abs(world.z));
    float line = 1.0 - smoothstep(0.0, 0.004, edge);  // Bright line where the water meets the walls
                                                      // (the meniscus).
    below += line * (WATER_COLOR * 0.30);
    // The last pixel at the wall is a mix with the wet side of the rim, which smooths the edge
    // without multisampling.
    below = mix(WET_WOOD, below, clamp(edge / fwidth(edge), 0.0, 1.0));
#endif
    color = vec4(below, 1.0);
}
