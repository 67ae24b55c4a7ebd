// A hand in two layers: INSIDE, which is opaque, and the outline, which fades over one pixel.
in vec4 tint;               // As in hand.vert.glsl.
in vec3 place;
uniform mediump sampler2DArray surfaces; // Layer 0: pattern of the cloth. Layer 1: skin.
out vec4 color;

void main()
{
    float cover = place.z / fwidth(place.z);
#ifdef INSIDE
    if (cover < 1.0) {
        discard;
    }
#endif
    vec3 light = texture(surfaces, vec3(place.xy, place.y < 0.0 ? 1.0 : 0.0)).rgb;
    vec3 c = mix(tint.rgb, vec3(0.98, 0.96, 0.90) * tint.a, light);
#ifdef INSIDE
    color = vec4(c, 1.0);
#else
    color = vec4(c, 1.0) * clamp(cover, 0.0, 1.0);
#endif
}
