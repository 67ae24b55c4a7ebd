// Put in front of every shader: precisions, the figures that all passes share, and the water.
precision highp float;
precision mediump int;
precision highp sampler2D;
precision highp sampler2DArray;

layout(std140) uniform Frame {
    mat4 view_projection;
    vec4 eye;        // World position; w: seconds, wrapped at an hour.
    vec4 tank;       // Half width, water depth, half breadth, rim height above the water.
    vec4 screen;     // 1 / width, 1 / height of the screen; z: absorption, 1 / m; w: caustic layer.
    vec4 shadow;     // xy: world x, z to the shadow map's -1 .. 1; zw: drift, m per m of height.
    vec4 bend;       // xy: screen fraction per unit of surface slope, in x and in z;
                     // zw: how many of the shades are fans', and how many there are.
    vec4 shades[8];  // Middle x, z, radius and darkness: fans first, then dry pois.
};

const vec3 WATER_COLOR = vec3(0.09, 0.42, 0.53);
const vec3 LAMP_DIRECTION = vec3(0.251, 0.955, 0.151); // From anything to the stall's lamps.
const vec3 WHITE = vec3(1.0, 0.955, 0.90);             // Where a goldfish is not red.
const float CAUSTIC_TILES = 3.6;                       // Per metre.

// What is left of light that went `path_m` through water: red goes first, but never all of it.
vec3 water_passes(float path_m)
{
    return exp(-max(path_m, 0.0) * screen.z * vec3(1.25, 0.55, 0.45));
}

// How much of the light shades 0 .. count take away at `at`. It falls from straight above, as the
// fish feel it (core/tank/shade.h), and blurs with the depth.
float shade_at(vec3 at, float count)
{
    float light = 1.0;
    float blur = 0.010 + 0.10 * max(-at.y, 0.0);
    for (int i = 0; i < int(count); i++) {
        float r = length(at.xz - shades[i].xy);
        light *= 1.0 - shades[i].w
            * (1.0 - smoothstep(shades[i].z - blur, shades[i].z + blur, r));
    }
    return 1.0 - light;
}

// A goldfish's own red: from vermilion to, rarely, orange.
vec3 red_of(float hue)
{
    return mix(vec3(1.0, 0.085, 0.015), vec3(1.0, 0.40, 0.03), hue * hue * hue);
}
