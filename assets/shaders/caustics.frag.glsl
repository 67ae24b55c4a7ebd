// The tile of caustics at the current time: a mix of two neighbouring layers of the baked loop. r: the
// caustics on the floor, which waves, dust and several lamps blur. g: the caustics near the water
// surface.
in vec2 at;
uniform sampler2DArray loop_layers;
out vec4 color;

// Depth in m of a floor whose caustics are blurred most, which is the depth of the festival's tank, and
// the level of the loop's smaller pictures that they then have. A texel of level 2 is 4 mm wide on the
// floor.
const float SOFT_M = 0.12;
const float SOFT_LEVEL = 2.0;

vec2 caustics_of(float layer)
{
    return vec2(textureLod(loop_layers, vec3(at, layer), SOFT_LEVEL * min(tank.y / SOFT_M, 1.0)).r,
                texture(loop_layers, vec3(at, layer)).r);
}

void main()
{
    float layer = floor(screen.w);
    float next = mod(layer + 1.0, float(CAUSTIC_LAYERS));
    color = mix(caustics_of(layer), caustics_of(next), screen.w - layer).rggg;
}
