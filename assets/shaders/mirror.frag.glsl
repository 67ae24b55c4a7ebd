// The water surface at low resolution: the reflections of the stall's lanterns in the waves, and the
// slopes. The water surface (water.frag.glsl) reads this picture. rg: square roots of the red and of
// the blue of the reflected light. Its green is the product of the two roots, as in environment.c.
// ba: slopes for the refraction, from -SEEN_SLOPE_MAX to SEEN_SLOPE_MAX.
in vec2 grid;    // As in water.vert.glsl.
in vec2 shaded;
in vec2 place;
in vec3 view;
in vec2 ripple;
uniform sampler2D slopes;
uniform sampler2D environment;
out vec4 color;

const float SHEEN = 0.10; // Brightness of the glow of the fair in the sky, which makes the surface
                          // visible at rest where it is seen at a flat angle.

void main()
{
    vec4 slopes_here = texture(slopes, grid); // As in struct basin_pass.
    // The lanterns are in front of the player, who may stand at the short side of the tank. The
    // slope to the side counts less, so that a reflection stretches toward the viewer.
    vec2 slope = from_world(slopes_here.ba);
    vec3 to_eye = normalize(view);
    vec3 normal = normalize(vec3(-slope.x * 0.5, 1.0, -slope.y));
    float facing = dot(normal, to_eye);
    vec3 mirror = 2.0 * facing * normal - to_eye;
    float away = 1.0 - facing;
    float away2 = away * away;
    float fresnel = 0.02 + 0.98 * away2 * away2 * away;
    // Small waves, which the picture of the slopes lacks, are sines whose phases the slopes of the
    // large waves shift.
    vec2 wave = sin(ripple + 24.0 * slope);
    // The lanterns are only about two metres away, so that their reflections move with the position
    // on the water. The small waves also move a reflection to the side.
    vec3 toward = mirror + vec3(place.x, 0.0, place.y) * 0.55;
    toward.x += 0.015 * wave.y;
    vec2 seen = toward.xz / (length(toward) + toward.y);
    vec2 night = texture(environment, seen * 0.5 + 0.5).rb;
    // A lantern is far brighter than the maximum of a texel. The small waves break its reflection
    // into glints that lie across the view.
    float ridge = max(0.5 + 0.28 * (wave.x + wave.y), 0.0);
    float core = max(night.x - 0.32, 0.0);
    float lit = 1.0 - texture(shades, shaded).r; // A fan also hides the lamps from the water.
    float lantern = 14.0 * core * core * ridge * ridge * ridge;
    lantern *= (1.0 + 5.0 * fresnel) * water_tint.w * lit;
    vec2 light = vec2(lantern, 0.40 * night.y * lantern)
        + (night * fresnel + SHEEN * away2) * sky_glow.xy;
    // A soft knee for each colour: the middle of a bright reflection is nearly white, and its edge
    // is amber.
    light /= 1.0 + light;
    color = vec4(sqrt(light), 0.5 + slopes_here.ba * (0.5 / SEEN_SLOPE_MAX));
}
