// A fish of the tank. The vertex shader reads the blended shape of the fish, bends the body, adds
// the swimming wave along the spine, and places the fish in the world. With FIN defined the shader
// draws the fins, otherwise the body and the eyes. With GLOSS defined, wet skin has narrow highlights.
layout(location = 8) in vec4 surface;      // u, v, part / 255, flexibility.
layout(location = 9) in vec4 place;        // World position. w: length in m.
layout(location = 10) in vec4 right_phase; // The body's right axis in the world. w: phase of the
                                           // swimming wave.
layout(location = 11) in vec4 up_amplitude; // The body's up axis in the world. w: amplitude of the
                                            // swimming wave.
layout(location = 14) in vec4 character;   // Bend in rad, pattern layer, fraction by which the fins are
                                           // stained, random fraction different for each fish.
#ifdef FIN
layout(location = 0) in vec4 pale_fin;     // Colour of a fin where it is white. w: phase of the stains.
layout(location = 1) in vec3 stain_fin;    // Colour of a fin where it is red.
#else
layout(location = 0) in vec3 pale_back;    // Colours of the skin where the pattern is white and where
layout(location = 1) in vec3 stain_back;   // it is red, at the back and at the belly
layout(location = 2) in vec3 pale_belly;   // (platform/render/fish_colours.h).
layout(location = 3) in vec3 stain_belly;
#endif
layout(location = 12) in vec4 weights;     // Of belly, ridge, edge of the gill cover and eye, as
                                           // pack_weights() of fish_mesh.c writes them.
layout(location = 13) in vec4 rides;       // zw: motion of the opening mouth, as pack_mouth() of
                                           // fish_mesh.c writes it.
layout(location = 15) in vec4 gulp;        // Opening of the mouth, phase of the gulp or -1 for a fish
                                           // in a bowl, row of the fish in `shapes`, and opening of
                                           // the gill covers.

uniform sampler2D caustics;
uniform sampler2D shapes; // For each vertex a texel with the position, in body lengths, and a texel
                          // with the normal (platform/render/fish_shapes.h).

// The vertex shader computes the colours of both extremes of the skin. The fragment shader only
// selects between the colours.
out vec4 skin;         // u, v, pattern layer, and 1 for an eye or 0 for skin.
out vec3 pale;         // Colour where the pattern is white (for an eye, its iris), with lighting
                       // and water tint.
out vec3 stain;        // Colour where the pattern is red (for an eye, its pupil), with lighting and
                       // water tint.
out float turned_to;   // Cosine of the angle between normal and view direction, which is 0 along
                       // the outline. Used only for bodies.
#ifdef GLOSS
out float gleam;       // Cosine of the angle to the mirror image of the lamps, to the power 4.
#endif
#if defined(SUNK) || defined(SNOUT)
out float out_m;       // Height above the water surface in m.
#endif
out vec4 haze;         // Colour added by water and gloss. w: visibility of the edge of the gill
                       // cover.

const float WAVE_NUMBER = 6.45;  // Radians per body length. The wavelength is 0.97 body lengths
                                 // (Videler & Hess).
const float PIVOT = 0.38;        // Position along the body, as a fraction from the snout, around
                                 // which the fish turns.
const float ARC_MIDDLE = 0.02;   // Distance, in body lengths, by which a bend of 1 rad moves the
                                 // centre of mass.
const float SEAM = 0.005;        // Overlap, in m, of the parts of a fish above and below the
                                 // surface.
const float THROAT = 0.042;      // Largest motion of the mouth forward or backward, as in
                                 // fish_mesh.c.
const float LOWER_LIP = 0.022;   // Largest motion of the mouth up or down, as in fish_mesh.c.

#ifdef FIN
const float LEAST_LIT = 0.68;    // Light passes through a fin, so that a fin that is seen on edge is
                                 // nearly as bright as the back.
const float LEAN = 0.020;        // Distance, in body lengths, by which the tips of the fins lean to
                                 // the right, so that a dorsal fin is visible from above.
const float LEAN_PX = 2.0;       // Least distance in pixels by which the tips lean, so that a fin that
                                 // is seen on edge has a pixel in each row.
#else
const float LEAST_LIT = 0.0;
#endif

#ifdef FIN
void colour()
{
    float root = 1.0 - surface.y;
    float stained = smoothstep(0.30, 0.72, character.z + 0.20 * sin(surface.x * 9.0 + pale_fin.w)
        + 0.25 * root);
    stain = mix(mix(pale_fin.rgb, stain_fin, stained), WHITE, 0.22 * surface.y);
    pale = stain;
    skin = vec4(surface.x * 9.87 + character.w, surface.y, 0.0, 0.0);
}
#else
void colour()
{
    float belly = weights.x, eye_part = weights.w;
    vec3 iris = mix(vec3(0.86, 0.62, 0.20), vec3(0.78, 0.78, 0.72), character.w);
    // The eyes of black and of young fish are dark, as their backs are.
    pale = mix(mix(pale_back, pale_belly, belly), iris * pale_back, eye_part);
    stain = mix(mix(stain_back, stain_belly, belly), vec3(0.015), eye_part);
    // The gill cover takes the pattern along, and its edge casts a stronger shadow while it is open.
    float breath = gulp.w;
    float cover = max(1.0 - abs(surface.x - 0.24) * 8.0, 0.0) * weights.z;
    // Scales on the back reflect light upward.
    haze = vec4(vec3(0.14 * weights.y), (0.20 + 0.20 * breath) * weights.z);
    skin = vec4(surface.x - 0.022 * breath * cover, surface.y, character.y, eye_part);
}
#endif

#ifndef FIN
// Opens the mouth and returns its visibility as a dark throat. The position must not depend on the
// normal, so that the binning shader, which computes only positions, reads no normals.
float open_mouth(inout vec3 p)
{
    vec2 moves = (rides.zw - 128.0) * (gulp.x / 127.0);
    p.z -= moves.x * THROAT;
    p.y += moves.y * LOWER_LIP;
    return gulp.x * step(rides.z, 127.5);
}
#endif

void main()
{
    bool is_in_bowl = gulp.y < 0.0;
    ivec2 texel = ivec2(2 * gl_VertexID, int(gulp.z + 0.5));
    vec3 p = texelFetch(shapes, texel, 0).xyz;
    vec3 n = texelFetch(shapes, texel + ivec2(1, 0), 0).xyz;

#ifndef FIN
    float throat = open_mouth(p);
#endif

    // The swimming wave travels along the spine. Its amplitude envelope was measured on cruising
    // fish with the build of a carp.
    float t = p.z + 0.5;
    float amplitude = up_amplitude.w;
    float phase = right_phase.w - WAVE_NUMBER * t;
    float envelope = amplitude * (0.02 - 0.0825 * t + 0.1625 * t * t);
    float envelope_slope = amplitude * (-0.0825 + 0.325 * t);
    float wave = sin(phase);
    float side = envelope * wave;
    float side_slope = envelope_slope * wave - envelope * WAVE_NUMBER * cos(phase);

    // A turn bends the spine to an arc of constant curvature, up to the C shape of a startle
    // response. The centre of mass stays in place, because no outside force acts on the body.
    float s = t - PIVOT;
    float turn = character.x * s;
    // The series of sin(turn) / turn and (1 - cos(turn)) / turn are exact to 2e-4 for turns up to
    // 1.6 rad, and need no case for a turn of 0.
    float turn2 = turn * turn;
    float along = 1.0 - turn2 * (1.0 / 6.0 - turn2 * (1.0 / 120.0 - turn2 / 5040.0));
    float across = turn * (0.5 - turn2 * (1.0 / 24.0 - turn2 / 720.0));
    float x = side + s * across - ARC_MIDDLE * character.x;
    float z = PIVOT - 0.5 + s * along;
    float angle = turn + side_slope;
    float c = cos(angle);
    float d = sin(angle);

#ifdef FIN
    // Fins lag behind the water that the body moves, and always flutter slightly.
    float idle = sin(eye.w * 5.0 + right_phase.w * 0.5 + place.x * 40.0 + p.x * 12.0);
    float trail = surface.w * (0.045 * amplitude * sin(phase - 1.3) + 0.010 * idle);
    p.y += trail * 0.5;
    x += trail + surface.w * max(LEAN, LEAN_PX * vinyl.w / place.w);
#endif
    p = vec3(x + p.x * c, p.y, z - p.x * d);
    n = vec3(n.x * c + n.z * d, n.y, n.z * c - n.x * d);

    vec3 right = right_phase.xyz;
    vec3 up = up_amplitude.xyz;
    vec3 back = cross(right, up);
    vec3 world = place.xyz + place.w * (right * p.x + up * p.y + back * p.z);
    n = right * n.x + up * n.y + back * n.z; // The texture has unit normals.
    gl_Position = view_projection * vec4(world, 1.0);

#if defined(SUNK) || defined(SNOUT)
    out_m = world.y;
#endif
#ifdef SNOUT
    // The waves shift the refracted picture. The variant SNOUT therefore draws the fish slightly
    // nearer to the viewer, so that a small part below the surface is also visible. This part
    // closes the gap between the two pictures.
    vec4 nearer = view_projection * vec4(world + SEAM * normalize(eye.xyz - world), 1.0);
    gl_Position.z = nearer.z / nearer.w * gl_Position.w;
#endif

    // Lighting is computed per vertex, because per-pixel lighting would look the same at these
    // sizes.
    vec3 view = normalize(eye.xyz - world);
#ifdef FIN
    n = dot(n, view) < 0.0 ? -n : n;
#endif
    float depth = -world.y;
    turned_to = dot(n, view);
    float facing = max(turned_to, 0.0);
    float wet = step(0.0, world.y);
    float diffuse = 0.49 + 0.68 * max(dot(n, LAMP_DIRECTION) * 0.65 + 0.35, LEAST_LIT);
    float caustic = textureLod(caustics, world.xz * CAUSTIC_TILES * 1.15, 0.0).r;
    float light = diffuse * (1.0 + (caustic * 2.4 - 0.55) * max(n.y, 0.0)
        * (evening.w - evening.w * wet));
    // Above the water only the shades of fans count, because a fish above the water lies on the poi
    // that casts the shade. The clear water of a bowl absorbs no light, and its fish are as bright
    // as on the poi that poured them.
    vec2 shade_here = shades_at(world);
    float shade = world.y < 0.0 && !is_in_bowl ? shade_here.y : shade_here.x;
    light *= 1.0 - 0.85 * shade;
    vec3 left = water_passes(is_in_bowl ? 0.0 : depth * 1.25);
#ifdef FIN
    float gloss = 0.0;
    // A fin that is seen on edge lets more light through, and is as bright as the back below it.
    light *= 1.12 - 0.12 * smoothstep(0.0, 0.42, facing);
#else
    vec3 middle = view + LAMP_DIRECTION;
    float shine = max(dot(n, middle) * inversesqrt(dot(middle, middle)), 0.0);
    shine *= shine;
    shine *= shine;
#ifdef GLOSS
    gleam = shine;
#endif
    shine *= shine;
    // Wet skin in air has a narrow highlight. In water the highlight is wide and faint.
    float wide = shine;
    shine *= shine;
    float gloss = 0.22 * mix(wide, shine * shine, wet) * (1.0 - shade);
#ifdef GLOSS
    gleam *= 0.93 + 0.12 * wet - 0.1 * shade;
    gloss *= 0.7; // The fragment shader adds the rest as a narrow line.
#else
    // A highlight of a few pixels would sparkle, so that small fish have little gloss.
    gloss *= clamp(place.w / gl_Position.w * 40.0 - 0.8, 0.2, 1.0);
#endif
#endif
    haze = vec4(0.0);
    colour();
    vec3 gain = light * left;
#ifndef FIN
    gain *= 1.0 - 0.92 * throat;
    gloss += 1.2 * skin.w * shine * shine; // A wet eye has a narrow highlight.
#endif
    pale *= gain;
    stain *= gain;
    haze.rgb = haze.rgb * gain + WATER_COLOR * (1.0 - 0.5 * shade) * (1.0 - left) + gloss * vec3(1.0, 0.95, 0.86);
}
