// The paper of a poi, a disc that sags under its load. Worn paper sags deeper, and torn flaps hang
// down. The light that changes little between two vertices is computed here.
layout(location = 0) in vec2 position;  // Position in ring radii. y increases toward the handle.
uniform mat4 pose;
uniform vec4 paper;                     // x: sag in ring radii. y: layer of `sheet`.
uniform vec2 pool;                      // x: world height of the pool on the paper.
uniform vec4 rests[2];                  // Fish on this paper. xyz: centre. w: length in m; 0 means
                                        // no fish.
uniform vec3 spines[2];
uniform sampler2DArray sheet;           // As in poi_sheet_cells().
out vec3 at;        // xy: place in `sheet`. z: strength of the water line, which a level ring lacks.
out vec4 light;     // x: brightness. y: nearness of a fish on the paper. z: cosine of the angle
                    // between the normal and the direction halfway to the lamps. w: distance to the
                    // water line along the paper in m, positive in air.
out vec4 water;     // rgb: fraction of the light that passes through the water. a: depth of the pool.
out vec4 gleam;     // xy: change of light.z for each unit of slope. z: the same for a level surface.
                    // w: brightness of the sky's reflection in the pool.

// Returns how a fish changes the paper. x: nearness of the fish, which falls from 1 at its middle to
// 0. y: brightness of the dent's walls and creases, relative to level paper.
vec2 dent(vec3 world, vec3 up, vec4 rest, vec3 spine)
{
    vec3 d = (world - rest.xyz) / max(rest.w, 1e-4);
    float over = -dot(d, up);
    d += up * over; // Distance in the plane of the paper.
    float along = dot(d, spine);
    vec3 side = d - spine * along;
    float ends = 1.0 - smoothstep(0.30, 0.66, abs(along));
    // The shadow is shifted to the side, where it is visible, and fades below a leaping fish.
    float near = max(1.0 - 1.6 * length(side + (0.04 + 0.3 * abs(over)) * vec3(1.0, 0.0, -0.3)), 0.0) * ends
        * (1.0 - smoothstep(0.16, 0.50, abs(over)));
    float wall = 4.0 * near * (1.0 - near);
    vec3 away = side / max(length(side), 1e-4);
    return vec2(near, wall * (0.45 * sin(26.0 * along) - dot(away, vec3(0.75, 0.0, 0.55))));
}

const float FLAP_RADII = 0.55;          // Drop of a flap of torn paper whose distance to the edge
                                        // is 1, in ring radii.
const float SAG_SHOWN = 2.2;            // The sag is drawn larger than computed, because 1 or 2 mm
                                        // are not visible.

void main()
{
    float r2 = dot(position, position);
    at.xy = position * 0.5 + 0.5;
    vec4 cell = textureLod(sheet, vec3(at.xy, paper.y), 0.0);
    float soft = cell.r * (1.0 - cell.g);
    float belly = 1.0 - r2;
    float extra = ((SAG_SHOWN - 1.0) * paper.x + 0.05 * soft) * belly;
    vec3 local = vec3(position.x, -paper.x * belly - extra, position.y);
    vec3 world = (pose * vec4(local, 1.0)).xyz;
    float pooled = world.y + extra * pose[1].y; // Height of the sag that the pool is computed from.
    // A flap hangs down. In water it hangs less, and moves.
    float hangs = cell.a * min((1.0 - cell.b) * 8.0, 1.0);
    float sways = world.y < 0.0 ? 0.5 + 0.2 * sin(eye.w * 3.0 + 9.0 * position.x) : 1.0;
    float radius_m = length(pose[0].xyz);
    world.y -= hangs * sways * FLAP_RADII * radius_m;
    vec3 up = pose[1].xyz / radius_m;
    vec2 dents = dent(world, up, rests[0], spines[0]) + dent(world, up, rests[1], spines[1]);
    // Loaded paper is pulled into the middle, and wrinkles run from the ring toward the middle.
    float loaded = clamp(abs(paper.x) * 22.0, 0.0, 1.0) * (0.4 + 0.6 * cell.r);
    float around = atan(position.y, position.x);
    float wrinkle = (sin(9.0 * around + 3.0 * sin(around)) + 0.8 * sin(14.0 * around + 4.0)) * r2 * r2 * belly;
    vec2 slope = -2.0 * SAG_SHOWN * paper.x * position;
    vec3 view = normalize(eye.xyz - world);
    vec3 n = normalize(mat3(pose) * vec3(slope.x, 1.0, slope.y));
    n *= sign(dot(n, view)); // The normal is turned to the face that the viewer sees.
    vec3 middle = normalize(view + LAMP_DIRECTION);
    float away = 1.0 - max(view.y, 0.0);
    light.x = 0.66 + 0.40 * max(dot(n, LAMP_DIRECTION), 0.0);
    // The lower middle is darker, and the side of the belly that faces the lamps is brighter.
    light.x *= 1.0 + loaded * (0.34 * wrinkle - 0.21 * belly * belly - dot(position, vec2(0.17, 0.10)));
    light.x *= 1.0 - 0.7 * shade_above(world);
    light.x *= 1.0 + 0.36 * dents.y;
    light.y = min(dents.x, 1.0);
    light.z = max(dot(n, middle), 0.0);
    light.w = world.y / max(length(n.xz), 0.1);
    at.z = clamp(length(pose[1].xz) / radius_m * 5.0 - 0.75, 0.0, 1.0);
    // Paper in the water is darker and bluer.
    vec3 dims = clamp(-light.w * 300.0, 0.0, 1.0) * at.z * vec3(0.30, 0.14, 0.08);
    water = vec4(water_passes(-world.y * 1.2) * (1.0 - dims), pool.x - pooled);
    gleam = vec4(middle.xz, middle.y, 0.02 + 0.5 * away * away * away);
    gl_Position = view_projection * vec4(world, 1.0);
}
