// The paper of a poi. PRACTICE draws the practice mode, in which the paper's colour shows its
// stress. POOL draws the paper of a poi that carries a pool of water.
in vec2 at;
in vec4 light;                  // As in poi_paper.vert.glsl.
in vec4 water;
in vec4 gleam;
uniform vec4 paper;             // z: 1 in the picture of the objects below the water, otherwise 0. w: danger
                                // that the paper tears, 0 to 1.
uniform vec2 pool;              // y: strength of the water film's reflections, from 0 to 1.
uniform sampler2DArray sheet;   // r: wetness. g: integrity. b: presence of paper. a: stress.
uniform sampler2D fibres;
out vec4 color;

#ifdef PRACTICE
// Returns the colour of a stress between 0 (no load) and 1 (tearing load), from the colour of paper
// over amber and red to a dark red. Brightness falls over the whole range, so that viewers with any
// colour vision can read it. The ramp is the one in ui_tear.c.
//
// The ramp uses the square root of the stress, because most loads are about a tenth of the tearing
// load. Half of the tearing load, which paper withstands for a minute, is red.
vec3 heat(float stress)
{
    float t = sqrt(stress);
    vec3 c = mix(vec3(1.0, 0.95, 0.85), vec3(0.98, 0.66, 0.16), smoothstep(0.05, 0.40, t));
    c = mix(c, vec3(0.82, 0.17, 0.09), smoothstep(0.36, 0.70, t));
    return mix(c, vec3(0.24, 0.02, 0.08), smoothstep(0.70, 1.0, t));
}
#endif

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
    // Some of the torn paper is left as flaps, which reach into the hole.
    float flap = clamp(0.25 + 0.9 * sin(at.x * 23.0 + 2.0 * fibre) * sin(at.y * 19.0 + 1.0), 0.0, 1.0);
    float edge = 0.5 - 0.42 * flap;
    if (solid < edge || light.w * paper.z > 0.0) { // Only the paper below the water surface belongs to
                                                  // the picture below the surface.
        discard;
    }
    // Water spreads along the fibres, so that the front of wet paper is soft and uneven.
    float spread = 4.0 * cell.r * (1.0 - cell.r);
    float wet = smoothstep(0.05, 0.75, cell.r + 0.45 * spread * (fibre - 0.5));
    float worn = 1.0 - cell.g;
    float thin = smoothstep(0.10, 0.85, worn);
    // Torn paper curls. Its edge is bright, and the fold behind the edge is darker.
    float torn = 1.0 - step(0.995, cell.b);
    float lip = (1.0 - smoothstep(edge, edge + 0.16, solid)) * torn;
    float fold = clamp(1.0 - abs(solid - 0.72) * (1.0 / 0.24), 0.0, 1.0) * torn;
    vec3 dry = vec3(1.0, 0.975, 0.925) * (0.80 + 0.32 * fibre);
    vec3 soaked = vec3(0.74, 0.83, 0.85) * (0.74 + 0.46 * fibre);
    vec3 tint = mix(dry, soaked, wet);
    float alpha = mix(0.95, 0.34 + 0.32 * fibre, wet) * (1.0 - (0.15 + 0.35 * thin) * worn * wet);
    tint *= (1.0 - thin * vec3(0.22, 0.20, 0.18)) * (1.0 - 0.07 * spread);
#ifdef PRACTICE
    tint = mix(dry, heat(cell.a) * (0.62 + 0.66 * fibre), 0.88 + 0.10 * wet);
    float front = abs(cell.r - 0.4) / max(fwidth(cell.r), 0.004); // Distance from the border
                                                                  // between wet and dry paper.
    tint *= 0.45 + 0.55 * smoothstep(0.7, 1.7, front);
    alpha = 0.92 - (0.30 - 0.22 * fibre) * wet;
#endif
    tint *= light.x * (1.0 - paper.w * (0.40 + 0.24 * worn)); // Paper in danger is darker, most
                                                              // where worn.
    float hangs = 1.0 - smoothstep(edge, 0.66, solid); // A flap turns away from the light.
    tint *= (1.0 - 0.30 * fold) * (1.0 - 0.22 * hangs * torn) * (1.0 - 0.55 * light.y);
    tint = mix(tint, vec3(1.0, 0.98, 0.95), 0.40 * lip);
    alpha += 0.30 * light.y * (1.0 - alpha);
    alpha = mix(alpha, 0.95, max(0.8 * lip, 0.35 * fold));
    // In air, wet paper is less transparent than in water.
    alpha += (1.0 - paper.z) * alpha * (1.0 - alpha) * 0.9;
    // Water on the paper consists of a film, which shines with the fibres, and a level pool. The
    // pool is darker where it is deeper and has a bright edge where it meets the paper.
    float above = step(0.0, light.w);
    float film = pool.y * wet;
    float shine = light.z * light.z;
    shine *= shine; shine *= shine; shine *= shine;
    float glints = 0.35 * shine * wet;
#ifdef POOL
    float deep = above * max(water.a, 0.0);
    float pooled = smoothstep(0.0, 0.0004, deep);
    film *= 1.0 - pooled;
    glints *= 1.0 - 0.71 * pooled;
    vec2 ripple = vec2(0.10 * sin(at.y * 21.0 + eye.w * 3.0 + 4.0 * frayed),
                       0.08 * sin(at.x * 26.0 - eye.w * 2.3 + 3.0 * fibre));
    float mirror = pooled * fifth_powers(dot(gleam.xy, ripple) + gleam.z * (1.0 - 0.5 * dot(ripple, ripple)));
    glints += 0.30 * mirror * mirror + 0.16 * pooled * (1.0 - smoothstep(0.0004, 0.0013, deep));
    tint *= mix(vec3(1.0), vec3(0.70, 0.90, 0.96), pooled * (1.0 - exp(-260.0 * deep)));
    tint += pooled * gleam.w * vec3(0.75, 0.90, 1.0);
    alpha = mix(alpha, max(alpha, 0.80), pooled * 0.6);
#endif
    // The fibres change the slope of the film by up to 0.05.
    float gloss = film * fifth_powers(light.z + 0.10 * dot(gleam.xy, vec2(fibre - 0.5, frayed)));
    glints += 0.25 * gloss * gloss;
#ifdef PRACTICE
    glints *= 0.25; // The reflections are weaker while the paper shows its stress, because bright
                    // paper then has little stress.
    tint += min(glints, 0.08) * above;
#else
    tint += min(glints, 0.32) * above;
#endif
    color = vec4(mix(WATER_COLOR, tint, water.rgb) * alpha, alpha);
}
