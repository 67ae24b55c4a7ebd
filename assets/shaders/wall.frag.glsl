// The walls of the tank.
in vec3 world;
uniform sampler2D caustics;
out vec4 color;

const vec3 VINYL = vec3(0.53, 0.88, 0.97);

void main()
{
    float depth = -world.y;
    float shade = shades_at(world).x;
    float light = texture(caustics, (world.xz + world.y * 0.7) * CAUSTIC_TILES * vec2(0.92)).r;
    float down = smoothstep(0.0, tank.y, depth);
    vec3 base = VINYL * (0.86 - 0.24 * down) * (0.60 + light * (0.45 + 1.5 * light));
    base *= 1.0 - shade * vec3(0.92, 0.84, 0.76); // A shade on a wall absorbs only a part of the
                                                  // light, because light also comes from the sides.
    vec3 left = water_passes(depth * 1.2);
    color = vec4(mix(WATER_COLOR * (1.0 - 0.5 * shade), base, left), 1.0);
}
