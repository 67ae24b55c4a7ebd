// The hand that holds a poi, and its sleeve. The light of the stall is computed here.
layout(location = 0) in vec3 position;  // Position in ring radii, in the axes of the handle.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // x: fraction of the light from all sides that arrives.
                                        // y: distance around the sleeve, or negative on skin.
uniform mat4 frames[3];                 // Of the hand, the forearm and the sleeve.
uniform vec4 paint;                     // Colour of the player. w: factor for the sleeve's length.
invariant gl_Position;                  // The outline joins the inside without a gap.
out vec4 tint;      // rgb: colour. a: light on the pattern of the cloth, or 0 on skin.
out vec3 place;     // xy: place in the pattern of the cloth. z: cosine of the angle to the viewer.

const float CUFF_Z = 6.3;               // As in hand_pass.c.
const vec2 BLANK = vec2(0.5, 0.0);      // Place without a flower in the pattern of the cloth.

void main()
{
    bool is_skin = surface.y < 0.0;
    vec3 rest = position;
    rest.z = is_skin ? rest.z : CUFF_Z + (rest.z - CUFF_Z) * paint.w;
    float bent = smoothstep(4.6, 5.5, rest.z);
    vec3 share = is_skin ? vec3(1.0 - bent, bent, 0.0) : vec3(0.0, 0.0, 1.0);
    mat4 frame = share.x * frames[0] + share.y * frames[1] + share.z * frames[2];
    vec3 world = (frame * vec4(rest, 1.0)).xyz;
    vec3 n = normalize(mat3(frame) * normal);
    vec3 ray = world - eye.xyz;
    float facing = dot(n, -normalize(ray));
    // The lanterns of the stall also light the hands beside the tank.
    vec3 lamps = vec3(0.62, 0.53, 0.45) + 0.62 * lamp_light(world);
    lamps *= 1.0 - 0.4 * shade_above(world);
    float free = surface.x;
    // Light that enters the skin leaves it red, so that shadows are warm.
    vec3 soft = is_skin ? vec3(0.42, 0.33, 0.30) : vec3(0.36);
    float lamp = 0.42 * max(dot(n, LAMP_DIRECTION), 0.0) * (0.35 + 0.65 * free);
    vec3 lit = lamps * (soft * (0.4 + 0.6 * free) + lamp);
    lit = 1.2 * lit / (1.0 + 0.3 * lit); // Bright light does not bleach the skin.
    vec3 skin = mix(vec3(0.78, 0.36, 0.25), vec3(0.99, 0.76, 0.61), clamp(free * 1.25, 0.0, 1.0));
    float edge = 1.0 - max(facing, 0.0);
    skin += vec3(0.10, 0.05, 0.03) * edge * edge;
    vec3 dyed = paint.rgb * 0.62 + vec3(0.02, 0.01, 0.05);
    vec3 left = max(water_passes(-world.y * 2.0), 0.8); // The hand remains visible in deep water.
    tint.rgb = mix(WATER_COLOR, lit * (is_skin ? skin : dyed), left);
    tint.a = is_skin ? 0.0 : lit.g * left.g;
    place.xy = is_skin ? BLANK : vec2(surface.y, rest.z) * 0.72;
    place.z = facing;
    gl_Position = view_projection * vec4(world, 1.0);
    // Everything below the top of the rim has the depth of a thin layer above the rim, so that no
    // bowl, rim or water hides the hand.
    float top = tank.w + 0.004;
    float seen = (top + 0.02 * (world.y - top) - eye.y) / ray.y;
    vec4 above = view_projection * vec4(eye.xyz + ray * seen, 1.0);
    gl_Position.z = world.y < top ? above.z / above.w * gl_Position.w : gl_Position.z;
}
