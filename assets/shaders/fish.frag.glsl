// Skin of a goldfish in the tank. The baked pattern selects between the two colours that the vertex
// shader computed.
in vec4 skin;
in vec3 pale;
in vec3 stain;
in float turned_to;
in vec4 haze;
#ifdef GLOSS
in float gleam;
#endif
#if defined(SUNK) || defined(SNOUT)
in float out_m;
#endif
uniform sampler2DArray patterns;
out vec4 color;

#ifdef FIN
void main()
{
    float rays = abs(fract(skin.x) * 2.0 - 1.0);
    float root = 1.0 - skin.y;
    float alpha = (0.42 + 0.51 * root * root) * (0.70 + 0.30 * rays);
    // The fin's edge is frayed.
    alpha *= 1.0 - 0.75 * clamp((skin.y - 0.86 - 0.08 * rays) * 12.0, 0.0, 1.0);
    alpha *= 2.0 - alpha; // A fin has two sides of this opacity.
    color = vec4((stain * (0.90 + 0.22 * rays) + haze.rgb) * alpha, alpha);
}
#else
void main()
{
#ifdef SUNK
    if (out_m > 0.0) { // A snout above the surface must not also be drawn in the picture that is
                       // seen through the water.
        discard;
    }
#endif
    vec2 pattern = texture(patterns, skin.xyz).rg;
    // In an eye, u runs from the pupil to the socket. A gold ring surrounds the dark pupil, and the
    // dome of the eye outside the ring is dark.
    float dome = clamp(abs(skin.x - 0.72) * 9.5 - 0.65, 0.0, 1.0);
    float red = mix(pattern.r, dome, skin.w);
    float scales = pattern.g;
    float gill = haze.w * max(1.0 - abs(skin.x - 0.252) * 45.0, 0.0);
    vec3 tint = mix(pale, stain, red) * ((0.42 + 0.84 * scales) * (1.0 - gill));
    // The skin is darker where it turns away from the viewer.
    float facing = clamp(turned_to * 2.4, 0.0, 1.0);
    tint *= 0.42 + 0.60 * (2.0 - facing) * facing;
#ifdef GLOSS
    // The lamps make a line of gloss on wet skin, which the scales break.
    float line = gleam + 0.12 * (scales - 0.66);
    line *= line;
    line *= line;
    line *= line;
    line *= line;
    line *= line;
    tint += line;
#endif
    // The outline of a round body is where its surface turns away from the viewer. The outline
    // fades there over about a pixel, which smooths it.
    float cover = clamp(turned_to / fwidth(turned_to) + 0.15, 0.0, 1.0);
#ifdef SNOUT
    // The snout fades out from 0.5 mm to 4 mm below the surface, so that no edge shows where the
    // picture of the sunk part begins.
    cover *= clamp(out_m * 280.0 + 1.14, 0.0, 1.0);
#endif
    // Each scale breaks up the gloss of the back.
    color = vec4(tint + haze.rgb * (1.50 * scales * scales), 1.0) * cover;
}
#endif
