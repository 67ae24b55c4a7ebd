/* import_orient.c -- detects the direction of the head and the length of an imported fish, and
 * rotates and scales its mesh. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/import/import.h"

/* The head is at the end toward which the centre of the eyes (or, without named eyes, of the body's
 * triangles) is shifted from the middle of the fish. If the shift is smaller than this fraction of
 * the fish's length, head and tail cannot be distinguished. */
#define UNCLEAR_SHARE 0.015

/* Minimum ratio of the length to the width of a fish. With a smaller ratio, the direction of the
 * head is ambiguous, for example for a ray seen from above. */
#define SQUARE_RATIO 1.15

/* Height of a zone around the middle of the body, as a fraction of the body's height. The shortest
 * rays of a forked tail fin lie in this zone. */
#define MIDDLE_SHARE 0.1f

/* Tolerance for the size of a mesh that kingyoctl wrote. The size differs slightly from 1, because
 * the polygons only approximate the exact length measure. */
#define OURS_OFF 0.1f

const char *const import_axis_names[AXIS_NONE] = { "+x", "+y", "+z", "-x", "-y", "-z" };

enum species_part import_part(const char *group)
{
    /* clang-format off */
    static const struct {
        const char *word;
        enum species_part part;
    } words[] = {
        { "finlets_upper", PART_FINLET_UPPER }, { "finlets_lower", PART_FINLET_LOWER },
        { "finlet_upper", PART_FINLET_UPPER }, { "finlet_lower", PART_FINLET_LOWER },
        { "dorsal_2", PART_DORSAL_2 },         { "dorsal2", PART_DORSAL_2 },
        { "dorsal", PART_DORSAL },             { "anal", PART_ANAL },
        { "pectoral", PART_PECTORAL },         { "pelvic", PART_PELVIC },
        { "ventral", PART_PELVIC },            { "tail", PART_TAIL },
        { "caudal", PART_TAIL },               { "eye", PART_EYE },
    };
    /* clang-format on */
    char lower[IMPORT_NAME_SIZE] = "";
    for (size_t i = 0; i + 1 < sizeof lower && group[i]; i++) {
        lower[i] = (char)tolower((unsigned char)group[i]);
    }
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        if (strstr(lower, words[i].word)) {
            return words[i].part;
        }
    }
    return PART_BODY;
}

static float import_orient_along(vec3 p, uint32_t axis)
{
    const float x[3] = { p.x, p.y, p.z };
    return axis < AXIS_MINUS_X ? x[axis] : -x[axis - AXIS_MINUS_X];
}

static vec3 axis_vector(uint32_t axis)
{
    CORE_ASSERT(axis < AXIS_NONE);
    float x[3] = { 0.0f, 0.0f, 0.0f };
    x[axis % AXIS_MINUS_X] = axis < AXIS_MINUS_X ? 1.0f : -1.0f;
    return v3(x[0], x[1], x[2]);
}

struct extent {
    float low, high;
};

/* Returns the extent along `axis` of the vertices that belong to triangles. If `body` is true, only
 * the triangles of the body are used. */
static struct extent extent_of(const struct import_mesh *mesh, uint32_t key, uint32_t axis,
                               bool body)
{
    struct extent e = { INFINITY, -INFINITY };
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        for (uint32_t k = 0; k < 3 && (!body || import_part_of(mesh, i) == PART_BODY); k++) {
            const float x = import_orient_along(mesh->positions[key][mesh->triangles[i][k]], axis);
            e.low = fminf(e.low, x);
            e.high = fmaxf(e.high, x);
        }
    }
    return e;
}

/* Returns the mean of the triangle centres along `axis`, weighted by area. If the file names the
 * eyes, uses only the triangles of the eyes, otherwise the triangles of the body. */
static double middle_along(const struct import_mesh *mesh, uint32_t axis)
{
    const uint32_t key = mesh->key_count - 1;
    double sum[2] = { 0.0, 0.0 }, area[2] = { 0.0, 0.0 };
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i];
        const vec3 a = mesh->positions[key][t[0]], b = mesh->positions[key][t[1]],
                   c = mesh->positions[key][t[2]];
        const enum species_part part = import_part_of(mesh, i);
        const double weight = (double)v3_length(v3_cross(v3_sub(b, a), v3_sub(c, a)));
        const double middle =
            ((double)import_orient_along(a, axis) + (double)import_orient_along(b, axis) +
             (double)import_orient_along(c, axis)) /
            3.0;
        if (part == PART_BODY || part == PART_EYE) {
            sum[part == PART_EYE] += weight * middle;
            area[part == PART_EYE] += weight;
        }
    }
    const bool has_eyes = area[1] > 0.0;
    return area[has_eyes] > 0.0 ? sum[has_eyes] / area[has_eyes] : 0.0;
}

/* Finds the direction of the snout and writes it to `front`. The head is at the end that is nearer
 * to the eyes. Without named eyes, the head is the thicker half of the body. Returns false and
 * writes the reason to `why` if the direction is ambiguous. */
static bool find_front(const struct import_mesh *mesh, uint32_t up, uint8_t *front,
                       char why[IMPORT_WHY_SIZE])
{
    double length[3], middle[3];
    for (uint32_t axis = 0; axis < 3; axis++) {
        const struct extent e = extent_of(mesh, mesh->key_count - 1, axis, false);
        length[axis] = (double)e.high - (double)e.low;
        middle[axis] = 0.5 * ((double)e.low + (double)e.high);
    }
    const uint32_t one = (up + 1) % 3, two = (up + 2) % 3;
    const uint32_t axis = length[one] > length[two] ? one : two;
    if (length[up] > SQUARE_RATIO * length[axis]) {
        return import_error(
            why, "front: the fish is longest along %s, the direction of its back; use --up AXIS",
            import_axis_names[up]);
    }
    if (length[axis] < SQUARE_RATIO * fmin(length[one], length[two])) {
        return import_error(why, "front: the fish is nearly as wide as long; use --front AXIS");
    }
    const double off = middle_along(mesh, axis) - middle[axis];
    if (fabs(off) < UNCLEAR_SHARE * length[axis]) {
        return import_error(why, "front: head and tail cannot be distinguished; use --front AXIS");
    }
    *front = (uint8_t)(off > 0.0 ? axis : axis + AXIS_MINUS_X);
    return true;
}

/* Returns the z coordinate of the fork of the tail fin. The fork is the rearmost point of the body
 * and of the middle rays of the tail fin. */
static float fork_of(const struct import_mesh *mesh, uint32_t key)
{
    const struct extent y = extent_of(mesh, key, AXIS_Y, true);
    float far = -INFINITY;
    for (uint32_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const uint32_t t = i / 3;
        const vec3 p = mesh->positions[key][mesh->triangles[t][i % 3]];
        const enum species_part part = import_part_of(mesh, t);
        const float off = fabsf(p.y - 0.5f * (y.low + y.high));
        if (part == PART_BODY || (part == PART_TAIL && off < MIDDLE_SHARE * (y.high - y.low))) {
            far = fmaxf(far, p.z);
        }
    }
    return far;
}

bool import_orient(struct import_mesh *mesh, const struct import_options *plan,
                   struct import_report *report, char why[IMPORT_WHY_SIZE])
{
    CORE_ASSERT(plan->up < AXIS_NONE);
    CORE_ASSERT(plan->front <= AXIS_NONE);
    report->front = mesh->is_ours && plan->front == AXIS_NONE ? AXIS_Z : plan->front;
    if (report->front == AXIS_NONE && !find_front(mesh, plan->up % 3, &report->front, why)) {
        return false;
    }
    CORE_ASSERT(report->front < AXIS_NONE);
    if (report->front % 3 == plan->up % 3) {
        return import_error(why,
                            "front is %s and up is %s; set different axes with --front and --up",
                            import_axis_names[report->front], import_axis_names[plan->up]);
    }
    const vec3 back = v3_scale(axis_vector(report->front), -1.0f), up = axis_vector(plan->up),
               right = v3_cross(up, back);
    for (uint32_t key = 0; key < mesh->key_count; key++) {
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            vec3 *p = &mesh->positions[key][i];
            *p = v3(v3_dot(*p, right), v3_dot(*p, up), v3_dot(*p, back));
        }
    }
    /* True if the mesh needs no shift and no scaling. A mesh that kingyoctl wrote already has the
     * size and the position that a species requires. */
    bool is_settled = mesh->is_ours;
    for (uint32_t key = 0; key < mesh->key_count; key++) {
        const struct extent extent =
            extent_of(mesh, key, plan->measure == MEASURE_DISC ? AXIS_X : AXIS_Z,
                      plan->measure == MEASURE_STANDARD);
        report->size[key] =
            (plan->measure == MEASURE_FORK ? fork_of(mesh, key) : extent.high) - extent.low;
        if (!(report->size[key] > 1e-6f)) {
            return import_error(why, "%.40s: has no length", mesh->key_names[key]);
        }
        is_settled = is_settled && fabsf(report->size[key] - 1.0f) < OURS_OFF;
    }
    for (uint32_t key = 0; key < mesh->key_count; key++) {
        /* Moves the snout to z = -0.5 and the middle of the body to x = y = 0, and scales the mesh
         * so that the size becomes 1. */
        const struct extent x = extent_of(mesh, key, AXIS_X, true);
        const struct extent y = extent_of(mesh, key, AXIS_Y, true);
        const struct extent z = extent_of(mesh, key, AXIS_Z, false);
        const vec3 from = v3(0.5f * (x.low + x.high), 0.5f * (y.low + y.high), z.low);
        for (uint32_t i = 0; i < mesh->vertex_count && !is_settled; i++) {
            vec3 *p = &mesh->positions[key][i];
            *p = v3_scale(v3_sub(*p, from), 1.0f / report->size[key]);
            p->z -= 0.5f;
        }
        report->size[key] *= mesh->scales[key];
    }
    return true;
}
