/* refit_tree.c -- a tree of bounding boxes around the triangles of a surface, for the search for
 * the nearest point. */
#include <math.h>
#include <stdlib.h>

#include "core/base/panic.h"
#include "platform/ctl/import/refit.h"

#define LEAF_MAX 4u
/* Size of the search stack. A binary tree of 131,072 triangles has only about 18 levels. */
#define DEPTH_MAX 64u

void refit_tree_add(struct refit_tree *tree, vec3 a, vec3 b, vec3 c, uint8_t part)
{
    CORE_ASSERT(tree->triangle_count < REFIT_TREE_TRIANGLE_MAX);
    tree->triangles[tree->triangle_count++] = (struct refit_tree_triangle){ { a, b, c }, part };
}

/* Compares two triangles by their centres on the axis `*axis` (0 to 2 for x to z), for
 * qsort_r(). */
static int compare_on_axis(const void *a, const void *b, void *axis)
{
    const struct refit_tree_triangle *t[2] = { a, b };
    float sum[2];
    for (int i = 0; i < 2; i++) {
        const float *corner[3] = { &t[i]->corner[0].x, &t[i]->corner[1].x, &t[i]->corner[2].x };
        const int k = *(const int *)axis;
        sum[i] = corner[0][k] + corner[1][k] + corner[2][k];
    }
    return (sum[0] > sum[1]) - (sum[0] < sum[1]);
}

static vec3 componentwise_min(vec3 a, vec3 b)
{
    return v3(fminf(a.x, b.x), fminf(a.y, b.y), fminf(a.z, b.z));
}

static vec3 componentwise_max(vec3 a, vec3 b)
{
    return v3(fmaxf(a.x, b.x), fmaxf(a.y, b.y), fmaxf(a.z, b.z));
}

/* A range of triangles that must still be split. `parent` is the index of the tree node whose
 * second child will be made from the range. */
struct range {
    uint32_t first, count, parent;
};

void refit_tree_build(struct refit_tree *tree)
{
    CORE_ASSERT(tree->triangle_count <= REFIT_TREE_TRIANGLE_MAX);
    struct range waiting[DEPTH_MAX] = { { 0, tree->triangle_count, UINT32_MAX } };
    uint32_t depth = 1;
    tree->node_count = 0;
    while (depth > 0) {
        const struct range range = waiting[--depth];
        const uint32_t index = tree->node_count++;
        struct refit_tree_node *node = &tree->nodes[index];
        if (range.parent != UINT32_MAX) {
            tree->nodes[range.parent].first = index;
        }
        *node = (struct refit_tree_node){ .first = range.first, .count = range.count };
        node->low = v3(INFINITY, INFINITY, INFINITY);
        node->high = v3(-INFINITY, -INFINITY, -INFINITY);
        for (uint32_t i = node->first; i < node->first + node->count; i++) {
            for (uint32_t k = 0; k < 3; k++) {
                node->low = componentwise_min(node->low, tree->triangles[i].corner[k]);
                node->high = componentwise_max(node->high, tree->triangles[i].corner[k]);
            }
        }
        if (range.count <= LEAF_MAX) {
            continue;
        }
        const vec3 size = v3_sub(node->high, node->low);
        int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        qsort_r(&tree->triangles[range.first], range.count, sizeof tree->triangles[0],
                compare_on_axis, &axis);
        const uint32_t half = range.count / 2;
        node->count = 0;
        waiting[depth++] = (struct range){ range.first + half, range.count - half, index };
        waiting[depth++] = (struct range){ range.first, half, UINT32_MAX };
    }
}

/* Returns the point of a triangle that is nearest to `p`. The projection of `p` to the plane of the
 * triangle decides whether the point is a corner, on an edge, or inside the triangle. */
static vec3 on_triangle(const struct refit_tree_triangle *t, vec3 p)
{
    const vec3 a = t->corner[0], b = t->corner[1], c = t->corner[2];
    const vec3 ab = v3_sub(b, a), ac = v3_sub(c, a), ap = v3_sub(p, a);
    const float d1 = v3_dot(ab, ap), d2 = v3_dot(ac, ap);
    if (d1 <= 0.0f && d2 <= 0.0f) {
        return a;
    }
    const vec3 bp = v3_sub(p, b), cp = v3_sub(p, c);
    const float d3 = v3_dot(ab, bp), d4 = v3_dot(ac, bp);
    const float d5 = v3_dot(ab, cp), d6 = v3_dot(ac, cp);
    if (d3 >= 0.0f && d4 <= d3) {
        return b;
    }
    if (d6 >= 0.0f && d5 <= d6) {
        return c;
    }
    const float vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f && d1 > d3) {
        return v3_muladd(a, ab, d1 / (d1 - d3));
    }
    if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f && d2 > d6) {
        return v3_muladd(a, ac, d2 / (d2 - d6));
    }
    const float along = d4 - d3, back = d5 - d6;
    if (va <= 0.0f && along >= 0.0f && back >= 0.0f && along + back > 0.0f) {
        return v3_muladd(b, v3_sub(c, b), along / (along + back));
    }
    const float sum = va + vb + vc;
    return sum > 0.0f ? v3_muladd(v3_muladd(a, ab, vb / sum), ac, vc / sum) : a;
}

static float distance2(vec3 a, vec3 b)
{
    const vec3 d = v3_sub(a, b);
    return v3_dot(d, d);
}

static float to_box2(const struct refit_tree_node *node, vec3 p)
{
    return distance2(p, componentwise_min(componentwise_max(p, node->low), node->high));
}

float refit_tree_nearest(const struct refit_tree *tree, vec3 from, uint8_t part, vec3 *place)
{
    uint32_t waiting[DEPTH_MAX] = { 0 }, depth = tree->node_count > 0 ? 1 : 0;
    float best = INFINITY;
    while (depth > 0) {
        const uint32_t index = waiting[--depth];
        const struct refit_tree_node *node = &tree->nodes[index];
        if (to_box2(node, from) >= best) {
            continue;
        }
        for (uint32_t i = node->first; i < node->first + node->count; i++) {
            const struct refit_tree_triangle *t = &tree->triangles[i];
            const vec3 at = on_triangle(t, from);
            const float far = distance2(from, at);
            if (far < best && (part == REFIT_TREE_ANY_PART || part == t->part)) {
                best = far;
                *place = at;
            }
        }
        if (node->count == 0 && tree->triangle_count > 0) {
            const uint32_t left = index + 1, right = node->first;
            const bool left_first =
                to_box2(&tree->nodes[left], from) < to_box2(&tree->nodes[right], from);
            waiting[depth++] = left_first ? right : left;
            waiting[depth++] = left_first ? left : right;
        }
    }
    return best;
}
