/* pose.c -- computes the pose of a fish: the weights of its drawn keys from its deformation graphs,
 * and the places of its anchors. Fins slide on the skin, and eyes move around the head.
 *
 * The body coordinates of an anchor are blended, and the anchor is then placed on the blended skin.
 * A blend of the anchor's positions would move the anchor in a straight line. A fin that slides
 * forward would then cut through the back, and an eye would pass through the head (2005 thesis,
 * sections 4.1.3 and 4.1.4). */
#include "core/morph/morph.h"

#include "core/base/panic.h"

vec3 pose_rotate(struct quat q, vec3 a)
{
    const vec3 axis = v3(q.x, q.y, q.z);
    const vec3 across = v3_scale(v3_cross(axis, a), 2.0f);
    return v3_add(v3_muladd(a, across, q.w), v3_cross(axis, across));
}

vec3 pose_rotate_inverse(struct quat q, vec3 a)
{
    return pose_rotate((struct quat){ -q.x, -q.y, -q.z, q.w }, a);
}

/* Returns the rotation at a point of the skin with the given normal. The x axis points along the
 * normal, the z axis points backward along the skin, and y = z cross x. The result is the
 * quaternion that rotates the body's axes to these axes.
 *
 * The code divides only by the larger of the quaternion's components w and z, which is at least
 * 0.5. Proof: w4 = 4 * w^2 and z4 = 4 * z^2 have the sum 2 + 2 * z.z, where z.z is the backward
 * component of the z axis. z.z is never negative, so w4 or z4 is at least 1. */
static struct quat skin_turn(vec3 normal)
{
    const vec3 x = v3_normalize_or(normal, v3(0.0f, 1.0f, 0.0f));
    const vec3 back = v3(0.0f, 0.0f, 1.0f);
    const vec3 z = v3_normalize_or(v3_muladd(back, x, -x.z), v3(0.0f, -1.0f, 0.0f));
    const vec3 y = v3_cross(z, x);
    const float w4 = 1.0f + x.x + y.y + z.z, z4 = 1.0f - x.x - y.y + z.z;
    const float k = 0.5f / f_sqrt(f_max(w4, z4));
    if (w4 >= z4) {
        return (struct quat){ (y.z - z.y) * k, (z.x - x.z) * k, (x.y - y.x) * k, w4 * k };
    }
    return (struct quat){ (z.x + x.z) * k, (y.z + z.y) * k, z4 * k, (x.y - y.x) * k };
}

struct cell {
    uint32_t corner[4]; /* Indices of the cell's four vertices: (ring, spoke), (ring, next spoke),
                           (next ring, spoke), (next ring, next spoke). */
    float along, round; /* Position within the cell, each in [0, 1]: `along` in the direction of the
                           next ring, `round` in the direction of the next spoke. */
};

/* Returns the cell of the skin's grid that contains the body coordinates (u, v). The ring is found
 * by bisection, because u increases from ring to ring. If u is beyond the last ring, returns a cell
 * before the last ring. */
static struct cell skin_cell(const struct species_mesh *mesh, float u, float v)
{
    const uint32_t row = mesh->grid_spokes + 1u, first = mesh->grid_first;
    CORE_ASSERT(first + mesh->grid_rings * row <= mesh->vertex_count);
    uint32_t ring = 0, behind = mesh->grid_rings - 1u;
    while (behind - ring > 1u) {
        const uint32_t middle = (ring + behind) / 2u;
        if (mesh->vertices[first + middle * row].u <= u) {
            ring = middle;
        } else {
            behind = middle;
        }
    }
    const float from = mesh->vertices[first + ring * row].u;
    const float to = mesh->vertices[first + (ring + 1u) * row].u;
    const float turn = (v - f_floor(v)) * (float)mesh->grid_spokes;
    const uint32_t spoke = (uint32_t)f_min(turn, (float)(mesh->grid_spokes - 1u));
    const uint32_t corner = first + ring * row + spoke;
    return (struct cell){ .corner = { corner, corner + 1u, corner + row, corner + row + 1u },
                          .along = f_clamp((u - from) / (to - from), 0.0f, 1.0f),
                          .round = turn - (float)spoke };
}

struct anchor_pose morph_ride(const struct species_mesh *mesh, uint32_t key_count,
                              const struct morph_pose *pose, float u, float v, bool turns)
{
    CORE_ASSERT(mesh->grid_rings >= 2 && mesh->grid_spokes >= 3);
    const struct cell cell = skin_cell(mesh, u, v);
    struct anchor_pose at = { .turn = { 0.0f, 0.0f, 0.0f, 1.0f } };
    vec3 normal = { 0.0f, 0.0f, 0.0f };
    /* The cell consists of two triangles, whose common side joins corner 1 and corner 2. `shares`
     * are the weights of the four corners, with which the interpolation gives a point exactly on
     * the drawn surface. */
    const float along = cell.along, round = cell.round;
    const bool far = along + round > 1.0f;
    const float shares[4] = { far ? 0.0f : 1.0f - along - round, far ? 1.0f - along : round,
                              far ? 1.0f - round : along, far ? along + round - 1.0f : 0.0f };
    for (uint32_t i = 0; i < 4; i++) {
        if (shares[i] > 0.0f) {
            const vec3 corner = morph_place(mesh, key_count, pose, cell.corner[i]);
            at.position = v3_muladd(at.position, corner, shares[i]);
        }
        if (shares[i] > 0.0f && turns) {
            const struct morph_point p = morph_point(mesh, key_count, pose, cell.corner[i]);
            normal = v3_muladd(normal, p.normal, shares[i]);
        }
    }
    if (turns) {
        at.turn = skin_turn(normal);
    }
    return at;
}

/* Writes the anchors of `pose` for the weights that `pose` already contains. The body coordinates u
 * and v of each anchor are blended by the weights of the anchor's curve. */
static void ride_all(const struct species_mesh *mesh, uint32_t key_count, struct morph_pose *pose)
{
    CORE_ASSERT(mesh->anchor_count <= ANCHOR_MAX);
    CORE_ASSERT(key_count >= 1 && key_count <= MORPH_KEY_MAX);
    for (uint32_t i = 0; i < mesh->anchor_count; i++) {
        const struct species_anchor *anchor = &mesh->anchors[i];
        CORE_ASSERT(anchor->curve < MORPH_CURVE_MAX);
        const float *weight = pose->weight[anchor->curve];
        float u = 0.0f, v = 0.0f;
        for (uint32_t key = 0; key < key_count; key++) {
            u += weight[key] * anchor->u[key];
            v += weight[key] * anchor->v[key];
        }
        pose->anchor[i] = morph_ride(mesh, key_count, pose, u, v, anchor->turns != 0);
    }
}

void morph_rig_init(struct morph_rig *rig, const struct species_card *card,
                    enum graph_template template_id)
{
    CORE_ASSERT(template_id < TEMPLATE_COUNT);
    CORE_ASSERT(card->key_count >= 2 && card->key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(card->curve_count >= 1 && card->curve_count <= MORPH_CURVE_MAX);
    *rig = (struct morph_rig){ .key_count = card->key_count, .curve_count = card->curve_count };
    for (uint32_t curve = 0; curve < card->curve_count; curve++) {
        struct graph *graph = &rig->curves[curve];
        uint32_t stuck;
        *graph = card->curves[curve];
        if (template_id != TEMPLATE_OWN) {
            graph_from_template(graph, template_id, card->key_count, SIMULTANEOUS_PEAK);
        }
        graph->solved =
            graph->solved && graph_solve(graph, card->key_count, rig->solution[curve], &stuck);
        for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
            for (uint32_t j = 0; j < MORPH_KEY_MAX && !graph->solved; j++) {
                rig->solution[curve][i][j] = i == j ? 1.0f : 0.0f;
            }
        }
    }
}

/* Converts the weights of the exaggerated key shapes to weights of the drawn keys by multiplication
 * with the matrix `solution` (M^-1 in graph.c). At the progress of key i, key i gets exactly the
 * weight 1, without rounding errors. */
static void weights_of_drawn(const struct morph_rig *rig, uint32_t curve, float progress,
                             float weights[MORPH_KEY_MAX])
{
    const float last = (float)(rig->key_count - 1u);
    float drawn[MORPH_KEY_MAX] = { 0 };
    for (uint32_t j = 0; j < rig->key_count; j++) {
        for (uint32_t i = 0; i < rig->key_count; i++) {
            drawn[j] += weights[i] * rig->solution[curve][i][j];
        }
    }
    for (uint32_t key = 0; key < rig->key_count; key++) {
        if (progress == (float)key / last) {
            for (uint32_t j = 0; j < rig->key_count; j++) {
                drawn[j] = j == key ? 1.0f : 0.0f;
            }
        }
    }
    for (uint32_t j = 0; j < rig->key_count; j++) {
        weights[j] = drawn[j];
    }
}

void morph_weights(const struct morph_rig *rig, float progress,
                   float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX])
{
    CORE_ASSERT(rig->curve_count >= 1 && rig->curve_count <= MORPH_CURVE_MAX);
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        const uint32_t from = curve < rig->curve_count ? curve : 0;
        graph_weights(&rig->curves[from], rig->key_count, progress, weights[curve]);
        if (rig->curves[from].solved) {
            weights_of_drawn(rig, from, progress, weights[curve]);
        }
    }
}

void morph_pose(const struct morph_rig *rig, const struct species_mesh *mesh, float progress,
                struct morph_pose *pose)
{
    morph_weights(rig, progress, pose->weight);
    ride_all(mesh, rig->key_count, pose);
}

void morph_key_pose(const struct species_mesh *mesh, uint32_t key_count, uint32_t key,
                    struct morph_pose *pose)
{
    CORE_ASSERT(key < key_count && key_count <= MORPH_KEY_MAX);
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
            pose->weight[curve][i] = i == key ? 1.0f : 0.0f;
        }
    }
    ride_all(mesh, key_count, pose);
}
