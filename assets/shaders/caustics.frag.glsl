// The tile of caustics at the current time: a mix of two neighbouring layers of the baked loop. r: the
// caustics on the floor, which waves, dust and several lamps blur. g: the caustics near the water
// surface.
in vec2 at;
uniform sampler2DArray loop_layers;
out vec4 color;

vec2 caustics_of(float layer)
{
    return vec2(textureLod(loop_layers, vec3(at, layer), vinyl.w).r,
                texture(loop_layers, vec3(at, layer)).r);
}

void main()
{
    float layer = floor(screen.w);
    float next = mod(layer + 1.0, float(CAUSTIC_LAYERS));
    color = mix(caustics_of(layer), caustics_of(next), screen.w - layer).rggg;
}
