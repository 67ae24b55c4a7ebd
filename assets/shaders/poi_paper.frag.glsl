in vec3 world;
in vec3 face;
in vec2 at;
uniform vec4 paper;
uniform vec4 rests[2];          // Fish on this paper: middle, length in m.
uniform vec3 spines[2];
uniform sampler2DArray sheet;   // r: wetness, g: integrity, b: paper is there.
uniform sampler2D fibres;
out vec4 color;

// The shade under a fish, soft and close: it is what makes it lie on the paper.
float shade(vec4 rest, vec3 spine)
{
    vec3 d = world - rest.xyz + vec3(0.10, 0.0, -0.02) * rest.w; // Aside, where it shows.
    float along = dot(d, spine);
    float across = length(d - spine * along);
    return (1.0 - smoothstep(0.12, 0.40, across / max(rest.w, 1e-4)))
        * (1.0 - smoothstep(0.34, 0.62, abs(along) / max(rest.w, 1e-4)));
}

void main()
{
    vec3 cell = texture(sheet, vec3(at, paper.y)).rgb;
    float fibre = texture(fibres, at * 1.7).r;
    float frayed = texture(fibres, at * 3.1 + 0.3).r - 0.5;
    float solid = cell.b + (fibre - 0.5) * 0.45 + frayed * 0.5;
    if (solid < 0.5) {
        discard;
    }
    float wet = smoothstep(0.05, 0.75, cell.r);
    float worn = 1.0 - cell.g;
    // Torn paper curls: its lip catches light, and the fold behind it keeps some shade.
    float lip = (1.0 - smoothstep(0.5, 0.72, solid)) * (1.0 - step(0.995, cell.b));
    float fold = smoothstep(0.60, 0.82, solid) * (1.0 - smoothstep(0.82, 1.0, solid))
        * (1.0 - step(0.995, cell.b));
    vec3 n = normalize(face);
    vec3 view = normalize(eye.xyz - world);
    float lit = 0.66 + 0.40 * max(dot(n, LAMP_DIRECTION), 0.0);
    lit *= 1.0 - 0.7 * shade_at(world, bend.z);
    vec3 dry = vec3(1.0, 0.975, 0.925) * (0.80 + 0.32 * fibre);
    vec3 soaked = vec3(0.74, 0.83, 0.85) * (0.74 + 0.46 * fibre);
    vec3 tint = mix(dry, soaked, wet) * lit;
    float dark = max(shade(rests[0], spines[0]), shade(rests[1], spines[1]));
    tint *= (1.0 - 0.30 * fold) * (1.0 - 0.55 * dark);
    tint = mix(tint, vec3(1.0, 0.98, 0.95), 0.55 * lip);
    float alpha = mix(0.95, 0.34 + 0.32 * fibre, wet) * (1.0 - 0.28 * worn * wet);
    alpha += 0.30 * dark * (1.0 - alpha);
    alpha = mix(alpha, 0.95, max(0.8 * lip, 0.35 * fold));
    float shine = max(dot(n, normalize(view + LAMP_DIRECTION)), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine;
    float above = step(0.0, world.y);
    tint += shine * wet * above * 0.35;
    vec3 left = water_passes(-world.y * 1.2);
    color = vec4(mix(WATER_COLOR, tint, left) * alpha, alpha);
}
