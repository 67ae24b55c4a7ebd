// The paper of a poi. PRACTICE draws the practice mode, in which the paper's colour shows its
// stress. POOL draws the paper of a poi that carries a pool of water.
in vec3 at;                     // As in poi_paper.vert.glsl.
in vec4 light;
in vec4 water;
in vec4 gleam;
uniform vec4 paper;             // z: 1 in the picture of the objects below the water, otherwise 0. w: danger
                                // that the paper tears, 0 to 1.
uniform vec2 pool;              // y: strength of the water film's reflections, from 0 to 1.
uniform sampler2DArray sheet;   // As in poi_sheet_cells().
uniform sampler2D fibres;
out vec4 color;

#ifdef PRACTICE
// Returns the factor for the colour of paper at a stress between 0 (no load) and 1 (tearing load),
// from nearly white over amber and red to a dark red. Brightness falls over the whole range, so
// that viewers with any colour vision can read it. The red and the dark red are those of the ramp
// in ui_tear.c.
//
// The ramp uses the square root of the stress, because most loads are about a tenth of the tearing
// load. Paper with such a load is only slightly warmer than paper without a load. Half of the
// tearing load, which paper withstands for a minute, is red.
vec3 heat(float stress)
{
    float t = sqrt(stress);
    vec3 c = mix(vec3(1.0, 0.97, 0.92), vec3(0.98, 0.70, 0.30), smoothstep(0.26, 0.56, t));
    c = mix(c, vec3(0.82, 0.17, 0.09), smoothstep(0.46, 0.72, t));
    return mix(c, vec3(0.24, 0.02, 0.08), smoothstep(0.72, 1.0, t));
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
    vec4 cell = texture(sheet, vec3(at.xy, paper.y));
    float fibre = texture(fibres, at.xy * 2.3).r;
    float frayed = texture(fibres, at.xy * 4.1 + 0.3).r - 0.5;
    float solid = cell.b + (fibre - 0.5 + 1.4 * frayed) * 0.20;
    // The edge of a hole fades over one pixel.
    float inside = (solid - 0.5) / max(fwidth(solid), 0.004);
    // The picture of the objects below the water contains the paper below the water line. Tilted
    // paper overlaps the line by up to 1.5 mm, so that no gap shows.
    if (inside < -0.5 || light.w * paper.z > 0.0015 * at.z) {
        discard;
    }
    // Water spreads along the fibres, so that the front of wet paper is soft and uneven.
    float spread = 4.0 * cell.r * (1.0 - cell.r);
    float wet = smoothstep(0.05, 0.75, cell.r + 0.45 * spread * (fibre - 0.5));
    float worn = 1.0 - cell.g;
    float thin = smoothstep(0.10, 0.85, worn);
    // Torn paper is thinner toward its edge, where single fibres stick out. Its flaps are crumpled,
    // with a dark fold where they begin.
    float lip = 1.0 - smoothstep(0.5, 0.68, solid);
    float flap = clamp(min((1.0 - cell.b + 0.06 * frayed) * 7.0, cell.a * 10.0), 0.0, 1.0);
#ifdef PRACTICE
    flap *= step(cell.b, 0.99); // On whole paper, cell.a is the stress.
#endif
    float fold = 4.0 * flap * (1.0 - flap);
    float grain = 0.84 + 0.26 * fibre;
    vec3 dry = vec3(1.0, 0.975, 0.925) * grain;
    vec3 soaked = vec3(0.80, 0.86, 0.87) * grain;
    vec3 tint = mix(dry, soaked, wet);
    // Paper in danger is thinner and wetter, most where worn.
    float danger = paper.w * (0.5 + 0.5 * worn);
    float alpha = mix(0.95, 0.42 + 0.24 * fibre, wet) * (1.0 - (0.15 + 0.35 * thin) * worn * wet - 0.30 * danger);
#ifdef PRACTICE
    tint *= heat(cell.a * step(0.99, cell.b));
    alpha = max(alpha, 0.70 + 0.20 * fibre);
    float front = abs(cell.r - 0.4) / max(fwidth(cell.r), 0.004); // Distance from the border
                                                                  // between wet and dry paper.
    tint *= 0.60 + 0.40 * smoothstep(0.7, 1.7, front);
#endif
    tint *= 1.0 - (0.20 * thin + 0.07 * spread);
    tint *= 1.0 - danger * vec3(0.16, 0.22, 0.32);
    tint = mix(tint, vec3(0.90, 0.92, 0.91) * grain, 0.75 * flap) * (1.0 - 0.25 * fold);
    // A fish presses the paper wet around it, and its shadow touches it.
    float pressed = min(light.y * 2.8, 1.0);
    float touched = clamp(light.y * 2.8 - 1.1, 0.0, 1.0);
    tint *= light.x * (1.0 - 0.22 * pressed - 0.50 * touched);
    alpha *= 1.0 - 0.35 * pressed;
    alpha += 0.55 * touched * (1.0 - alpha);
    alpha = mix(alpha, 0.60 + 0.6 * frayed, flap) * (1.0 - lip * (0.9 - 0.8 * fibre));
    alpha *= clamp(inside + 0.5, 0.0, 1.0);
    // In air, wet paper is less transparent than in water.
    alpha += (1.0 - paper.z) * clamp(light.w * 60.0, 0.0, 0.9) * alpha * (1.0 - alpha);
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
    glints += 0.30 * mirror * mirror + 0.07 * pooled * (1.0 - smoothstep(0.0004, 0.0013, deep));
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
    // The water climbs on the fibres where its surface meets the paper.
    float line = max(1.0 - abs(light.w - 0.004 * frayed) * 300.0, 0.0) * (0.10 + 0.95 * fibre) * at.z;
    color = vec4(mix(WATER_COLOR, tint, water.rgb) * alpha, alpha)
        + line * (1.0 - alpha * 0.5) * vec4(0.88, 0.96, 1.0, 1.0);
}
