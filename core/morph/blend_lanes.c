/* blend_lanes.c -- a block of vertices is blended; line by line what blend.c does for one.
 *
 * The two forms agree to the last bit, which test_blend_lanes.c holds. What a block reads and
 * writes is 8 bytes a vertex and key, 8 of the vertex, and 24 of answer: it is meant to be held up
 * by memory alone (`make bench-morph`). */
#include "core/morph/blend_lanes.h"

#include "core/base/lanes_vec.h"
#include "core/base/panic.h"

_Static_assert(sizeof(struct species_point) == 8 && offsetof(struct species_point, z) == 4,
               "a key's point is two words");
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "x and z are the words' low halves");
_Static_assert(sizeof(struct species_vertex) == 16 && offsetof(struct species_vertex, part) == 8 &&
                   offsetof(struct species_vertex, anchor) == 11 &&
                   offsetof(struct species_vertex, mask) == 12,
               "part to masks are two words");
_Static_assert(sizeof(vec3) == 12 && sizeof(struct anchor_pose) == 28, "floats, side by side");

/* What all of a shape's blocks share. */
struct blending {
    const struct species_mesh *mesh;
    const struct morph_pose *pose;
    uint32_t key_count;
    uint8_t key[MORPH_KEY_MAX]; /* Those that any curve shows. */
    flanes whole[MORPH_KEY_MAX]; /* What they count where the whole fish's curve moves all. */
};

struct point_lanes {
    struct lanes_v3 position, normal;
};

static inline ilanes load_words(const void *from)
{
    ilanes words;
    MEM_COPY(&words, from, sizeof words);
    return words;
}

#ifdef LANES_WIDE
#define EVEN(a, b) __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14)
#define ODD(a, b) __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15)
#else
#define EVEN(a, b) __builtin_shufflevector(a, b, 0, 2, 4, 6)
#define ODD(a, b) __builtin_shufflevector(a, b, 1, 3, 5, 7)
#endif

static inline flanes low_half(ilanes words)
{
    return __builtin_convertvector((ilanes)((words << 16) >> 16), flanes);
}

static inline flanes high_half(ilanes words)
{
    return __builtin_convertvector((ilanes)(words >> 16), flanes);
}

/* As morph_normal(). */
static inline struct lanes_v3 unfold(ilanes words)
{
    const ilanes code = (words >> 16) + 32767;
    const flanes x = __builtin_convertvector((ilanes)((code >> 8) - 127), flanes);
    const flanes y = __builtin_convertvector((ilanes)((code & 255) - 127), flanes);
    const flanes z = 127.0f - lanes_abs(x) - lanes_abs(y);
    const flanes t = lanes_max(-z, lanes_of(0.0f));
    const struct lanes_v3 n = lanes_v3(x - lanes_select(x >= 0.0f, t, -t),
                                       y - lanes_select(y >= 0.0f, t, -t), z);
    return lanes_v3_scale(n, 1.0f / lanes_v3_length(n));
}

/* The second words of a block's vertices: masks; and whether anchors or masks ask for more than the
 * whole fish's curve. */
struct block {
    ilanes masks;
    uint32_t plain_masks, plain_anchors;
};

static inline struct block load_block(const struct species_vertex *vertices)
{
    struct block block = { .plain_masks = 1, .plain_anchors = 1 };
    for (int lane = 0; lane < LANES; lane++) {
        int32_t mask;
        MEM_COPY(&mask, vertices[lane].mask, sizeof mask);
        block.masks[lane] = mask;
        block.plain_masks &= mask == 255;
        block.plain_anchors &= vertices[lane].anchor == ANCHOR_NONE;
    }
    return block;
}

/* What the key counts in each lane: as vertex_weights(). */
static inline flanes weigh(const struct blending *b, const struct block *block, uint32_t at)
{
    if (block->plain_masks) {
        return b->whole[at];
    }
    flanes sum = lanes_of(0.0f);
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        const ilanes mask = (block->masks >> (int32_t)(8u * curve)) & 255;
        const flanes weight = lanes_of(b->pose->weight[curve][b->key[at]]);
        sum = sum + weight * __builtin_convertvector(mask, flanes);
    }
    return lanes_select(block->masks == 255, b->whole[at], sum / 255.0f);
}

static inline struct point_lanes blend(const struct blending *b, const struct block *block,
                                       uint32_t first)
{
    const flanes zero = lanes_of(0.0f);
    struct point_lanes p = { { zero, zero, zero }, { zero, zero, zero } };
    for (uint32_t at = 0; at < b->key_count; at++) {
        const struct species_point *points = &b->mesh->points[b->key[at]][first];
        const ilanes low = load_words(points), high = load_words(points + LANES / 2);
        const ilanes xy = EVEN(low, high), zn = ODD(low, high);
        const flanes weight = weigh(b, block, at);
        const struct lanes_v3 counts = lanes_v3(low_half(xy), high_half(xy), low_half(zn));
        p.position = lanes_v3_mad(p.position, counts, weight);
        p.normal = lanes_v3_mad(p.normal, unfold(zn), weight);
    }
    p.position = lanes_v3_scale(p.position, lanes_of(b->mesh->reach / 32767.0f));
    const flanes length = lanes_v3_length(p.normal);
    const ilanes some = length > 1e-9f;
    const struct lanes_v3 unit = lanes_v3_scale(p.normal, 1.0f / length);
    p.normal = lanes_v3(lanes_select(some, unit.x, zero),
                        lanes_select(some, unit.y, lanes_of(1.0f)),
                        lanes_select(some, unit.z, zero));
    return p;
}

/* As quat_turn(). */
static inline struct lanes_v3 turn(struct lanes_v3 axis, flanes w, struct lanes_v3 a)
{
    const struct lanes_v3 across = lanes_v3_scale(lanes_v3_cross(axis, a), lanes_of(2.0f));
    const struct lanes_v3 swung = lanes_v3_mad(a, across, w), on = lanes_v3_cross(axis, across);
    return lanes_v3(swung.x + on.x, swung.y + on.y, swung.z + on.z);
}

static const struct anchor_pose at_rest = { .turn = { 0.0f, 0.0f, 0.0f, 1.0f } };

static inline const struct anchor_pose *anchor_of(const struct blending *b, uint32_t vertex)
{
    const uint8_t anchor = b->mesh->vertices[vertex].anchor;
    if (anchor == ANCHOR_NONE) {
        return &at_rest;
    }
    CORE_ASSERT(anchor < b->mesh->anchor_count);
    return &b->pose->anchor[anchor];
}

/* Turns and carries the lanes that ride on anchors; the others' bits pass unchanged. */
static inline struct point_lanes carry(const struct blending *b, uint32_t first,
                                       struct point_lanes p)
{
    const struct anchor_pose *anchor[LANES];
    ilanes rides;
    flanes place[4], quat[4], row[2][4];
    for (uint32_t lane = 0; lane < LANES; lane++) {
        anchor[lane] = anchor_of(b, first + lane);
        rides[lane] = anchor[lane] == &at_rest ? 0 : -1;
    }
    for (uint32_t i = 0; i < 4; i++) {
        const struct anchor_pose *beside = anchor[i + (LANES - 4)];
        row[0][i] = lanes_load_beside(&anchor[i]->position, &beside->position);
        row[1][i] = lanes_load_beside(&anchor[i]->turn, &beside->turn);
    }
    lanes_turn(place, row[0][0], row[0][1], row[0][2], row[0][3]);
    lanes_turn(quat, row[1][0], row[1][1], row[1][2], row[1][3]);
    const struct lanes_v3 axis = lanes_v3(quat[0], quat[1], quat[2]);
    const struct lanes_v3 at = turn(axis, quat[3], p.position);
    const struct lanes_v3 facing = turn(axis, quat[3], p.normal);
    return (struct point_lanes){
        lanes_v3(lanes_select(rides, place[0] + at.x, p.position.x),
                 lanes_select(rides, place[1] + at.y, p.position.y),
                 lanes_select(rides, place[2] + at.z, p.position.z)),
        lanes_v3(lanes_select(rides, facing.x, p.normal.x),
                 lanes_select(rides, facing.y, p.normal.y),
                 lanes_select(rides, facing.z, p.normal.z)),
    };
}

/* LANES vectors side by side. Rows of four floats are stored three apart, each over the fourth of
 * the one before: one float behind the block is spoilt, which a later block or vertex mends. */
static inline void store(vec3 *to, struct lanes_v3 a)
{
    flanes row[4];
    lanes_turn(row, a.x, a.y, a.z, a.z);
    for (uint32_t half = 0; half < LANES / 4; half++) {
        for (uint32_t i = 0; i < 4; i++) {
            const fquad out = { row[i][4 * half], row[i][4 * half + 1], row[i][4 * half + 2],
                                row[i][4 * half + 3] };
            MEM_COPY((float *)to + 3u * (4u * half + i), &out, sizeof out);
        }
    }
}

static struct blending begin(const struct species_mesh *mesh, uint32_t key_count,
                             const struct morph_pose *pose)
{
    struct blending b = { .mesh = mesh, .pose = pose };
    for (uint32_t key = 0; key < key_count; key++) {
        uint32_t shown = 0;
        for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
            shown |= pose->weight[curve][key] != 0.0f;
        }
        if (shown) {
            b.whole[b.key_count] = lanes_of(pose->weight[0][key]);
            b.key[b.key_count++] = (uint8_t)key;
        }
    }
    return b;
}

uint32_t LANES_NAME(blend_blocks)(const struct species_mesh *mesh, uint32_t key_count,
                                  const struct morph_pose *pose, vec3 *positions, vec3 *normals)
{
    const struct blending b = begin(mesh, key_count, pose);
    uint32_t first = 0;
    for (; first + LANES < mesh->vertex_count; first += LANES) {
        const struct block block = load_block(&mesh->vertices[first]);
        struct point_lanes p = blend(&b, &block, first);
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
