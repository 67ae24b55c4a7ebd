// The walls of the tank as a grid of 4 * WALL_COLUMNS * WALL_ROWS cells. The light that changes little
// from cell to cell is computed here. Each instance is a row of cells, drawn as a triangle strip
// around the tank.
out vec3 tile;   // xy: place in the texture of the caustics. z: 0 at the water surface, 1 at the floor.
out vec3 gain;   // Factor of the light of the caustics.
out vec3 steady; // Light without the caustics.

void main()
{
    int column = gl_VertexID >> 1;
    int side = column / WALL_COLUMNS;
    float along = 2.0 * float(column - side * WALL_COLUMNS) / float(WALL_COLUMNS) - 1.0;
    vec2 place = side == 0 ? vec2(along, -1.0) : side == 1 ? vec2(1.0, along)
        : side == 2 ? vec2(-along, 1.0) : side == 3 ? vec2(-1.0, -along) : vec2(-1.0);
    float down = float(gl_InstanceID + (gl_VertexID & 1)) / float(WALL_ROWS);
    vec3 world = vec3(place.x, -down, place.y) * tank.xyz;
    float shade = shades_at(world).x;
    // A shade on a wall absorbs only a part of the light, because light also comes from the sides.
    float dim = down * down * (3.0 - 2.0 * down);
    vec3 base = vinyl.rgb * (0.86 - 0.24 * dim) * (1.0 - shade * vec3(0.92, 0.84, 0.76));
    vec3 left = water_passes(world.y * -1.2);
    vec3 lamps = lamp_light(world);
    base *= left * lamps;
    gain = base * (evening.w * (1.0 - 0.6 * dim));
    steady = base * 0.60 + WATER_COLOR * (1.0 - 0.5 * shade) * (1.0 - left) * lamps;
    tile = vec3((world.xz + world.y * 0.7) * (CAUSTIC_TILES * 0.92), down);
    gl_Position = view_projection * vec4(world, 1.0);
}
