// The walls of the tank.
in vec2 tile;
in vec3 gain;
in vec3 steady;
uniform sampler2D caustics;
out vec4 color;

void main()
{
    // The far wall is seen at a slant, so that a pixel covers several texels. Four samples in the
    // pixel keep the bright lines from breaking into dashes.
    vec2 right = dFdx(tile), up = dFdy(tile);
    vec2 near = 0.375 * right + 0.125 * up, far = 0.375 * up - 0.125 * right;
    float light = 0.25 * (texture(caustics, tile + near).r + texture(caustics, tile - near).r
        + texture(caustics, tile + far).r + texture(caustics, tile - far).r);
    color = vec4(gain * (light * (0.45 + 1.5 * light)) + steady, 1.0);
}
