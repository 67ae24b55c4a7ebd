/* specimen.h -- one fish of any species and age, seen from any side, as the growth lab and the
 * album show it. Plain data and arithmetic; specimen_pass.h draws it.
 *
 * A screen adds specimens to its batch (ui_batch.h) between its quads. Coordinates are pixels,
 * origin at the top left, +y down. There is no perspective: `length_px` is the fish's length at
 * every place. */
#ifndef KINGYO_PLATFORM_RENDER_SPECIMEN_H
#define KINGYO_PLATFORM_RENDER_SPECIMEN_H

#include <stdbool.h>
#include <stdint.h>

#include "core/morph/morph.h"

/* Maximum of a screen: the lab's fish, its comparison fish and eight keys, or one album page. */
#define SPECIMEN_MAX 24u

struct specimen {
    const struct species *species; /* Species data, which must not change until the frame is
                                      drawn. */
    uint32_t edition;              /* Changes whenever `species` holds another fish. */
    const struct morph_rig *rig;   /* Rig, valid until the frame is drawn; null: the species' own
                                      curves. */
    float progress;                /* Progress through life, [0, 1]. */
    float x_px, y_px;              /* Position of the body's centre (z = 0 of its frame). */
    float length_px;               /* Pixels of one measure of the species; > 0. */
    /* Rotation; 0 shows the left side with the nose to the left. Yaw turns the nose toward the
     * viewer, pitch turns the back toward the viewer, roll lowers the nose on the screen. */
    float yaw_rad, pitch_rad, roll_rad;
    float phase_rad; /* Phase of swimming in place. */
    float amplitude; /* Strength of swimming: 0 still, 1 cruising. */
    float shadow;    /* Darkness of the shadow below the fish, [0, 1]; 0: none. */
    float fade;      /* [0, 1]: 0 is opaque, 1 invisible. */
    uint32_t tint;   /* 0xRRGGBBAA, mixed over the fish's paint by its alpha; 0: paint only. */
    uint32_t look;   /* Goldfish only: pattern, as in struct scene_fish. */
    float ripe;      /* Goldfish only: how far the pattern has replaced the juvenile coat, [0,
                        1]. */
    float maturity;  /* Goldfish only: how far the grey has turned, as in struct scene_fish. */
};

/* The body's axes in screen directions: right, up, and toward the viewer. */
struct specimen_axes {
    vec3 right, up, toward;
};
struct specimen_axes specimen_axes(const struct specimen *specimen);

/* Projects a point of the body's frame to pixels. `point` is in lengths, as returned by
 * morph_shape(), without the swimming motion. */
void specimen_project(const struct specimen *specimen, vec3 point, float *x_px, float *y_px);

/* Largest extent from the body's centre over all keys, in lengths: a frame that contains the fish
 * at every age. Excludes the swimming motion. */
struct specimen_bounds {
    float left, right, up, down; /* >= 0 each. */
};
struct specimen_bounds specimen_bounds(const struct specimen *specimen);

/* Sets position and length so that the fish fits centred in the box at every age. Takes about
 * 0.1 ms. */
void specimen_fit(struct specimen *specimen, float x_px, float y_px, float width_px,
                  float height_px);

/* Sets yaw and pitch to the usual view of an illustration: most species from the left, an eel from
 * slightly above so that its wave is visible, a ray from high above. Other fields are unchanged. */
void specimen_portrait(struct specimen *specimen);

#endif
