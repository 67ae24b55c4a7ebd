// The water surface at low resolution: the reflections of the stall's lanterns in the waves, and the
// slopes. The water surface (water.frag.glsl) reads this picture. rg: square roots of the red and of
// the blue of the reflected light. Its green is the product of the two roots, as in environment.c.
// ba: slopes for the refraction, from -SEEN_SLOPE_MAX to SEEN_SLOPE_MAX.
in vec2 grid;    // As in water.vert.glsl.
in vec2 shaded;
in vec2 place;
in vec3 view;
uniform sampler2D slopes;
uniform sampler2D environment;
out vec4 color;

const float SHEEN = 0.10; // Brightness of the glow of the fair in the sky, which makes the surface
                          // visible at rest where it is seen at a flat angle.

void main()
{
    vec4 slopes_here = texture(slopes, grid); // As in struct basin_pass.
    // The lanterns are in front of the player, who may stand at the short side of the tank. The
    // slope to the side counts less, so that a reflection stretches toward the viewer and does not
    // break into hooks.
    vec2 slope = from_world(slopes_here.ba);
    vec3 to_eye = normalize(view);
    vec3 normal = normalize(vec3(-slope.x * 0.5, 1.0, -slope.y));
    float facing = dot(normal, to_eye);
    vec3 mirror = 2.0 * facing * normal - to_eye;
    float away = 1.0 - facing;
    float away2 = away * away;
    float fresnel = 0.02 + 0.98 * away2 * away2 * away;
    // The lanterns are only about two metres away, so that their reflections move with the position
    // on the water.
    vec3 toward = mirror + vec3(place.x, 0.0, place.y) * 0.55;
    vec2 night = texture(environment, toward.xz / (length(toward) + toward.y) * 0.5 + 0.5).rb;
    // A lantern is brighter than the maximum of a texel. The fourth power makes its reflection
    // fade over a wide edge.
    float core = max(night.r - 0.25, 0.0);
    float hot = core * core;
    float lantern = hot * (0.5 + 6.0 * hot) * (1.0 + 5.0 * fresnel) * water_tint.w;
    float glint = max(dot(mirror, vec3(0.100, 0.619, -0.779)), 0.0);
    // The bulb is small, so that a flat part of the water does not show it as a cloud.
    glint *= glint; glint *= glint; glint *= glint; glint *= glint;
    glint *= glint; glint *= glint; glint *= glint; glint *= glint;
    glint *= glint; glint *= glint; glint *= glint;
    float lit = 1.0 - texture(shades, shaded).r; // A fan also hides the lamps from the water.
    vec2 light = vec2(1.0, night.y + 0.18 * hot) * (lantern * lit)
        + (night * fresnel + SHEEN * away2) * sky_glow.xy + vec2(2.6, 1.2) * (glint * lit);
    // Soft knee for both colours by the brighter one, so that a bright reflection keeps its colour.
    light /= 1.0 + max(light.x, light.y);
    color = vec4(sqrt(light), 0.5 + slopes_here.ba * (0.5 / SEEN_SLOPE_MAX));
}
