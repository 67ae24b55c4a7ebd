/* loft_eye.c -- lofts the eyes as closed balls. Each ball is partly inside the head, and moves and
 * turns with the skin. */
#include "platform/species/loft_parts.h"

#include <math.h>

#define PI 3.14159265358979323846

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
    for (uint32_t key = 0; key < l->species->key_count; key++) {
        const struct ball ball = shape_eye_ball(&l->species->keys[key], side);
        const double out = cos(polar) > 0.0 ? ball.out : ball.in;
        const double c = cos(polar), s = sin(polar);
        const v3d p = { out * c - ball.sunk, ball.radius * s * cos(angle),
                        ball.radius * s * sin(angle) };
        const v3d n = { c / out, s * cos(angle) / ball.radius, s * sin(angle) / ball.radius };
        loft_place_from_anchor(l, key, p, v3d_unit(n));
    }
}

/* Returns the polar angle of ring number `ring` of `count` rings. Rings are counted from the pupil
 * to the back of the ball. More than half of the rings lie between the pupil and the rim, and one
 * ring lies on the rim. */
static double ring_polar(uint32_t ring, uint32_t count)
{
    const uint32_t shown = (count + 2) / 2;
    return ring <= shown ? EYE_RIM_RAD * ring / shown
                         : EYE_RIM_RAD + (PI - EYE_RIM_RAD) * (ring - shown) / (count + 1 - shown);
}

static void add_eye(struct lofting *l, uint32_t side)
{
    const uint32_t rings = l->detail->eye_rings, spokes = l->detail->eye_spokes;
    struct species_anchor *anchor = loft_next_anchor(l, PART_EYE, 1);
    for (uint32_t key = 0; key < l->species->key_count; key++) {
        const struct ball ball = shape_eye_ball(&l->species->keys[key], side);
        anchor->u[key] = (float)ball.u;
        anchor->v[key] = (float)ball.v;
    }
    const uint32_t front = l->loft->vertex_count, first = front + 1;
    add_ball_vertex(l, side, 0.0, 0.0);
    for (uint32_t ring = 1; ring <= rings; ring++) {
        for (uint32_t spoke = 0; spoke < spokes; spoke++) {
            add_ball_vertex(l, side, ring_polar(ring, rings), 2.0 * PI * spoke / spokes);
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

void loft_add_eyes(struct lofting *l)
{
    add_eye(l, 0);
    add_eye(l, 1);
}
