// The water surface at low resolution: the reflections of the stall's lanterns in the waves, and the
// slopes. The water surface (water.frag.glsl) reads this picture. r: reflected light, which has the
// colour of the lanterns. g: brightness of the refracted picture, as MIRROR_GAIN in water.frag.glsl
// decodes it. ba: slopes for the refraction, from -SEEN_SLOPE_MAX to SEEN_SLOPE_MAX.
in vec3 world;
in vec2 grid;
uniform sampler2D slopes;
uniform sampler2D environment;
out vec4 color;

void main()
{
    vec4 slopes_here = texture(slopes, grid); // As in struct basin_pass.
    vec2 slope = slopes_here.rg;
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
    // The lanterns are in front of the player, who may stand at the short side of the tank.
    mirror.xz = from_world(mirror.xz);
    vec3 toward = mirror + vec3(from_world(world.xz), world.y).xzy * 0.55;
    float lantern = texture(environment, toward.xz / (length(toward) + toward.y) * 0.5 + 0.5).r;
    lantern = max(lantern - 0.42, 0.0);
    float glint = max(dot(mirror, vec3(0.100, 0.619, -0.779)), 0.0);
    glint *= glint; glint *= glint; glint *= glint; glint *= glint;
    glint *= glint; glint *= glint; glint *= glint; glint *= glint;
    float lit = 1.0 - shade_above(world);      // A fan also hides the lamps from the water.
    float light = min(lantern * lit * (0.10 + 3.0 * fresnel), 0.30) + glint * lit * 0.55;
    color = vec4(light, 0.5 + 2.0 * clamp((slope.x + slope.y) * 0.6, -0.10, 0.14),
                 0.5 + slopes_here.ba * (0.5 / SEEN_SLOPE_MAX));
}
