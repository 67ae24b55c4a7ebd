// A fan in the colour of its player (fan_face.frag.glsl).
in vec2 at;                // Place in a picture, 0 .. 1.
uniform vec3 trim;         // Colour of the player, along the rim.
uniform sampler2D faces;   // Two pictures side by side.
out vec4 color;

void main()
{
    vec2 first = at * vec2(0.5, 1.0);
    color = texture(faces, first)
        + vec4(trim * texture(faces, first + vec2(0.5, 0.0)).r, 0.0);
}
