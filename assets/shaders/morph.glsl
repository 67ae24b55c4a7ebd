// The morph (2005 thesis, eq. 3.2), which blends key shapes (modelled growth stages) to the shape
// of one fish. This file is inserted before every vertex shader, and is empty unless KEYS is
// defined. core/morph/blend.c computes the same shape on the CPU. The results agree within 1e-5 of a
// body length.
//
// KEYS is the number of key shapes, 3 to 8. Each key shape has an attribute of 8 bytes: xyz is the
// position, and w is the normal.
//
// CURVES is the number of deformation graphs, 1 to 4. With one graph, the vertex masks are not
// read.
//
// ANCHORS is 0 if no vertex is attached to an anchor on the skin. ANCHORS is 1 if attached vertices
// keep the body's axes, as fins do. ANCHORS is 2 if attached vertices may turn with the skin, as
// eyes do.
//
// The uniform block Pose contains the pose of the fish. The fish of the tank do not use this file,
// because their shapes are blended on the CPU (platform/render/fish_shapes.h).
#ifdef KEYS
layout(location = 0) in vec4 key_0;
layout(location = 1) in vec4 key_1;
layout(location = 2) in vec4 key_2;
#if KEYS > 3
layout(location = 3) in vec4 key_3;
#endif
#if KEYS > 4
layout(location = 4) in vec4 key_4;
#endif
#if KEYS > 5
layout(location = 5) in vec4 key_5;
#endif
#if KEYS > 6
layout(location = 6) in vec4 key_6;
#endif
#if KEYS > 7
layout(location = 7) in vec4 key_7;
#endif
layout(location = 8) in vec4 surface; // u, v, part / 255, flexibility.
#if CURVES > 1
layout(location = 12) in vec4 masks;  // Weight of each curve in the vertex's motion. The sum is 1.
#endif
layout(location = 13) in vec4 rides;  // x: index of the vertex's anchor; 255 means none. y: side of
                                      // a paired part.

uniform float reach;                  // Length in body lengths for which the attribute value 1
                                      // stands.

// Layout of a pose: for each curve the weights of keys 0 to 3 and 4 to 7, then for each anchor its
// position and rotation.
layout(std140) uniform Pose {
    vec4 pose[8 + 2 * 96];
};

// Returns the normal that is stored on the unfolded octahedron |x| + |y| + |z| = 1. Normals are
// blended in the octahedral form.
vec3 unfold_normal(float folded)
{
    float code = floor(folded * 32767.0 + 32767.5);
    float high = floor(code / 256.0);
    vec2 f = vec2(high, code - high * 256.0) / 127.0 - 1.0;
    vec3 n = vec3(f, 1.0 - abs(f.x) - abs(f.y));
    float t = max(-n.z, 0.0);
    n.xy -= vec2(n.x >= 0.0 ? t : -t, n.y >= 0.0 ? t : -t);
    return n;
}

vec3 turned_by(vec4 turn, vec3 v)
{
    return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}

void blend(vec4 key, float weight, inout vec3 p, inout vec3 n)
{
    p += key.xyz * weight;
    n += unfold_normal(key.w) * weight;
}

#if ANCHORS
// Moves the vertex to the position of its anchor. A vertex without an anchor does not change.
void carry(inout vec3 p, inout vec3 n)
{
    if (rides.x < 254.5) {
        int at = 2 * CURVES + 2 * int(rides.x + 0.5);
#if ANCHORS > 1
        vec4 turn = pose[at + 1];
        p = turned_by(turn, p);
        n = turned_by(turn, n);
#endif
        p += pose[at].xyz;
    }
}
#endif

// Computes the position `p` and normal `n` of the vertex in the fish's coordinate system. `n` is
// not normalized.
void morph(out vec3 p, out vec3 n)
{
#if CURVES > 1
    vec4 low = vec4(0.0);
    vec4 high = vec4(0.0);
    for (int curve = 0; curve < CURVES; curve++) {
        low += pose[2 * curve] * masks[curve];
#if KEYS > 4
        high += pose[2 * curve + 1] * masks[curve];
#endif
    }
#else
    vec4 low = pose[0];
#if KEYS > 4
    vec4 high = pose[1];
#endif
#endif
    p = vec3(0.0);
    n = vec3(0.0);
    blend(key_0, low.x, p, n);
    blend(key_1, low.y, p, n);
    blend(key_2, low.z, p, n);
#if KEYS > 3
    blend(key_3, low.w, p, n);
#endif
#if KEYS > 4
    blend(key_4, high.x, p, n);
#endif
#if KEYS > 5
    blend(key_5, high.y, p, n);
#endif
#if KEYS > 6
    blend(key_6, high.z, p, n);
#endif
#if KEYS > 7
    blend(key_7, high.w, p, n);
#endif
    p *= reach;
#if ANCHORS
    carry(p, n);
#endif
}
#endif
