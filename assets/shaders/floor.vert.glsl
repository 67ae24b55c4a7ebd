// The floor of the tank as a grid of GRID_X * GRID_Z cells. The light that changes little from cell to
// cell is computed here. Each instance is a row of cells, drawn as a triangle strip.
out vec2 at;    // Position on the floor, x and z in m.
out vec3 gain;  // Factor of the light of the caustics.
out vec3 added; // Colour that the water adds.
out float bright; // Fraction of the light of the caustics that no shade absorbs.

void main()
{
    ivec2 cell = ivec2(gl_VertexID >> 1, gl_InstanceID + (gl_VertexID & 1));
    vec2 corner = vec2(cell) / vec2(GRID_X, GRID_Z) * 2.0 - 1.0;
    vec3 world = vec3(corner.x, -1.0, corner.y) * tank.xyz;
    vec2 edge = tank.xz - abs(world.xz);
    float dim = smoothstep(0.0, 0.085, edge.x) * smoothstep(0.0, 0.085, edge.y);
    float fold = sin(world.x * 14.0 + sin(world.z * 10.0) * 1.3);
    float shade = shades_at(world).x;
    vec3 left = water_passes(tank.y * 1.2);
    at = world.xz;
    // A shade on the floor absorbs only a part of the light, because light also comes from the sides.
    vec3 lamps = lamp_light(world);
    gain = vinyl.rgb * lamps * left * ((0.95 + 0.05 * fold) * (0.66 + 0.36 * dim))
        * (1.0 - shade * vec3(0.92, 0.84, 0.76));
    added = WATER_COLOR * lamps * (1.0 - 0.5 * shade) * (1.0 - left);
    bright = evening.w * (1.0 - 0.8 * shade);
    gl_Position = view_projection * vec4(world, 1.0);
}
