in vec3 world;
uniform sampler2D caustics;
uniform sampler2D shadows;
out vec4 color;

const vec3 VINYL = vec3(0.53, 0.88, 0.97);

void main()
{
    float depth = -world.y;
    float shade = shades_at(world).x;
    vec3 base = VINYL;
#ifdef FLOOR
    vec2 edge = tank.xz - abs(world.xz);
    float corner = smoothstep(0.0, 0.085, edge.x) * smoothstep(0.0, 0.085, edge.y);
    float light = texture(caustics, world.xz * CAUSTIC_TILES).r
        + texture(caustics, world.zx * CAUSTIC_TILES * 0.72 + 0.37).r;
    light *= (0.42 + 0.85 * light) * (1.0 - 0.8 * shade);  // The lines of the caustics become
                                                           // brighter, and the ground between them
                                                           // more even.
    float fold = sin(world.x * 14.0 + sin(world.z * 10.0) * 1.3);
    float dark = texture(shadows, world.xz * shadow.xy * 0.5 + 0.5).r;
    base *= (0.95 + 0.05 * fold) * (0.66 + 0.36 * corner) * (0.60 + light * 0.80);
    base *= 1.0 - 0.70 * dark * vec3(1.0, 0.93, 0.86);
#else
    float light = texture(caustics, (world.xz + world.y * 0.7) * CAUSTIC_TILES * vec2(0.92)).r;
    float down = smoothstep(0.0, tank.y, depth);
    base *= (0.86 - 0.24 * down) * (0.60 + light * (0.45 + 1.5 * light));
#endif
    base *= 1.0 - shade * vec3(0.92, 0.84, 0.76); // A shade on the floor absorbs only a part of the
                                                  // light, because light also comes from the sides.
    vec3 left = water_passes(depth * 1.2);
    color = vec4(mix(WATER_COLOR * (1.0 - 0.5 * shade), base, left), 1.0);
}
