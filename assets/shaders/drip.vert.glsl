// Water that runs off a wet poi. The first LOOSE drops detach one at a time from the low side of the
// poi. The further drops form streams from fixed points of the ring. Each drop falls freely and
// disappears at the water. The number of drops increases with the water on the paper.
uniform vec4 lip;           // Position where drops detach. w: number of loose drops.
uniform vec4 hub;           // Centre of the ring. w: half the angle of the ring with streams.
uniform vec4 low;           // Radius of the ring toward its low side. w: number of stream drops.
uniform vec4 across;        // Radius of the ring at a right angle to `low`.
out vec2 corner;
out float shown;

const int LOOSE = 5;
const float STREAMS = 9.0;
// Periods in seconds after which a loose drop and a drop of a stream begin again. The periods are
// constant: if a period depended on the height of the poi, its drops would jump while the poi moves.
// A drop of a stream reaches the water within its period from a height of at most 0.16 m.
const float LOOSE_S = 0.22;
const float STREAM_S = 0.18;
const float GRAVITY = 9.81;
const float RADIUS_M = 0.0022;

float chance(float seed)
{
    return fract(sin(seed * 12.9898) * 43758.5453);
}

void main()
{
    float id = float(gl_InstanceID);
    bool streams = gl_InstanceID >= LOOSE;
    float turn = (mod(id, STREAMS) - 4.0) * 0.25 * hub.w + 0.12 * sin(eye.w * 3.0 + id * 2.1);
    vec3 at = streams ? hub.xyz + low.xyz * cos(turn) + across.xyz * sin(turn) : lip.xyz;
    float falls = sqrt(2.0 * max(at.y, 0.0) / GRAVITY);
    float period = streams ? STREAM_S : LOOSE_S;
    // Any number of the eight drops of a stream is spread almost evenly over the period.
    float turns = eye.w / period + chance(id) * (streams ? 0.05 : 0.2)
        + (streams ? floor(id / STREAMS) * 0.375 + chance(mod(id, STREAMS)) : id * 0.37);
    float seed = id * 7.0 + mod(floor(turns), 64.0);
    // Time after the start of the fall. The value is negative while a loose drop hangs and grows.
    float age = fract(turns) * period - (streams ? 0.0 : max(period - falls, 0.0));
    float drop = max(age, 0.0);
    corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    shown = clamp(streams ? low.w - id + float(LOOSE) : lip.w - id, 0.0, 1.0) * step(drop, falls);
    vec3 spread = vec3(chance(seed) - 0.5, 0.0, chance(seed + 0.5) - 0.5) * 0.014;
    at += spread * (streams ? 0.45 : 1.0);
    at.y -= 0.5 * GRAVITY * drop * drop;
    float swells = (0.55 + 0.6 * chance(seed + 0.2)) * (streams ? 1.0 : smoothstep(-0.25, 0.0, age));
    float long_ = 1.15 + min(GRAVITY * drop, 1.0) * 0.75; // A falling drop is stretched a little by
                                                          // its speed, as by motion blur.
    vec3 view = normalize(eye.xyz - at);
    vec3 side = normalize(vec3(view.z, 0.0, -view.x));
    vec3 up = cross(view, side);
    gl_Position = view_projection
        * vec4(at + RADIUS_M * swells * (corner.x * side + corner.y * long_ * up), 1.0);
}
