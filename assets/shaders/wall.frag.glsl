// The walls of the tank.
in vec3 world;
uniform sampler2D caustics;
out vec4 color;

const vec3 VINYL = vec3(0.53, 0.88, 0.97);

void main()
{
    float depth = -world.y;
    float shade = shades_at(world).x;
    // The far wall is seen at a slant, so that a pixel covers several texels. Four samples in the
    // pixel keep the bright lines from breaking into dashes.
    vec2 tile = (world.xz + world.y * 0.7) * (CAUSTIC_TILES * 0.92);
    vec2 right = dFdx(tile), up = dFdy(tile);
    vec2 near = 0.375 * right + 0.125 * up, far = 0.375 * up - 0.125 * right;
    float light = 0.25 * (texture(caustics, tile + near).r + texture(caustics, tile - near).r
        + texture(caustics, tile + far).r + texture(caustics, tile - far).r);
    float down = smoothstep(0.0, tank.y, depth);
    vec3 base = VINYL * (0.86 - 0.24 * down) * (0.60
        + light * (0.45 + 1.5 * light) * (evening.w * (1.0 - 0.6 * down)));
    base *= 1.0 - shade * vec3(0.92, 0.84, 0.76); // A shade on a wall absorbs only a part of the
                                                  // light, because light also comes from the sides.
    vec3 left = water_passes(depth * 1.2);
    color = vec4(mix(WATER_COLOR * (1.0 - 0.5 * shade), base, left) * lamp_light(world), 1.0);
}
