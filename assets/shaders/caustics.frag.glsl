// The tile of caustics at the current time: a mix of two neighbouring layers of the baked loop.
in vec2 at;
uniform sampler2DArray loop_layers;
out vec4 color;

void main()
{
    float layer = floor(screen.w);
    float next = mod(layer + 1.0, float(CAUSTIC_LAYERS));
    float a = texture(loop_layers, vec3(at, layer)).r;
    float b = texture(loop_layers, vec3(at, next)).r;
    color = vec4(mix(a, b, screen.w - layer));
}
