// The walls of the tank.
in vec3 tile;
in vec3 gain;
in vec3 steady;
uniform sampler2D caustics;
out vec4 color;

void main()
{
    // The far wall is seen at a slant, so that a pixel covers several texels. Four samples in the
    // pixel keep the bright lines from breaking into dashes.
    vec2 right = dFdx(tile.xy), up = dFdy(tile.xy);
    vec2 near = 0.375 * right + 0.125 * up, far = 0.375 * up - 0.125 * right;
    vec2 sum = texture(caustics, tile.xy + near).rg + texture(caustics, tile.xy - near).rg
        + texture(caustics, tile.xy + far).rg + texture(caustics, tile.xy - far).rg;
    float light = 0.25 * mix(sum.g, sum.r, tile.z);
    color = vec4(gain * (light * (0.45 + 1.5 * light)) + steady, 1.0);
}
