/* loft_parts.c -- builds the meshes of the fins and the eyes. A fin is a sheet with one layer of
 * vertices, which is visible from both sides.
 *
 * Each ray of a fin on the body has an anchor at the point where the ray leaves the skin. The
 * vertex positions of the ray are relative to this anchor. The fin therefore moves with the flat
 * triangles of the skin's mesh, and no gap appears at any level of detail. */
#include "platform/species/loft_parts.h"

#include <math.h>

#include "core/base/panic.h"

#define PI 3.14159265358979323846
/* Position of the second row of the tail fin's vertices, as a fraction of the fin's visible length
 * from root to tip. This position is just behind the tail stalk. */
#define TAIL_LEAVES 0.05
/* Minimum number of vertex rows of a tail fin whose second row is placed at TAIL_LEAVES. With fewer
 * rows, the rows are evenly spaced, because all rows are needed to approximate the bend of the
 * fin. */
#define TAIL_ROWS 4

/* Adds the anchor of the ray at position `at` [0, 1] of the fin's base. The anchor lies where the
 * ray leaves the skin. Returns the index of the anchor. Must not be called for the tail fin,
 * because its root has no body coordinates. */
static uint8_t add_root(struct lofting *l, enum species_part part, int side, double at)
{
    struct species_anchor *anchor = loft_next_anchor(l, part, false);
    for (uint32_t key = 0; key < l->species->card.key_count; key++) {
        const struct fin *fin = &l->species->keys[key].fins[part];
        const double girth = part == PART_DORSAL || part == PART_DORSAL_2 ? 0.0
                             : part == PART_ANAL                          ? 0.5
                                                                          : (double)fin->girth;
        const double x = (double)fin->start + ((double)fin->end - (double)fin->start) * at;
        anchor->u[key] = (float)shape_body_u(&l->species->keys[key], x);
        anchor->v[key] = (float)(side > 0 ? girth : 1.0 - girth);
    }
    return (uint8_t)(l->loft->anchor_count - 1);
}

/* Sets the position of the newest vertex to point `p` of the drawing. If the vertex has an anchor,
 * the stored position is relative to the anchor. */
static void place_newest_vertex(struct lofting *l, uint32_t key, v3d p, v3d normal)
{
    const uint8_t index = l->loft->vertices[l->loft->vertex_count - 1].anchor;
    if (index == ANCHOR_NONE) {
        loft_place(l, key, loft_snout, p, normal);
        return;
    }
    const struct species_anchor *anchor = &l->loft->anchors[index];
    const v3d skin =
        shape_body_point(&l->species->keys[key], (double)anchor->u[key], (double)anchor->v[key]);
    loft_place(l, key, (v3d){ 0.0, 0.0, 0.0 }, v3d_sub(p, skin), normal);
}

static void add_fin_vertex(struct lofting *l, enum species_part part, int side, double at,
                           double along, uint8_t anchor)
{
    const bool paired = part == PART_PECTORAL || part == PART_PELVIC;
    loft_next_vertex(l, (struct species_vertex){ .u = (float)at,
                                                 .v = (float)along,
                                                 .part = (uint8_t)part,
                                                 .side = !paired    ? SIDE_MIDDLE
                                                         : side > 0 ? SIDE_RIGHT
                                                                    : SIDE_LEFT,
                                                 .flex = (uint8_t)lround(255.0 * along),
                                                 .anchor = anchor });
    for (uint32_t key = 0; key < l->species->card.key_count; key++) {
        const struct key_text *text = &l->species->keys[key];
        v3d p = shape_fin_point(text, part, at, along), n = shape_fin_normal(text, part, at, along);
        p.x *= side;
        n.x *= side;
        place_newest_vertex(l, key, p, n);
    }
}

/* Positions of the lower and the upper tip of a double tail along its half, from the fold (0) to
 * the lower edge (1). A mesh with few columns has only the fold and the two tips. */
#define DOUBLE_LOWER_TIP 0.8
#define DOUBLE_UPPER_TIP 0.2
#define DOUBLE_COLUMNS_MIN 7u

/* Returns the position along the tail fin's base, [0, 1], of the column at the fraction `t` of all
 * columns. The columns are closer to each other near the tips of the lobes, which are round. The
 * columns of a double tail are equally spaced. */
static double tail_column(const struct lofting *l, double t)
{
    if (!l->species->double_tail) {
        return 0.5 - 0.5 * cos(PI * t);
    }
    if (l->detail->fins[PART_TAIL].across >= DOUBLE_COLUMNS_MIN) {
        return t;
    }
    const double from_fold = fabs(2.0 * t - 1.0);
    const double at = from_fold > 0.75   ? DOUBLE_LOWER_TIP
                      : from_fold > 0.25 ? DOUBLE_UPPER_TIP
                                         : 0.0;
    return 0.5 + (t < 0.5 ? -0.5 : 0.5) * at;
}

static void add_fin(struct lofting *l, enum species_part part, int side)
{
    CORE_ASSERT(part >= PART_TAIL && part < PART_COUNT);
    CORE_ASSERT(l->detail->fins[part].across >= 2 && l->detail->fins[part].along >= 2);
    const uint32_t across = l->detail->fins[part].across, along = l->detail->fins[part].along;
    const uint32_t first = l->loft->vertex_count;
    if (l->species->keys[0].fins[part].ray_count == 0) {
        return;
    }
    for (uint32_t i = 0; i < across; i++) {
        const double t = (double)i / (across - 1);
        const double at = part == PART_TAIL ? tail_column(l, t) : t;
        const uint8_t anchor = part == PART_TAIL ? ANCHOR_NONE : add_root(l, part, side, at);
        for (uint32_t j = 0; j < along; j++) {
            /* `row` is the position of row `j` along the ray, [0, 1]. In the near mesh, the second
             * row of the tail fin is just behind the tail stalk. Otherwise the edges from the first
             * row to the second row would cut through the sides of the stalk. */
            double row = (double)j / (along - 1);
            if (part == PART_TAIL && along >= TAIL_ROWS && j > 0) {
                row = TAIL_LEAVES + (1.0 - TAIL_LEAVES) * (j - 1) / (along - 2);
            }
            add_fin_vertex(l, part, side, at, row, anchor);
        }
    }
    for (uint32_t i = 0; i + 1 < across; i++) {
        for (uint32_t j = 0; j + 1 < along; j++) {
            const uint32_t a = first + i * along + j, b = a + 1, c = a + along, d = c + 1;
            loft_triangle(l, a, c, b);
            loft_triangle(l, b, c, d);
            loft_triangle(l, a, b, c);
            loft_triangle(l, b, d, c);
        }
    }
}

void loft_add_fins(struct lofting *l)
{
    add_fin(l, PART_TAIL, 1);
    add_fin(l, PART_DORSAL, 1);
    add_fin(l, PART_DORSAL_2, 1);
    add_fin(l, PART_ANAL, 1);
    for (int side = 1; side >= -1; side -= 2) {
        add_fin(l, PART_PECTORAL, side);
        add_fin(l, PART_PELVIC, side);
    }
    for (uint32_t row = 0; row < 2; row++) {
        const uint32_t count = l->species->keys[0].finlets[row].count;
        for (uint32_t i = 0; i < count; i++) {
            const double at = (double)i / count;
            const enum species_part part = row == 0 ? PART_FINLET_UPPER : PART_FINLET_LOWER;
            const uint32_t first = l->loft->vertex_count;
            struct species_anchor *anchor = loft_next_anchor(l, part, false);
            for (uint32_t key = 0; key < l->species->card.key_count; key++) {
                const struct finlets *f = &l->species->keys[key].finlets[row];
                const double x = (double)f->start + at * ((double)f->end - (double)f->start);
                anchor->u[key] = (float)shape_body_u(&l->species->keys[key], x);
                anchor->v[key] = row == 0 ? 0.0f : 0.5f;
            }
            for (uint32_t corner = 0; corner < 3; corner++) {
                const double u = at + (corner == 1 ? FINLET_BASE * (1.0 / count) : 0.0);
                loft_next_vertex(
                    l, (struct species_vertex){ .u = (float)u,
                                                .v = corner == 2 ? 1.0f : 0.0f,
                                                .part = (uint8_t)part,
                                                .flex = corner == 2 ? 255 : 0,
                                                .anchor = (uint8_t)(l->loft->anchor_count - 1) });
                for (uint32_t key = 0; key < l->species->card.key_count; key++) {
                    const v3d p = shape_finlet_point(&l->species->keys[key], row, at, corner);
                    place_newest_vertex(l, key, p, (v3d){ 1.0, 0.0, 0.0 });
                }
            }
            loft_triangle(l, first, first + 1, first + 2);
            loft_triangle(l, first, first + 2, first + 1);
        }
    }
}

/* ---- Eyes ------------------------------------------------------------------------------------ */

/* This section builds the mesh of each eye as a closed ball. Each ball is partly inside the head,
 * and moves and turns with the skin. */

/* Adds one vertex of the eye's ball in every key. `polar` is the angle from the pupil: 0 is the
 * pupil's centre, and PI is the back of the ball inside the head. `angle` is the angle round the
 * pupil. */
static void add_ball_vertex(struct lofting *l, uint32_t side, double polar, double angle)
{
    loft_next_vertex(l, (struct species_vertex){ .u = (float)(polar / EYE_RIM_RAD),
                                                 .v = side == 0 ? 0.25f : 0.75f,
                                                 .part = PART_EYE,
                                                 .side = side == 0 ? SIDE_RIGHT : SIDE_LEFT,
                                                 .anchor = (uint8_t)(l->loft->anchor_count - 1) });
    for (uint32_t key = 0; key < l->species->card.key_count; key++) {
        const struct ball ball = shape_eye_ball(&l->species->keys[key], side);
        const double out = cos(polar) > 0.0 ? ball.out : ball.in;
        const double c = cos(polar), s = sin(polar);
        const v3d p = { out * c - ball.sunk, ball.radius * s * cos(angle),
                        ball.radius * s * sin(angle) };
        const v3d n = { c / out, s * cos(angle) / ball.radius, s * sin(angle) / ball.radius };
        loft_place(l, key, (v3d){ 0.0, 0.0, 0.0 }, p, v3d_unit(n));
    }
}

void loft_add_eye(struct lofting *l, uint32_t side)
{
    CORE_ASSERT(side < 2);
    CORE_ASSERT(l->detail->eye_spokes >= 3);
    const uint32_t rings = l->detail->eye_rings, spokes = l->detail->eye_spokes;
    struct species_anchor *anchor = loft_next_anchor(l, PART_EYE, true);
    for (uint32_t key = 0; key < l->species->card.key_count; key++) {
        const struct ball ball = shape_eye_ball(&l->species->keys[key], side);
        anchor->u[key] = (float)ball.u;
        anchor->v[key] = (float)ball.v;
    }
    const uint32_t front = l->loft->vertex_count, first = front + 1;
    add_ball_vertex(l, side, 0.0, 0.0);
    for (uint32_t ring = 1; ring <= rings; ring++) {
        for (uint32_t spoke = 0; spoke < spokes; spoke++) {
            /* The rings are numbered from the pupil to the back of the ball. `shown` is the number
             * of rings in the visible part, from the pupil to the rim (where the ball meets the
             * skin). More than half of the rings are in the visible part. */
            const uint32_t shown = (rings + 2) / 2;
            add_ball_vertex(l, side,
                            ring <= shown ? EYE_RIM_RAD * ring / shown
                                          : EYE_RIM_RAD + (PI - EYE_RIM_RAD) * (ring - shown) /
                                                              (rings + 1 - shown),
                            2.0 * PI * spoke / spokes);
        }
    }
    const uint32_t back = l->loft->vertex_count, last = back - spokes;
    add_ball_vertex(l, side, PI, 0.0);
    for (uint32_t j = 0; j < spokes; j++) {
        const uint32_t k = (j + 1) % spokes;
        loft_triangle(l, front, first + j, first + k);
        for (uint32_t row = first; row < last; row += spokes) {
            loft_triangle(l, row + j, row + spokes + j, row + k);
            loft_triangle(l, row + k, row + spokes + j, row + spokes + k);
        }
        loft_triangle(l, back, last + k, last + j);
    }
}
