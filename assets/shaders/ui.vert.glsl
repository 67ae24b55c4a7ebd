// Vertex shader of the user interface: a quad in pixels. The shader is compiled without
// common.glsl.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 shape;
layout(location = 3) in vec4 fill;
layout(location = 4) in vec4 line;
uniform vec2 to_clip; // Factors from pixels to clip space: 2 / width and -2 / height.
uniform mat2 turn; // Rotation and scale of the picture on the screen.
uniform vec2 move;
out highp vec2 at;
flat out highp vec4 s;
flat out mediump vec4 inner, outer;
void main() {
    gl_Position = vec4(turn * (position * to_clip + vec2(-1.0, 1.0)) + move, 0.0, 1.0);
    at = uv;
    s = shape;
    inner = fill;
    outer = line;
}
