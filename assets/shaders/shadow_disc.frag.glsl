in vec2 disc;
uniform vec4 softness;    // x: margin in disc radii. z: darkness of the centre. w: layer of
                          // `sheet`; -1 means no paper.
uniform sampler2DArray sheet;
out vec4 color;

void main()
{
    float r = length(disc);
    float blur = softness.x;
    float rim = 1.0 - smoothstep(0.0, blur, abs(r - 1.05));
    float inside = 1.0 - smoothstep(1.0 - blur, 1.0 + blur, r);
    float solid = softness.w < 0.0 ? 1.0
        : texture(sheet, vec3(disc * 0.5 + 0.5, softness.w)).b;
    float handle = softness.w < 0.0 ? 0.0
        : step(1.0, disc.y) * (1.0 - smoothstep(0.05, 0.16 + blur * 0.5, abs(disc.x)))
            * (1.0 - smoothstep(softness.y - blur * 2.0, softness.y + blur, disc.y));
    color = vec4(clamp(max(max(inside * solid * softness.z, rim * 0.42), handle * 0.45), 0.0, 0.8));
}
