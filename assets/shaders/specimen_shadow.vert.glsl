// The soft shadow under a specimen, an ellipse that is lower than any belly.
uniform vec3 place; // xy: centre of the body in pixels. z: pixels per body length, as in
                    // specimen.vert.glsl.
uniform vec2 screen_px;
uniform mat2 turn;  // Matrix that rotates the picture on the screen.
uniform vec2 move;
uniform vec3 look;  // x: darkness of the shadow. y: visible fraction of the fish's length.
out vec2 lens;

void main()
{
    lens = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    vec2 half_ = vec2(0.12 + 0.50 * look.y, 0.065);
    vec2 px = place.xy + place.z * (lens * half_ + vec2(0.0, 0.34));
    gl_Position = vec4(turn * (px / screen_px * vec2(2.0, -2.0) + vec2(-1.0, 1.0)) + move,
                      0.0, 1.0);
}
