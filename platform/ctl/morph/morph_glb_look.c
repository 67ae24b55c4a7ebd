/* morph_glb_look.c -- computes the position, the normal and the colour of a vertex in each shape of
 * a glTF mesh. The shapes are the base and the morph targets.
 *
 * Symbols: c is a curve of the deformation graph, k is a key (growth stage), and "last" is the last
 * key. m_c is the share with which curve c moves the vertex. V_ck is the weight of key k in curve
 * c. C_ck is the shape of the vertex in the solved key, or in the drawn key if no shape is solved.
 *
 * Kingyo computes p = sum over c of m_c sum over k of V_ck C_ck. The shares m_c have the sum 1. For
 * each curve, the weights V_ck have the sum 1 and are >= 0.
 *
 * glTF computes p = B + sum over the morph targets t of w_t D_t. Therefore the base is B = sum over
 * c of m_c C_c,last. Each curve c and each key k except the last gives a morph target with D = m_c
 * (C_ck - C_c,last) and w = V_ck. The two results for p are equal, and every weight is in [0, 1].
 *
 * Colours are morph targets too (COLOR_0, linear). A viewer that does not blend colours shows the
 * colours of the last key. The alpha of a transparent body is written, but the material of the body
 * is opaque, because many viewers draw transparent bodies with errors. Fins use alpha blending. */
#include "platform/ctl/lib/fish_preview.h"
#include "platform/ctl/morph/morph_glb.h"

float morph_glb_share_of(const struct morph_glb *fish, uint32_t vertex, uint32_t curve)
{
    uint32_t share = 0;
    for (uint32_t i = 0; i < MORPH_CURVE_MAX; i++) {
        if (i == curve || (curve == 0 && i >= fish->pick->rig.curve_count)) {
            share += fish->mesh->vertices[vertex].mask[i];
        }
    }
    return (float)share / 255.0f;
}

/* Sets the colour and the opacity of the vertex at a key. The colour is linear, as glTF requires
 * for vertex colours. */
static void take_paint(const struct morph_glb *fish, uint32_t vertex, uint32_t key,
                       struct aspect *out)
{
    const struct paint *paint = &fish->paints[key][vertex];
    out->colour = canvas_linear(paint->colour);
    out->hides = fish_preview_hides(paint, &fish->mesh->vertices[vertex]);
}

static void add_look(struct aspect *sum, const struct aspect *look, float weight)
{
    sum->position = v3_muladd(sum->position, look->position, weight);
    sum->normal = v3_muladd(sum->normal, look->normal, weight);
    sum->colour = v3_muladd(sum->colour, look->colour, weight);
    sum->hides += look->hides * weight;
}

/* Scales a normal to the octahedron |x| + |y| + |z| = 1. The core blends the normals of keys on
 * this octahedron (see struct morph_pose). */
static vec3 on_octahedron(vec3 n)
{
    return v3_scale(n, 1.0f / (f_abs(n.x) + f_abs(n.y) + f_abs(n.z)));
}

/* Returns C_ck (see the start of this file) for one vertex. */
static struct aspect solved(const struct morph_glb *fish, uint32_t vertex, uint32_t curve,
                            uint32_t key)
{
    struct aspect sum = { .hides = 0.0f };
    for (uint32_t j = 0; j < fish->pick->rig.key_count; j++) {
        struct aspect drawn = {
            .position = morph_position(fish->mesh, j, vertex),
            .normal = on_octahedron(morph_normal(fish->mesh->points[j][vertex].normal)),
        };
        take_paint(fish, vertex, j, &drawn);
        add_look(&sum, &drawn, fish->pick->rig.solution[curve][key][j]);
    }
    return sum;
}

/* Moves a vertex with an anchor to its position at progress 1, so that a viewer without skinning
 * shows a complete fish. In a viewer with skinning, the inverse bind matrix of the joint reverses
 * this move. */
static void carry(const struct morph_glb *fish, uint32_t vertex, bool is_place, struct aspect *look)
{
    const uint8_t anchor = fish->mesh->vertices[vertex].anchor;
    if (anchor != ANCHOR_NONE) {
        const struct anchor_pose *at = &fish->adult.anchor[anchor];
        look->position = pose_rotate(at->turn, look->position);
        look->normal = pose_rotate(at->turn, look->normal);
        if (is_place) {
            look->position = v3_add(look->position, at->position);
        }
    }
}

struct aspect morph_glb_base_appearance(const struct morph_glb *fish, uint32_t vertex)
{
    const uint32_t last = fish->pick->rig.key_count - 1u;
    /* The colours follow the curve of the whole fish, which has index 0. */
    const struct aspect painted = solved(fish, vertex, 0, last);
    struct aspect sum = { .hides = 0.0f };
    for (uint32_t curve = 0; curve < fish->pick->rig.curve_count; curve++) {
        const struct aspect one = solved(fish, vertex, curve, last);
        add_look(&sum, &one, morph_glb_share_of(fish, vertex, curve));
    }
    sum.colour = v3(f_clamp(painted.colour.x, 0.0f, 1.0f), f_clamp(painted.colour.y, 0.0f, 1.0f),
                    f_clamp(painted.colour.z, 0.0f, 1.0f));
    sum.hides = f_clamp(painted.hides, 0.0f, 1.0f);
    carry(fish, vertex, true, &sum);
    return sum;
}

struct aspect morph_glb_target_appearance(const struct morph_glb *fish, uint32_t vertex,
                                          uint32_t curve, uint32_t key)
{
    const float share = morph_glb_share_of(fish, vertex, curve);
    const struct aspect to = solved(fish, vertex, curve, key);
    struct aspect way = to;
    const struct aspect from = solved(fish, vertex, curve, fish->pick->rig.key_count - 1u);
    add_look(&way, &from, -1.0f);
    way.position = v3_scale(way.position, share);
    way.normal = v3_scale(way.normal, share);
    if (curve != 0) {
        way.colour = v3(0.0f, 0.0f, 0.0f);
        way.hides = 0.0f;
    }
    carry(fish, vertex, false, &way);
    return way;
}
