// Colours of a wakin: grey-green when young, then red, orange and white in its own pattern.
in vec4 skin;
in vec3 gain;
in vec3 haze;
flat in vec4 traits;
uniform sampler2DArray patterns;
out vec4 color;

const vec3 WHITE = vec3(1.0, 0.955, 0.90);
const vec3 FRY = vec3(0.40, 0.42, 0.27);

vec3 red_of(float hue)
{
    return mix(vec3(1.0, 0.085, 0.015), vec3(1.0, 0.40, 0.03), hue * hue * hue);
}

// Young fish lose their grey in patches, from the belly up.
float turned(float ahead)
{
    return smoothstep(0.10, 0.42, traits.x + ahead);
}

#ifdef FIN
void main()
{
    float root = 1.0 - skin.y;
    float rays = 0.5 + 0.5 * sin(skin.x * 62.0 + traits.z * 6.0);
    float stained = smoothstep(0.30, 0.72, fract(traits.z * 7.7 + skin.z * 0.37)
        + 0.20 * sin(skin.x * 9.0 + traits.y * 20.0) + 0.25 * root);
    vec3 tint = mix(WHITE, red_of(traits.y), stained);
    tint = mix(FRY * 1.25, tint, turned(0.0));
    tint = mix(tint, WHITE, 0.22 * skin.y) * (0.90 + 0.22 * rays);
    float alpha = mix(0.42, 0.93, root * root) * (0.72 + 0.28 * rays);
    alpha *= 1.0 - smoothstep(0.86 + 0.10 * rays, 1.0, skin.y) * 0.75;
    color = vec4((tint * gain + haze) * alpha, alpha);
}
#else
void main()
{
    if (skin.w > 0.5) { // PART_EYE: u runs from the pupil's middle to the socket.
        float pupil = smoothstep(0.62, 0.50, skin.x);
        vec3 iris = mix(vec3(0.86, 0.62, 0.20), vec3(0.78, 0.78, 0.72), traits.z);
        color = vec4(mix(iris, vec3(0.015), pupil) * gain + haze, 1.0);
        return;
    }
    vec2 pattern = texture(patterns, vec3(skin.xy, skin.z)).rg;
    float under = 1.0 - abs(skin.y * 2.0 - 1.0);        // 0 at the back, 1 at the belly.
    float belly = smoothstep(0.52, 0.96, under);
    vec3 red = red_of(traits.y);
    vec3 adult = mix(WHITE, red, pattern.r);
    adult = mix(adult, mix(WHITE, red, 0.25), 0.55 * belly);
    vec3 young = mix(FRY * (0.62 + 0.38 * under), vec3(0.80, 0.80, 0.66), belly);
    vec3 tint = mix(young, adult, turned(0.10 * belly + 0.12 * (pattern.r - 0.5)));
    float scales = mix(pattern.g, 0.75, 0.7 * traits.w);
    tint *= 0.74 + 0.38 * scales;
    float gill = smoothstep(0.225, 0.245, skin.x) * smoothstep(0.285, 0.255, skin.x)
        * smoothstep(0.15, 0.35, under) * (1.0 - belly * 0.6);
    tint *= 1.0 - 0.30 * gill;
    float ridge = smoothstep(0.42, 0.0, under) * smoothstep(0.0, 0.12, skin.x);
    tint += ridge * scales * 0.20;               // Scales on the back throw the lamps' light up.
    color = vec4(tint * gain + haze * (0.45 + 0.75 * scales), 1.0);
}
#endif
