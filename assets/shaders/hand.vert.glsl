// The hand that holds a poi, and its sleeve. The light of the stall is computed here.
layout(location = 0) in vec3 position;  // Position in ring radii, in the axes of the handle.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // On skin: place in its picture. y is negative.
                                        // On cloth: x: fraction of the light from all sides that
                                        // arrives. y: distance around the sleeve, or 9 on the hem.
uniform mat4 frames[3];                 // Of the hand, the forearm and the sleeve.
uniform vec4 paint;                     // Colour of the player. w: factor for the sleeve's length.
uniform float nearer;                   // Difference of the depth, in normalized coordinates.
invariant gl_Position;                  // The outline joins the inside without a gap.
out vec4 tint;      // rgb: colour where the picture is black. a: light where the picture is white.
out vec3 place;     // xy: place in the picture. z: cosine of the angle to the viewer.

const float CUFF_Z = 6.3;               // As in hand_pass.c.
const vec2 HEM = vec2(0.61, 0.5);       // White place in the pattern of the cloth.
const vec3 DARK_SKIN = vec3(0.20, 0.06, 0.04);

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
    float facing = dot(n, normalize(eye.xyz - world));
    // The lanterns of the stall also light the hands beside the tank.
    vec3 lamps = vec3(0.62, 0.53, 0.45) + 0.62 * lamp_light(world);
    lamps *= 1.0 - 0.4 * shade_above(world);
    float lamp = max(dot(n, LAMP_DIRECTION), 0.0);
    vec3 lit = lamps * (is_skin ? 0.80 + 0.38 * lamp : (0.40 + 0.44 * lamp) * surface.x);
    lit = 1.2 * lit / (1.0 + 0.3 * lit); // Bright light does not bleach the skin.
    vec3 dyed = paint.rgb * 0.62 + vec3(0.02, 0.01, 0.05);
    vec3 left = max(water_passes(-world.y * 2.0), 0.8); // The hand remains visible in deep water.
    tint.rgb = mix(WATER_COLOR, lit * (is_skin ? DARK_SKIN : dyed), left);
    tint.a = lit.g * left.g;
    place.xy = is_skin ? surface : surface.y > 8.0 ? HEM : vec2(surface.y, rest.z) * 0.72;
    place.z = facing + 0.1;
    gl_Position = view_projection * vec4(world, 1.0);
    // The whole hand is drawn nearer, so that no bowl, rim or water hides it.
    gl_Position.z -= nearer * gl_Position.w;
}
