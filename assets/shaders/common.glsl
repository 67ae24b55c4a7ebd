// Common block that is inserted before every shader: precisions, uniform values that all passes
// share, and functions for water.
precision highp float;
precision mediump int;
precision highp sampler2D;
precision highp sampler2DArray;

layout(std140) uniform Frame {
    mat4 view_projection;
    vec4 eye;        // World position of the camera. w: time in seconds, which restarts each hour.
    vec4 tank;       // Half width, water depth, half breadth, height of the rim above the water,
                     // all in m.
    vec4 screen;     // xy: 1 / width and 1 / height of the screen. z: absorption, 1 / m. w:
                     // caustics layer.
    vec4 shadow;     // xy: factors from world x, z to the shadow map's -1 .. 1. zw: sideways drift
                     // of a shadow in m per m of height.
    vec4 bend;       // Columns of a matrix: shift of the refracted picture, as a fraction of the
                     // picture, per 2 * SEEN_SLOPE_MAX of surface slope in x and in z.
    vec4 shade_map;  // xy: factors from world x, z to the shade map's -0.5 .. 0.5. zw: world x, z of
                     // the player's right.
    vec4 crop;       // Factors (xy) from a pixel of the screen, and offsets (zw), to a place in the
                     // pictures of the objects below the water.
    vec4 bulbs;      // rgb: light right below a bulb. w: decrease of this light, 1 / m^2.
    vec4 evening;    // rgb: light that is everywhere. w: strength of the caustics, 1 by day.
    vec4 water_tint; // rgb: colour that the water adds. w: strength of the lanterns' reflections.
    vec4 sky_glow;   // x, y: red and blue of the sky's reflection, as a factor. z, w: distance of
                     // the bulbs from the middle of the tank, in x and z, in m.
    vec4 vinyl;      // rgb: colour of the vinyl of the tank. w: width in m of a pixel of the render
                     // target, at the middle of the picture.
};

// Fractions of light that circular shades absorb, seen from above (shade.frag.glsl). r, g: fans
// only, at the water surface and at the floor. b, a: fans and dry pois, likewise.
uniform sampler2D shades;

// Maximum slope of the water surface for the refraction, as in basin_pass.c.
const float SEEN_SLOPE_MAX = 0.05;
#define WATER_COLOR water_tint.rgb
const vec3 LAMP_DIRECTION = vec3(0.251, 0.955, 0.151); // Direction from any point to the lamps of
                                                       // the stall.
const vec3 WHITE = vec3(1.0, 0.955, 0.90);             // Skin colour of a goldfish in the growth lab
                                                       // where the skin is not red.
const float CAUSTIC_TILES = 3.6;                       // Number of caustics tiles per metre.

// Returns the vertex `index` of a triangle strip of 12 vertices: an octagon around a circle of the
// radius `r`, and a rectangle from the octagon to y = `end` with the half width `half_width`.
vec2 disc_and_handle(int index, float r, float half_width, float end)
{
    int row = index >> 1;
    float short_side = 0.4142136 * r; // Half of a side of the octagon.
    float x = row > 3 ? half_width : row == 1 || row == 2 ? r : short_side;
    float y = row == 0 ? -r : row == 1 ? -short_side : row == 2 ? short_side
        : row < 5 ? r : max(end, r);
    return vec2((index & 1) == 0 ? -x : x, y);
}

// Converts world x, z to the player's axes: to the right, and toward the player (core/view.h).
vec2 from_world(vec2 at)
{
    return vec2(dot(at, shade_map.zw), dot(at, vec2(-shade_map.w, shade_map.z)));
}

// Converts the player's axes to world x, z.
vec2 to_world(vec2 at)
{
    return at.x * shade_map.zw + at.y * vec2(-shade_map.w, shade_map.z);
}

// Returns the fraction of light that remains after `path_m` metres of water. Water absorbs red the
// most, but never completely.
vec3 water_passes(float path_m)
{
    return exp(-max(path_m, 0.0) * screen.z * vec3(1.25, 0.55, 0.45));
}

// Returns the light at a place of the tank: a pool of warm light under each of two bulbs, and little
// light in the corners. frame_block.c computes the same for a fish.
vec3 lamp_light(vec3 at)
{
    vec2 far = vec2(abs(at.x), at.z) - sky_glow.zw;
    float near = 1.0 / (1.0 + bulbs.w * dot(far, far));
    return evening.rgb + bulbs.rgb * (near * near);
}

// Returns the fractions of light that are absorbed at point `at`, above or below the water, by the
// shades of the fans (x), and by the shades of the fans and of the dry pois (y). The light falls
// from straight above, as in core/tank/shade.h, in which the fish detect shade. The edge of a shade
// blurs with the depth.
vec2 shades_at(vec3 at)
{
    vec4 map = texture(shades, at.xz * shade_map.xy + 0.5);
    return mix(map.rb, map.ga, clamp(-at.y / tank.y, 0.0, 1.0));
}

// Returns the fraction of light that the shades of the fans absorb at the height of the water
// surface or above.
float shade_above(vec3 at)
{
    return texture(shades, at.xz * shade_map.xy + 0.5).r;
}
