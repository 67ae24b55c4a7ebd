in vec3 world;
in vec3 face;
uniform sampler2D wood;
out vec4 color;

const float RIM_M = 0.032;

float grain(vec2 at)
{
    return texture(wood, at).r;
}

vec3 counter(float out_m)
{
    float t = grain(world.xz * vec2(2.2, 6.2));
    vec3 tint = mix(vec3(0.075, 0.042, 0.030), vec3(0.33, 0.20, 0.12), t);
    float lamp = exp(-dot(world.xz, world.xz) * 2.6);
    float contact = smoothstep(0.0, 0.055, out_m);
    return tint * (0.30 + 1.0 * lamp) * (0.35 + 0.65 * contact);
}

vec3 rim(vec2 past)
{
    // The grain runs along each plank; at the corners two planks meet in a mitre.
    bool across = past.x > past.y;
    vec2 along = across ? world.zx : world.xz;
    float t = grain(vec2(along.x * 1.5, along.y * 7.0 + (across ? 0.37 : 0.0)));
    vec3 tint = mix(vec3(0.30, 0.14, 0.06), vec3(0.80, 0.48, 0.25), t);
    float width = max(past.x, past.y) / RIM_M;     // 0 at the water's side, 1 outside.
    float bevel = smoothstep(0.10, 0.0, width) * 0.35 - smoothstep(0.88, 1.0, width) * 0.35;
    float mitre = 1.0 - 0.45 * (1.0 - smoothstep(0.0, 0.0012, abs(past.x - past.y)));
    float joined = min(past.x, past.y) > 0.0 ? mitre : 1.0;
    float lamp = 0.72 + 0.42 * exp(-dot(world.xz, world.xz) * 2.2);
    return tint * (1.0 + bevel) * joined * lamp * vec3(1.10, 0.99, 0.86);
}

void main()
{
    vec2 past = abs(world.xz) - tank.xz;
    if (world.y < 0.0 && face.y > 0.5) {
        color = vec4(counter(max(past.x, past.y) - RIM_M), 1.0);
    } else if (face.y > 0.5) {
        color = vec4(rim(max(past, 0.0)), 1.0);
    } else {
        vec2 along = vec2(abs(face.x) > 0.5 ? world.z : world.x, world.y);
        float t = grain(along * vec2(1.5, 6.0));
        vec3 tint = mix(vec3(0.20, 0.09, 0.04), vec3(0.56, 0.32, 0.16), t);
        float height = smoothstep(-0.012, tank.w, world.y);
        color = vec4(tint * (0.42 + 0.50 * height) * (0.85 + 0.25 * face.z), 1.0);
    }
}
