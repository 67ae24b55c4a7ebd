in vec3 world;
in vec3 face;
in vec2 at;
uniform vec4 paper;             // z: 1 in the practice mode, in which the paper's colour shows its
                                // stress, otherwise 0. w: danger that the paper tears, 0 to 1.
uniform vec2 pool;              // x: world height of the pool on the paper. y: thickness of the
                                // water film.
uniform vec4 rests[2];          // Fish on this paper. xyz: centre. w: length in m; 0 means no fish.
uniform vec3 spines[2];
uniform sampler2DArray sheet;   // r: wetness. g: integrity. b: presence of paper. a: stress.
uniform sampler2D fibres;
out vec4 color;

// Returns the soft shadow of a fish on the paper, which makes the fish appear to lie on the paper.
float shade(vec4 rest, vec3 spine)
{
    vec3 d = world - rest.xyz + vec3(0.10, 0.0, -0.02) * rest.w; // The shadow is shifted to the
                                                                 // side, where it is visible.
    float along = dot(d, spine);
    float across = length(d - spine * along);
    return (1.0 - smoothstep(0.12, 0.40, across / max(rest.w, 1e-4)))
        * (1.0 - smoothstep(0.34, 0.62, abs(along) / max(rest.w, 1e-4)));
}

// Returns the colour of a stress between 0 (no load) and 1 (tearing load). Brightness rises over
// the whole range, so that viewers with any colour vision can read it. The ramp is the one in
// ui_shader.c.
//
// The ramp uses the square root of the stress, because most loads are about a tenth of the tearing
// load. Half of the tearing load, which paper withstands for a minute, is yellow.
vec3 heat(float stress)
{
    float t = sqrt(stress);
    vec3 c = mix(vec3(0.12, 0.18, 0.62), vec3(0.20, 0.66, 0.30), smoothstep(0.05, 0.36, t));
    c = mix(c, vec3(0.98, 0.82, 0.16), smoothstep(0.36, 0.66, t));
    return mix(c, vec3(1.0, 1.0, 0.94), smoothstep(0.70, 1.0, t));
}

float fifth_powers(float x)     // Returns x to the 32nd power, the reflection of a lamp in a wet
                                // surface.
{
    x *= x; x *= x; x *= x; x *= x;
    return x * x;
}

void main()
{
    vec4 cell = texture(sheet, vec3(at, paper.y));
    float fibre = texture(fibres, at * 1.7).r;
    float frayed = texture(fibres, at * 3.1 + 0.3).r - 0.5;
    float solid = cell.b + (fibre - 0.5) * 0.45 + frayed * 0.5;
    if (solid < 0.5) {
        discard;
    }
    float wet = smoothstep(0.05, 0.75, cell.r);
    float worn = 1.0 - cell.g;
    // Torn paper curls. Its edge is bright, and the fold behind the edge is darker.
    float lip = (1.0 - smoothstep(0.5, 0.72, solid)) * (1.0 - step(0.995, cell.b));
    float fold = smoothstep(0.60, 0.82, solid) * (1.0 - smoothstep(0.82, 1.0, solid))
        * (1.0 - step(0.995, cell.b));
    vec3 view = normalize(eye.xyz - world);
    vec3 n = normalize(face);
    n *= sign(dot(n, view)); // The normal is turned to the face that the viewer sees.
    float lit = 0.66 + 0.40 * max(dot(n, LAMP_DIRECTION), 0.0);
    lit *= 1.0 - 0.7 * shade_above(world);
    vec3 dry = vec3(1.0, 0.975, 0.925) * (0.80 + 0.32 * fibre);
    vec3 soaked = vec3(0.74, 0.83, 0.85) * (0.74 + 0.46 * fibre);
    vec3 load = mix(dry, heat(cell.a) * (0.62 + 0.66 * fibre), 0.88 + 0.10 * wet);
    float front = abs(cell.r - 0.4) / max(fwidth(cell.r), 0.004); // Distance from the border
                                                                  // between wet and dry paper.
    load *= 0.45 + 0.55 * smoothstep(0.7, 1.7, front);
    vec3 tint = mix(mix(dry, soaked, wet), load, paper.z) * lit;
    tint *= 1.0 - paper.w * mix(0.45, 0.85, worn); // Paper in danger is darker, most where worn.
    float dark = max(shade(rests[0], spines[0]), shade(rests[1], spines[1]));
    tint *= (1.0 - 0.30 * fold) * (1.0 - 0.55 * dark);
    tint = mix(tint, vec3(1.0, 0.98, 0.95), 0.55 * lip);
    float alpha = mix(0.95, 0.34 + 0.32 * fibre, wet) * (1.0 - 0.28 * worn * wet);
    alpha = mix(alpha, 0.92 - (0.30 - 0.22 * fibre) * wet, paper.z);
    alpha += 0.30 * dark * (1.0 - alpha);
    alpha = mix(alpha, 0.95, max(0.8 * lip, 0.35 * fold));
    // Water on the paper consists of a film, which shines with the fibres, and a level pool. The
    // pool is darker where it is deeper and has a bright edge where it meets the paper.
    float above = step(0.0, world.y);
    vec3 lamp = normalize(view + LAMP_DIRECTION);
    float deep = above * max(pool.x - world.y, 0.0);
    float pooled = smoothstep(0.0, 0.0004, deep);
    float edge = pooled * (1.0 - smoothstep(0.0004, 0.0013, deep));
    float film = above * smoothstep(0.0, 0.0004, pool.y) * wet * (1.0 - pooled);
    vec3 skin = normalize(n + vec3(fibre - 0.5, 0.0, frayed) * 0.10);
    float gloss = film * fifth_powers(max(dot(skin, lamp), 0.0));
    vec3 ripple = normalize(vec3(0.10 * sin(at.y * 21.0 + eye.w * 3.0 + 4.0 * frayed), 1.0,
                                 0.08 * sin(at.x * 26.0 - eye.w * 2.3 + 3.0 * fibre)));
    float mirror = pooled * fifth_powers(max(dot(ripple, lamp), 0.0));
    mirror *= mirror;
    float away = 1.0 - max(view.y, 0.0);
    tint *= mix(vec3(1.0), vec3(0.70, 0.90, 0.96), pooled * (1.0 - exp(-260.0 * deep)));
    alpha = mix(alpha, max(alpha, 0.80), pooled * 0.6);
    tint += pooled * (0.02 + 0.5 * away * away * away) * vec3(0.75, 0.90, 1.0);
    float shine = max(dot(n, lamp), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine;
    float glints = shine * wet * above * (0.35 - 0.25 * pooled);
    glints += 0.25 * gloss * gloss + 0.30 * mirror + 0.16 * edge;
    tint += min(glints, 0.32) * (1.0 - 0.75 * paper.z); // The reflections are weaker while the
                                                        // paper shows its stress, because white is
                                                        // then a stress colour.
    vec3 left = water_passes(-world.y * 1.2);
    color = vec4(mix(WATER_COLOR, tint, left) * alpha, alpha);
}
