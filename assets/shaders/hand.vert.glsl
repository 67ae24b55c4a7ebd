// The hand that holds a poi, and its sleeve. The light of the stall is computed here.
layout(location = 0) in vec3 position;  // Position in ring radii, in the axes of the handle.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 surface;   // On skin: place in its picture. y is negative.
                                        // On cloth: x: fraction of the light from all sides that
                                        // arrives. y: distance around the sleeve, or 9 on the hem.
layout(location = 3) in vec3 axis;      // Direction of the bone of a finger, or 0.
uniform mat4 frames[3];                 // Of the hand, the forearm and the sleeve.
uniform vec4 paint;                     // Colour of the player. w: factor for the sleeve's length.
uniform float nearer;                   // Difference of the depth, in normalized coordinates.
invariant gl_Position;                  // The outline joins the inside without a gap.
out vec4 tint;      // rgb: colour where the picture is black. a: light that the picture adds.
// xy: place in the picture. zw: distances from the middle of the finger across and along the bone,
// as fractions of the distance of the outline. On other parts, z is 0, and w is 1.3 on skin
// and 1.1 on cloth, minus the cosine of the angle to the viewer.
out vec4 place;

const float CUFF_Z = 5.3;               // As HAND_CUFF_Z in hand_mesh.h.
const vec2 HEM = vec2(0.153, 0.07);     // Place without a line in the pattern of the cloth.
const float FINGER_CUT = 1.236;         // 1 / the cosine of half the angle of one of five sides.
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
    vec3 n = mat3(frame) * normal;
    float unit = inversesqrt(dot(n, n));
    n *= unit;
    vec3 to_eye = normalize(eye.xyz - world);
    float facing = dot(n, to_eye);
    // `across` is the direction across the finger in the picture. `ahead` is the distance from the
    // middle along the bone. It limits the round tip, and elsewhere only the places where the
    // surface turns away.
    vec3 across = cross(mat3(frame) * axis, to_eye) * unit;
    float sine = dot(across, across);
    across *= inversesqrt(max(sine, 1e-4));
    float aside = dot(n, across);
    float ahead = dot(normal, axis) > 0.1 ? dot(n, cross(to_eye, across)) * 1.3
                                          : max(1.1 - 3.0 * (facing + aside * aside), -0.3);
    // A finger that points to the viewer is cut where its surface turns away.
    float tube = smoothstep(0.02, 0.20, sine);
    // The lanterns of the stall also light the hands beside the tank.
    vec3 lamps = vec3(0.62, 0.53, 0.45) + 0.62 * lamp_light(world);
    lamps *= 1.0 - 0.4 * shade_above(world);
    float lamp = max(dot(n, LAMP_DIRECTION), 0.0);
    vec3 lit = lamps * (is_skin ? 0.80 + 0.38 * lamp : (0.40 + 0.44 * lamp) * surface.x);
    lit = 1.2 * lit / (1.0 + 0.3 * lit); // Bright light does not bleach the skin.
    bool is_hem = surface.y > 8.0;
    vec3 dyed = is_hem ? vec3(0.80, 0.77, 0.70) : paint.rgb * 0.62 + vec3(0.02, 0.01, 0.05);
    vec3 left = max(water_passes(-world.y * 2.0), 0.8); // The hand remains visible in deep water.
    tint.rgb = mix(WATER_COLOR, lit * (is_skin ? DARK_SKIN : dyed), left);
    tint.a = 0.8 * lit.g * left.g;
    place.xy = is_skin ? surface : is_hem ? HEM : vec2(surface.y, rest.z) * 0.72;
    place.z = FINGER_CUT * tube * aside;
    place.w = mix((is_skin ? 1.3 : 1.1) - facing, ahead, tube);
    gl_Position = view_projection * vec4(world, 1.0);
    // The whole hand is drawn nearer, so that no bowl, rim or water hides it.
    gl_Position.z -= nearer * gl_Position.w;
}
