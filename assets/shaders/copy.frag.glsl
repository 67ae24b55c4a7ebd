// Copies a picture to a render target of another size.
in vec2 at;
uniform sampler2D picture;
out vec4 color;

void main()
{
    color = texture(picture, at);
}
