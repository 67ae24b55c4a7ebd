// A fan in the colour of its player (fan_face.frag.glsl).
in vec2 at;                // Place in a picture, 0 .. 1.
uniform vec4 trim;         // Colour of the player, along the rim. w: opacity.
uniform sampler2D faces;   // Three pictures side by side.
out vec4 color;

void main()
{
    vec2 first = at * vec2(1.0 / 3.0, 1.0);
    vec4 solid = texture(faces, first);
    vec4 glass = texture(faces, first + vec2(1.0 / 3.0, 0.0));
    vec2 weight = texture(faces, first + vec2(2.0 / 3.0, 0.0)).rg;
    color = mix(glass, solid, trim.w) + vec4(trim.rgb * mix(weight.g, weight.r, trim.w), 0.0);
}
