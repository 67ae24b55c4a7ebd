/* blend_lanes.c -- blends the key shapes with SIMD code for blocks of four vertices; blend.c is the
 * scalar code.
 *
 * The results of blend_lanes.c and blend.c are equal to the last bit (tested by
 * test_blend_lanes.c). For each vertex, a block reads 16 bytes of the vertex and 8 bytes for each
 * key, and writes 24 bytes. The goal is that only the memory bandwidth limits the speed, and not
 * the arithmetic (measured by `make bench-morph`). */
#include "core/morph/blend_lanes.h"

#include "core/base/panic.h"
#include "core/base/simd_vec.h"

_Static_assert(sizeof(struct species_point) == 8 && offsetof(struct species_point, z) == 4,
               "a key's point is two words");
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "x and z are the words' low halves");
_Static_assert(sizeof(struct species_vertex) == 16 && offsetof(struct species_vertex, part) == 8 &&
                   offsetof(struct species_vertex, anchor) == 11 &&
                   offsetof(struct species_vertex, mask) == 12,
               "part to masks are two words");
_Static_assert(sizeof(vec3) == 12 && sizeof(struct anchor_pose) == 28, "floats, side by side");

/* Distance, in vertices, from the block that is being blended to the vertices that the code
 * prefetches. Hardware prefetchers would start too late, because the code reads only a short part
 * of each table. */
#define AHEAD 96u
#define LINE 64u /* Size of a cache line in bytes. */

/* Values that are equal for all vertices of one fish. */
struct blending {
    const struct species_mesh *mesh;
    const struct morph_pose *pose;
    uint32_t key_count;
    uint8_t key[MORPH_KEY_MAX];  /* Indices of the keys whose weight is not 0 in at least one
                                    curve. */
    flanes whole[MORPH_KEY_MAX]; /* Weight of each key in `key` in curve 0, for vertices that only
                                    curve 0 moves. Curve 0 is the curve of the whole fish. */
};

struct point_lanes {
    struct simd_v3 position, normal;
};

static inline ilanes load_words(const void *from)
{
    ilanes words;
    MEM_COPY(&words, from, sizeof words);
    return words;
}

/* FIRST and SECOND select the first and the second 32-bit word of each point in a block. */
#define FIRST(a, b) __builtin_shufflevector(a, b, 0, 2, 4, 6)
#define SECOND(a, b) __builtin_shufflevector(a, b, 1, 3, 5, 7)

static inline flanes low_half(ilanes words)
{
    return __builtin_convertvector((ilanes)((words << 16) >> 16), flanes);
}

/* Returns `t` with the sign of `x`. The caller guarantees that t >= 0. */
static inline flanes signed_as(flanes t, flanes x)
{
    return (flanes)((ilanes)t ^ ((ilanes)x & INT32_MIN));
}

/* Decodes the normals in the upper halves of `words` as unfold() in blend.c does, but z has the
 * opposite sign. */
static inline struct simd_v3 unfold_down(ilanes words)
{
    const ilanes code = (words >> 16) + 255; /* `code` is smaller by 127 * 256 than `code` in
                                                unfold() of blend.c. */
    const flanes x = __builtin_convertvector((ilanes)(code >> 8), flanes);
    const flanes y = __builtin_convertvector((ilanes)((code & 255) - 127), flanes);
    const flanes down = simd_abs(x) + simd_abs(y) - 127.0f;
    const flanes t = simd_max(down, simd_splat(0.0f));
    return simd_v3(x - signed_as(t, x), y - signed_as(t, y), down);
}

/* Masks of a block of vertices. `plain_masks` is true if only curve 0 moves the vertices.
 * `plain_anchors` is true if no vertex has an anchor. */
struct block {
    bool plain_masks, plain_anchors;
    flanes mask[MORPH_CURVE_MAX]; /* Mask of each curve in each lane. The values are not set if
                                     `plain_masks` is true. */
};

static inline struct block load_block(const struct species_vertex *vertices)
{
    uint64_t all = ~(uint64_t)0; /* Bitwise AND, over all vertices of the block, of the vertex
                                    members part, side, flex, anchor and mask. */
    struct block block = { 0 };
    ilanes masks = { 0 };
    __builtin_prefetch(vertices + AHEAD);
    __builtin_prefetch(vertices + AHEAD + SIMD_LANES / 2);
#pragma GCC unroll 4
    for (int lane = 0; lane < SIMD_LANES; lane++) {
        uint64_t word;
        MEM_COPY(&word, &vertices[lane].part, sizeof word);
        all &= word;
    }
    block.plain_masks = (all >> 32 & 255u) == 255u;
    block.plain_anchors = (all >> 24 & 255u) == 255u;
    if (!block.plain_masks) {
        for (int lane = 0; lane < SIMD_LANES; lane++) {
            int32_t mask;
            MEM_COPY(&mask, vertices[lane].mask, sizeof mask);
            masks[lane] = mask;
        }
#pragma GCC unroll 4
        for (int curve = 0; curve < (int)MORPH_CURVE_MAX; curve++) {
            const ilanes mask = (masks >> (8 * curve)) & 255;
            block.mask[curve] = __builtin_convertvector(mask, flanes);
        }
    }
    return block;
}

/* Returns the weight of key b->key[at] in each lane. The function uses the same arithmetic as
 * vertex_weight() in blend.c. */
static inline flanes weigh(const struct blending *b, const struct block *block, uint32_t at)
{
    flanes sum = simd_splat(0.0f);
    if (block->plain_masks) {
        return b->whole[at];
    }
#pragma GCC unroll 4
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        const float weight = b->pose->weight[curve][b->key[at]];
        sum = sum + simd_splat(weight) * block->mask[curve];
    }
    return simd_select(block->mask[0] == 255.0f, b->whole[at], sum * (1.0f / 255.0f));
}

static inline struct point_lanes blend_points(const struct blending *b, const struct block *block,
                                              uint32_t first)
{
    const flanes zero = simd_splat(0.0f);
    struct point_lanes p = { { zero, zero, zero }, { zero, zero, zero } };
    for (uint32_t at = 0; at < b->key_count; at++) {
        const struct species_point *points = &b->mesh->points[b->key[at]][first];
        __builtin_prefetch(points + AHEAD);
        const ilanes low = load_words(points), high = load_words(points + SIMD_LANES / 2);
        const ilanes xy = FIRST(low, high), zn = SECOND(low, high);
        const flanes weight = weigh(b, block, at);
        const struct simd_v3 counts = simd_v3(
            low_half(xy), __builtin_convertvector((ilanes)(xy >> 16), flanes), low_half(zn));
        const struct simd_v3 facing = unfold_down(zn);
        p.position = simd_v3_muladd(p.position, counts, weight);
        p.normal.x = p.normal.x + facing.x * weight;
        p.normal.y = p.normal.y + facing.y * weight;
        p.normal.z = p.normal.z - facing.z * weight;
    }
    p.position = simd_v3_scale(p.position, simd_splat(b->mesh->reach / 32767.0f));
    const flanes length = simd_v3_length(p.normal);
    const ilanes some = length > 1e-9f;
    const struct simd_v3 unit = simd_v3_scale(p.normal, 1.0f / length);
    p.normal = simd_v3(simd_select(some, unit.x, zero), simd_select(some, unit.y, simd_splat(1.0f)),
                       simd_select(some, unit.z, zero));
    return p;
}

/* Returns the vectors `a` rotated by the quaternions with the vector part `axis` and the scalar
 * part `w`. The function uses the same arithmetic as pose_rotate(). */
static inline struct simd_v3 rotate_axis(struct simd_v3 axis, flanes w, struct simd_v3 a)
{
    const struct simd_v3 across = simd_v3_scale(simd_v3_cross(axis, a), simd_splat(2.0f));
    const struct simd_v3 swung = simd_v3_muladd(a, across, w), on = simd_v3_cross(axis, across);
    return simd_v3(swung.x + on.x, swung.y + on.y, swung.z + on.z);
}

static const struct anchor_pose at_rest = { .turn = { 0.0f, 0.0f, 0.0f, 1.0f } };

/* Rotates and moves each point by its anchor. A point without an anchor keeps its bits, because
 * only 0 is added. Adding 0 changes only the value -0, and no blended coordinate is -0. */
static inline struct point_lanes carry(const struct blending *b, uint32_t first,
                                       struct point_lanes p)
{
    const struct anchor_pose *anchor[SIMD_LANES];
    flanes place[4], quat[4], row[2][4];
    for (uint32_t lane = 0; lane < SIMD_LANES; lane++) {
        const uint8_t index = b->mesh->vertices[first + lane].anchor;
        CORE_ASSERT(index == ANCHOR_NONE || index < b->mesh->anchor_count);
        anchor[lane] = index == ANCHOR_NONE ? &at_rest : &b->pose->anchor[index];
    }
    for (uint32_t i = 0; i < 4; i++) {
        row[0][i] = (flanes)load_words(&anchor[i]->position);
        row[1][i] = (flanes)load_words(&anchor[i]->turn);
    }
    simd_turn(place, row[0][0], row[0][1], row[0][2], row[0][3]);
    simd_turn(quat, row[1][0], row[1][1], row[1][2], row[1][3]);
    const struct simd_v3 axis = simd_v3(quat[0], quat[1], quat[2]);
    const struct simd_v3 at = rotate_axis(axis, quat[3], p.position);
    return (struct point_lanes){
        simd_v3(place[0] + at.x, place[1] + at.y, place[2] + at.z),
        rotate_axis(axis, quat[3], p.normal),
    };
}

/* Stores SIMD_LANES consecutive vectors of three floats. Each vector is stored as four floats, and
 * the next vector overwrites the fourth float. The last vector writes one float beyond the block. A
 * later block or vertex overwrites this float. */
static inline void store(vec3 *to, struct simd_v3 a)
{
    flanes row[4];
    simd_turn(row, a.x, a.y, a.z, a.z);
#pragma GCC unroll 4
    for (int lane = 0; lane < SIMD_LANES; lane++) {
        MEM_COPY(&to[lane], &row[lane], sizeof row[lane]);
    }
}

/* Returns the values that are equal for all blocks of vertices, and prefetches the first AHEAD
 * vertices of every table. The functions blend_points() and load_block() prefetch only the vertices
 * that lie AHEAD or more vertices later. */
static struct blending begin_blending(const struct species_mesh *mesh, uint32_t key_count,
                                      const struct morph_pose *pose)
{
    struct blending b = { .mesh = mesh, .pose = pose };
    for (uint32_t key = 0; key < key_count; key++) {
        bool shown = false;
        for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
            shown = shown || pose->weight[curve][key] != 0.0f;
        }
        if (shown) {
            b.whole[b.key_count] = simd_splat(pose->weight[0][key]);
            b.key[b.key_count++] = (uint8_t)key;
        }
    }
    const uint32_t count = mesh->vertex_count < AHEAD ? mesh->vertex_count : AHEAD;
    for (uint32_t first = 0; first < count; first += LINE / sizeof(struct species_point)) {
        __builtin_prefetch(&mesh->vertices[first]);
        __builtin_prefetch(&mesh->vertices[first + LINE / sizeof(struct species_vertex)]);
        for (uint32_t at = 0; at < b.key_count; at++) {
            __builtin_prefetch(&mesh->points[b.key[at]][first]);
        }
    }
    return b;
}

uint32_t blend_blocks(const struct species_mesh *mesh, uint32_t key_count,
                      const struct morph_pose *pose, vec3 *positions, vec3 *normals)
{
    const struct blending b = begin_blending(mesh, key_count, pose);
    uint32_t first = 0;
    for (; first + SIMD_LANES < mesh->vertex_count; first += SIMD_LANES) {
        const struct block block = load_block(&mesh->vertices[first]);
        struct point_lanes p = blend_points(&b, &block, first);
        if (!block.plain_anchors) {
            p = carry(&b, first, p);
        }
        if (positions) {
            store(&positions[first], p.position);
        }
        if (normals) {
            store(&normals[first], p.normal);
        }
    }
    return first;
}
