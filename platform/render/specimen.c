/* specimen.c -- see specimen.h. */
#include "platform/render/specimen.h"

#define THREE_QUARTER_RAD (14.0f * F_DEG) /* So much of the face and the back gives it body. */

/* (x, y) turned by an angle whose cosine and sine are `c` and `s`. */
static void turn(vec3 *x, vec3 *y, float c, float s)
{
    const vec3 before = *x;
    *x = v3_mad(v3_scale(before, c), *y, s);
    *y = v3_mad(v3_scale(*y, c), before, -s);
}

struct specimen_axes specimen_axes(const struct specimen *specimen)
{
    struct specimen_axes axes = { .right = { 0.0f, 0.0f, 1.0f },
                                  .up = { 0.0f, 1.0f, 0.0f },
                                  .toward = { -1.0f, 0.0f, 0.0f } };
    turn(&axes.right, &axes.toward, f_cos(specimen->yaw_rad), f_sin(specimen->yaw_rad));
    turn(&axes.toward, &axes.up, f_cos(specimen->pitch_rad), f_sin(specimen->pitch_rad));
    turn(&axes.up, &axes.right, f_cos(specimen->roll_rad), f_sin(specimen->roll_rad));
    return axes;
}

void specimen_project(const struct specimen *specimen, vec3 point, float *x_px, float *y_px)
{
    const struct specimen_axes axes = specimen_axes(specimen);
    *x_px = specimen->x_px + specimen->length_px * v3_dot(axes.right, point);
    *y_px = specimen->y_px - specimen->length_px * v3_dot(axes.up, point);
}

void specimen_portrait(struct specimen *specimen)
{
    const struct species_card *card = &specimen->species->card;
    const bool wide = card->form == FORM_DEPRESSED && card->motion == MOTION_WING;
    specimen->yaw_rad = wide ? 25.0f * F_DEG : THREE_QUARTER_RAD;
    specimen->pitch_rad = wide ? 48.0f * F_DEG : 0.5f * THREE_QUARTER_RAD;
}
