// A round fan (uchiwa): paper on split bamboo, with a painted goldfish over indigo ripples. The fan
// is out of the camera's focus, so that every edge is slightly soft.
//
// The shader draws two pictures side by side, once while the program loads, because it has many
// instructions: the fan, and the weight of the player's colour (r).
in vec2 at;
uniform sampler2D fibres;
out vec4 color;

const vec2 LOW = vec2(-1.15, -1.15); // As in fan.vert.glsl.
const vec2 HIGH = vec2(1.15, 2.35);

const float SOFT = 0.022;      // Half the width of the blur, in fan radii, which stands for 2 mm.
const vec2 FORK = vec2(0.0, 1.06); // Point where the ribs leave the handle, in fan radii.
const vec3 BAMBOO = vec3(0.80, 0.62, 0.36);
const vec3 WASHI = vec3(0.985, 0.955, 0.885);
const vec3 INDIGO = vec3(0.13, 0.25, 0.52);
const vec3 VERMILION = vec3(0.90, 0.13, 0.06);

float ink(float distance)
{
    return 1.0 - smoothstep(-SOFT, SOFT, distance);
}

// Returns a brush stroke from `root` in direction `way` (a unit vector). The stroke widens to
// `width` and ends in a point.
float leaf(vec2 p, vec2 root, vec2 way, float reach, float width, float bend)
{
    vec2 d = p - root;
    float t = dot(d, way) / reach;
    float side = dot(d, vec2(-way.y, way.x)) - bend * t * t;
    float swell = width * sqrt(max(t, 0.0)) * (1.0 - t * t);
    return max(abs(side) - swell, max(-t, t - 1.0) * reach);
}

vec2 turned(vec2 p, float angle)
{
    float c = cos(angle);
    float s = sin(angle);
    return vec2(c * p.x + s * p.y, c * p.y - s * p.x);
}

// Returns a goldfish seen from above with its nose up. `size` is the distance from snout to tail
// root. rgb: colour, a: coverage.
vec4 goldfish(vec2 place, float angle, float size)
{
    vec2 p = turned(place, angle) / size;
    float soft = SOFT / size;
    vec2 way = vec2(0.0, 1.0);
    float tail = min(leaf(p, vec2(0.0, 0.36), normalize(vec2(0.62, 1.0)), 0.80, 0.20, -0.16),
        leaf(p, vec2(0.0, 0.36), normalize(vec2(-0.62, 1.0)), 0.80, 0.20, 0.16));
    tail = min(tail, leaf(p, vec2(0.0, 0.36), way, 0.62, 0.16, 0.05));
    float fins = min(leaf(p, vec2(0.15, -0.20), normalize(vec2(1.0, 0.75)), 0.42, 0.10, 0.06),
        leaf(p, vec2(-0.15, -0.20), normalize(vec2(-1.0, 0.75)), 0.42, 0.10, -0.06));
    float along = clamp(p.y + 0.5, 0.0, 1.0);
    float girth = 0.27 * sqrt(along) * (1.18 - along) / 0.62 * 0.92 + 0.02;
    float body = max(abs(p.x) - girth, abs(p.y) - 0.5);
    float wash = 1.0 - smoothstep(-soft, soft, min(tail, fins));
    float solid = 1.0 - smoothstep(-soft, soft, body);
    // The paint is like watercolour: darker at a stroke's edge and paler toward the tail's tips.
    float pale = smoothstep(0.35, 1.15, length(p - vec2(0.0, 0.2)));
    vec3 veil = mix(VERMILION, vec3(1.0, 0.62, 0.46), pale);
    float back = smoothstep(0.85, 0.1, abs(p.x) / girth);
    vec3 coat = mix(VERMILION, vec3(1.0, 0.42, 0.20), back * 0.55);
    float patchy = smoothstep(0.10, 0.20, abs(p.y - 0.10 + 0.5 * p.x) + 0.06 * sin(p.x * 23.0));
    coat = mix(WASHI, coat, patchy);
    vec2 eye_at = vec2(abs(p.x) - 0.142, p.y + 0.335);
    float eye = 1.0 - smoothstep(0.022 - 0.5 * soft, 0.030 + 0.9 * soft, length(eye_at));
    vec3 paint = mix(veil, coat, solid);
    paint = mix(paint, vec3(0.05, 0.03, 0.05), eye * solid);
    return vec4(paint, max(wash * (0.92 - 0.55 * pale), solid * 0.97));
}

// Returns concentric half-arcs, like the ripples of a drop. The indigo arcs become thinner as they
// widen.
float ripples(vec2 p, vec2 middle)
{
    float r = length((p - middle) * vec2(1.0, 1.7));
    float lines = abs(fract(r * 5.5) - 0.5) / 5.5;
    float fade = smoothstep(0.62, 0.20, r) * smoothstep(0.04, 0.10, r);
    return (1.0 - smoothstep(0.004, 0.004 + SOFT, lines)) * fade;
}

// Returns the colour at `at` in fan radii. rgb: premultiplied. Writes the weight of the player's
// colour to `trim`.
vec4 fan(vec2 at, out float trim)
{
    float r = length(at);
    vec2 from_fork = at - FORK;
    float ray = atan(from_fork.x, -from_fork.y);
    float reach = length(from_fork);
    float rib = abs(fract(ray * 9.5 + 0.5) - 0.5) / 9.5 * reach;
    float ribs = ink(rib - 0.010 - 0.004 * smoothstep(1.2, 0.2, reach));
    float bow = at.y - 0.70 + 0.20 * at.x * at.x;   // The bent twig that holds the ribs apart.
    float leaf_edge = r - 1.0;
    float paper = ink(max(leaf_edge, bow));
    float open = ink(max(leaf_edge, -bow));
    float twig = ink(abs(bow) - 0.016) * ink(leaf_edge);

    float fibre = texture(fibres, at * 0.9).r;
    vec3 tint = WASHI * (0.98 + 0.09 * fibre);
    tint = mix(tint, BAMBOO * 0.95, 0.30 * ribs);     // The ribs are visible through the paper.
    // A pale blue wash becomes stronger toward the bottom.
    tint = mix(tint, vec3(0.50, 0.78, 0.95), 0.62 * smoothstep(-0.55, 0.80, at.y + 0.12 * at.x));
    tint = mix(tint, INDIGO, 0.62 * ripples(at, vec2(-0.46, 0.36)));
    tint = mix(tint, INDIGO, 0.50 * ripples(at, vec2(0.56, -0.40)));
    float weed = min(leaf(at, vec2(0.62, 0.62), normalize(vec2(0.12, -1.0)), 0.75, 0.055, 0.16),
        leaf(at, vec2(0.70, 0.58), normalize(vec2(0.25, -1.0)), 0.52, 0.045, -0.12));
    tint = mix(tint, vec3(0.20, 0.50, 0.33), 0.72 * ink(weed));
    vec4 small = goldfish(at - vec2(0.38, 0.16), -0.75, 0.36);
    tint = mix(tint, small.rgb, small.a);
    vec4 large = goldfish(at - vec2(-0.16, -0.16), 0.62, 0.66);
    tint = mix(tint, large.rgb, large.a);
    float rim = ink(abs(leaf_edge + 0.030) - 0.028);
    tint *= 1.0 - 0.92 * rim;           // The player's colour is added by fan.frag.glsl.

    // The handle is a round stick, dark at its sides, with nodes in the bamboo and a cord at its
    // end.
    float grip = 0.062 + 0.012 * smoothstep(1.1, 2.2, at.y);
    vec2 end = vec2(at.x, max(at.y - 2.16, 0.0)); // Rounded end of the handle.
    float stick = max(length(end) - grip, 0.80 - at.y);
    float across = clamp(at.x / grip, -1.0, 1.0);
    float node = smoothstep(0.030, 0.0, abs(fract(at.y * 1.45 + 0.25) - 0.5) * 0.7);
    vec3 wood = BAMBOO * (1.10 - 0.55 * across * across) * (1.0 - 0.22 * node)
        + 0.14 * smoothstep(0.45, 0.0, abs(across + 0.3));
    vec3 rod = BAMBOO * 0.92;

    vec4 sum = vec4(rod, 1.0) * (ribs * open * 0.95);
    float shine = 0.90 + 0.12 * smoothstep(0.9, -0.6, at.x + at.y);  // The paper is brighter on the
                                                                     // side of the lamps.
    sum = vec4(tint * shine, 1.0) * paper + sum * (1.0 - paper);
    float hold = max(twig, ink(stick));
    vec3 hard = mix(rod * 0.85, wood, ink(stick));
    sum = vec4(hard, 1.0) * hold + sum * (1.0 - hold);
    trim = 0.92 * rim * shine * paper * (1.0 - hold);
    return sum;
}

void main()
{
    float trim;
    float picture = floor(at.x * 2.0);
    vec4 painted = fan(mix(LOW, HIGH, vec2(at.x * 2.0 - picture, at.y)), trim);
    color = picture < 0.5 ? painted : vec4(trim, 0.0, 0.0, 0.0);
}
