// A hand in two layers: INSIDE, which is opaque, and the outline, which fades over one pixel.
in vec4 tint;               // As in hand.vert.glsl.
in vec3 place;
uniform sampler2D cloth;    // Pattern of the cloth.
out vec4 color;

void main()
{
    float cover = place.z / fwidth(place.z);
#ifdef INSIDE
    if (cover < 1.0) {
        discard;
    }
#endif
    vec3 c = mix(tint.rgb, vec3(0.98, 0.96, 0.90) * tint.a, texture(cloth, place.xy).r);
#ifdef INSIDE
    color = vec4(c, 1.0);
#else
    color = vec4(c, 1.0) * clamp(cover, 0.0, 1.0);
#endif
}
