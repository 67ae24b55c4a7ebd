// The shade map: circular shadows of the hand-held fans and of the dry pois, seen from above
// (shades_at() in common.glsl).
in vec2 at;
uniform vec4 circles[8]; // Centre x and z in m, radius in m, and darkness. The fans come first.
uniform vec2 counts;     // Number of fans, and number of all circles.
out vec4 color;

const vec2 BORDER = vec2(0.01); // Width of the border without shade, because the border's texels
                                // are repeated outside the map.

void main()
{
    vec2 place = (at - 0.5) / shade_map.xy;
    vec2 blur = vec2(0.010, 0.010 + 0.10 * tank.y); // At the water surface, and at the floor.
    vec4 light = vec4(1.0);
    for (int i = 0; i < int(counts.y); i++) {
        float r = length(place - circles[i].xy);
        vec2 left = 1.0 - circles[i].w
            * (1.0 - smoothstep(circles[i].z - blur, circles[i].z + blur, vec2(r)));
        light.zw *= left;
        light.xy *= i < int(counts.x) ? left : vec2(1.0);
    }
    vec2 inside = step(BORDER, at) * step(BORDER, 1.0 - at);
    color = (1.0 - light) * (inside.x * inside.y);
}
