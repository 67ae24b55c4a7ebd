/* pose.c -- places the anchors of a blended fish: fins slide on its skin, and eyes move around its
 * head.
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

/* Returns the quaternion that rotates the body's axes to the axes x, y and z. The three axes are
 * orthogonal unit vectors with y = z cross x. The caller guarantees that the backward component z.z
 * is not negative. The larger of the quaternion's components w and z is then at least 0.5. The code
 * divides only by the larger component. */
static struct quat quat_of_axes(vec3 x, vec3 y, vec3 z)
{
    const float w4 = 1.0f + x.x + y.y + z.z, z4 = 1.0f - x.x - y.y + z.z;
    const float k = 0.5f / f_sqrt(f_max(w4, z4));
    if (w4 >= z4) {
        return (struct quat){ (y.z - z.y) * k, (z.x - x.z) * k, (x.y - y.x) * k, w4 * k };
    }
    return (struct quat){ (z.x + x.z) * k, (y.z + z.y) * k, z4 * k, (x.y - y.x) * k };
}

/* Returns the rotation at a point of the skin with the given normal. The x axis points along the
 * normal, the z axis points backward along the skin, and y = z cross x. */
static struct quat skin_turn(vec3 normal)
{
    const vec3 x = v3_normalize_or(normal, v3(0.0f, 1.0f, 0.0f));
    const vec3 back = v3(0.0f, 0.0f, 1.0f);
    const vec3 z = v3_normalize_or(v3_muladd(back, x, -x.z), v3(0.0f, -1.0f, 0.0f));
    return quat_of_axes(x, v3_cross(z, x), z);
}

struct cell {
    uint32_t corner[4]; /* Indices of the cell's four vertices: (ring, spoke), (ring, next spoke),
                           (next ring, spoke), (next ring, next spoke). */
    float along, round; /* Position within the cell, each in [0, 1]: `along` in the direction of the
                           next ring, `round` in the direction of the next spoke. */
};

/* Returns the cell of the skin's grid that contains the body coordinates (u, v). The ring is found
 * by bisection, because u increases from ring to ring. A u beyond the last ring belongs to the last
 * cell. */
static struct cell skin_cell(const struct species_mesh *mesh, float u, float v)
{
    const uint32_t row = mesh->grid_spokes + 1u, first = mesh->grid_first;
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

/* Writes the weight of each corner of the cell for the point at (`along`, `round`). Two triangles
 * make up the cell, and their common diagonal joins corner 1 and corner 2. Interpolation with these
 * weights gives a point exactly on the drawn surface. */
static void corner_shares(const struct cell *cell, float shares[4])
{
    const float along = cell->along, round = cell->round;
    const bool far = along + round > 1.0f;
    shares[0] = far ? 0.0f : 1.0f - along - round;
    shares[1] = far ? 1.0f - along : round;
    shares[2] = far ? 1.0f - round : along;
    shares[3] = far ? along + round - 1.0f : 0.0f;
}

struct anchor_pose morph_ride(const struct species_mesh *mesh, uint32_t key_count,
                              const struct morph_pose *pose, float u, float v, bool turns)
{
    CORE_ASSERT(mesh->grid_rings >= 2 && mesh->grid_spokes >= 3);
    const struct cell cell = skin_cell(mesh, u, v);
    struct anchor_pose at = { .turn = { 0.0f, 0.0f, 0.0f, 1.0f } };
    vec3 normal = { 0.0f, 0.0f, 0.0f };
    float shares[4];
    corner_shares(&cell, shares);
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

void morph_ride_all(const struct species_mesh *mesh, uint32_t key_count, struct morph_pose *pose)
{
    CORE_ASSERT(mesh->anchor_count <= ANCHOR_MAX);
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

void morph_pose(const struct morph_rig *rig, const struct species_mesh *mesh, float progress,
                struct morph_pose *pose)
{
    morph_weights(rig, progress, pose->weight);
    morph_ride_all(mesh, rig->key_count, pose);
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
    morph_ride_all(mesh, key_count, pose);
}
