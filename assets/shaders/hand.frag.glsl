// A hand in two layers: INSIDE, which is opaque, and the outline, which fades over one pixel.
in vec4 tint;               // As in hand.vert.glsl.
in vec4 place;
uniform mediump sampler2DArray surfaces; // Layer 0: pattern of the cloth. Layer 1: skin.
out vec4 color;

void main()
{
    vec2 aside = vec2(place.z, max(place.w, 0.0));
    float left = 1.0 - dot(aside, aside);
    // On a narrow triangle that faces aside, the gradient is too large to be the width of the edge.
    float cover = left / min(fwidth(left), 0.4);
#ifdef INSIDE
    const float LEAST = 1.0;
#else
    const float LEAST = 0.0; // Pixels beside the hand do not write depth.
#endif
    if (cover < LEAST) {
        discard;
    }
    vec3 light = texture(surfaces, vec3(place.xy, place.y < 0.0 ? 1.0 : 0.0)).rgb;
    vec3 c = tint.rgb + tint.a * light;
#ifdef INSIDE
    color = vec4(c, 1.0);
#else
    color = vec4(c, 1.0) * clamp(cover, 0.0, 1.0);
#endif
}
