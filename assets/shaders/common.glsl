// Prepended to every shader: precisions, the uniform values that all passes share, and the water.
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
                     // z: number of shades that are fans; w: number of all shades.
    vec4 placed;     // Columns of the rotation of the picture on the screen.
    vec4 shades[8];  // Centre x, z, radius and darkness of shadow ellipses: fans first, then dry
                     // pois.
};

const vec3 WATER_COLOR = vec3(0.09, 0.42, 0.53);
const vec3 LAMP_DIRECTION = vec3(0.251, 0.955, 0.151); // Direction from any point to the stall's
                                                       // lamps.
const vec3 WHITE = vec3(1.0, 0.955, 0.90);             // Colour where a goldfish is not red.
const float CAUSTIC_TILES = 3.6;                       // Tiles per metre.

// Returns the fraction of light left after `path_m` of water. Red is absorbed most, but never
// completely.
vec3 water_passes(float path_m)
{
    return exp(-max(path_m, 0.0) * screen.z * vec3(1.25, 0.55, 0.45));
}

// Returns the fraction of light that shades 0 .. count absorb at `at`. The light falls from
// straight above, where the fish detect shade (core/tank/shade.h). The edge blurs with the depth.
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

// Returns the red of a goldfish: from vermilion to, rarely, orange.
vec3 red_of(float hue)
{
    return mix(vec3(1.0, 0.085, 0.015), vec3(1.0, 0.40, 0.03), hue * hue * hue);
}

// Young goldfish lose their grey in patches, the belly first.
const vec3 FRY = vec3(0.40, 0.42, 0.27);
float turned(float maturity, float ahead)
{
    return smoothstep(0.10, 0.42, maturity + ahead);
}

// Writes a goldfish's skin colours where its pattern is white and where it is red; `under` is 0 at
// the back and 1 at the belly. Used in the tank and in the album, so that a fish is recognizable.
void goldfish_skin(float under, float maturity, float hue, out vec3 pale, out vec3 stain)
{
    float belly = smoothstep(0.52, 0.96, under);
    vec3 red = red_of(hue);
    vec3 below = mix(WHITE, red, 0.25);
    vec3 young = mix(FRY * (0.62 + 0.38 * under), vec3(0.80, 0.80, 0.66), belly);
    pale = mix(young, mix(WHITE, below, 0.55 * belly), turned(maturity, 0.10 * belly - 0.06));
    stain = mix(young, mix(red, below, 0.55 * belly), turned(maturity, 0.10 * belly + 0.06));
}

// Returns the colour of a goldfish's fins at (u, v) of species.h, for the `layer` of patterns on
// its skin.
vec3 goldfish_fin(vec2 at, float maturity, float hue, float layer)
{
    float seed = fract(hue * 17.31);
    float root = 1.0 - at.y;
    float stained = smoothstep(0.30, 0.72, fract(seed * 7.7 + layer * 0.37)
        + 0.20 * sin(at.x * 9.0 + hue * 20.0) + 0.25 * root);
    vec3 tint = mix(WHITE, red_of(hue), stained);
    return mix(mix(FRY * 1.25, tint, turned(maturity, 0.0)), WHITE, 0.22 * at.y);
}
