// The air stone (instance 0), its hose (the next HOSE_PARTS instances), and its bubbles. The stone
// and each bubble are squares that face the viewer. A bubble rises for half a second and drifts
// sideways. Every third bubble then floats on the surface for a while and bursts. The hose leads
// from the stone over the rim of the tank.
uniform vec3 stone;
out vec2 corner;
out float grey;     // 1 for the stone, 0 for a bubble, and 2 for the hose.
out float high_m;   // Height of the hose above the water.
out float whole;    // Visibility of the bubble, from 1 to 0 when it bursts.

const float HOSE_M = 0.0030; // Radius of the hose.
const float STONE_M = 0.011;
const float RISES_M_S = 0.24;
const float FLOATS_S = 0.55;

float chance(float seed)
{
    return fract(sin(seed * 12.9898) * 43758.5453);
}

// Returns the point at the fraction t of a cubic Bezier curve.
vec3 bezier(vec3 a, vec3 b, vec3 c, vec3 d, float t)
{
    float s = 1.0 - t;
    return (s * s * s) * a + (3.0 * s * s * t) * b + (3.0 * s * t * t) * c + (t * t * t) * d;
}

// Returns point `part` of the hose, from 0 at the stone to HOSE_PARTS on the counter. The hose has
// three curves of the same number of parts: from the stone to the top above the rim, down to the
// counter, and along the counter. Each curve begins in the direction in which the curve before ends.
vec3 hose(int part)
{
    const int CURVE = HOSE_PARTS / 3;
    float wall = -tank.x;
    // On a portrait screen the street is behind this wall, and the hose leads past the corner.
    vec3 way = abs(shade_map.z) < 0.5 ? vec3(-0.05, 0.0, -1.0) : vec3(-1.0, 0.0, 0.25);
    vec3 top = vec3(wall - 0.022, tank.w + 0.022, stone.z);
    vec3 land = top + 0.16 * way;
    land.y = -0.008;
    if (part <= CURVE) {
        vec3 foot = stone + vec3(0.0, 0.6 * STONE_M, 0.0);
        return bezier(foot, vec3(wall + 0.012, 0.0, stone.z), top - 0.022 * way, top,
                      float(part) / float(CURVE));
    }
    if (part <= 2 * CURVE) {
        return bezier(top, top + 0.08 * way, land - 0.05 * way, land,
                      float(part - CURVE) / float(CURVE));
    }
    return bezier(land, land + 0.05 * way, land + vec3(0.48 * way.x, 0.0, 0.9 * way.z),
                  land + vec3(0.72 * way.x, 0.0, 1.2 * way.z), float(part - 2 * CURVE) / float(CURVE));
}

void hose_quad(int part)
{
    vec3 from = hose(part);
    vec3 to = hose(part + 1);
    vec3 at = mix(from, to, corner.y * 0.5 + 0.5);
    vec3 across = normalize(cross(to - from, eye.xyz - at));
    grey = 2.0;
    whole = 1.0;
    high_m = at.y;
    gl_Position = view_projection * vec4(at + across * (corner.x * HOSE_M), 1.0);
}

void main()
{
    float id = float(gl_InstanceID);
    corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    if (gl_InstanceID > 0 && gl_InstanceID <= HOSE_PARTS) {
        hose_quad(gl_InstanceID - 1);
        return;
    }
    high_m = 0.0;
    grey = gl_InstanceID == 0 ? 1.0 : 0.0;
    whole = 1.0;
    vec3 at = stone;
    float radius = STONE_M;
    if (gl_InstanceID > 0) {
        float way = -stone.y / RISES_M_S;
        float life = way + (gl_InstanceID % 3 == 0 ? FLOATS_S : 0.0);
        float turns = eye.w / life + chance(id);
        float age = fract(turns) * life;
        float seed = id * 7.0 + mod(floor(turns), 64.0);
        float rises = min(age / way, 1.0);
        float floats = max(age - way, 0.0) / FLOATS_S;
        float angle = chance(seed) * 6.2832;
        float out_m = (0.003 + 0.011 * rises + 0.014 * floats) * (0.3 + 0.7 * chance(seed + 0.5));
        float sways = 0.0012 * sin(age * 26.0 + seed);
        at += vec3(cos(angle) * out_m + sways, 0.0, sin(angle) * out_m - sways);
        at.y = mix(stone.y + STONE_M * 0.6, -0.0008, rises);
        radius = (0.0009 + 0.0011 * chance(seed + 0.25)) * (0.8 + 0.4 * rises);
        whole = 1.0 - smoothstep(0.85, 1.0, floats);
    }
    vec3 view = normalize(eye.xyz - at);
    vec3 side = normalize(vec3(view.z, 0.0, -view.x));
    vec3 up = cross(view, side);
    gl_Position = view_projection * vec4(at + radius * (corner.x * side + corner.y * up), 1.0);
}
