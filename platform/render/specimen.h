/* specimen.h -- a specimen: one fish of any species and age, seen from any side, as the growth lab
 * and the album show it. This header contains plain data and arithmetic. specimen_pass.h draws
 * specimens.
 *
 * A screen adds specimens to its batch (ui_batch.h) between its quads. Coordinates are pixels with
 * the origin at the top left and +y downward. The projection has no perspective, so that
 * `length_px` is the fish's length everywhere on the screen. */
#pragma once

#include <stdint.h>

#include "core/morph/morph.h"

/* Maximum number of specimens on a screen. The growth lab shows its fish, a comparison fish and
 * eight key shapes. The album shows one specimen for each picture of a page. */
#define SPECIMEN_MAX 24u

struct specimen {
    /* Species data, which must not change until the frame has been drawn. */
    const struct species *species;
    /* Number that changes whenever the memory at `species` receives the data of a different
     * species. */
    uint32_t edition;
    /* Deformation graphs, prepared for computing poses. The structure must be valid until the frame
     * has been drawn. Null means the species' own graphs. */
    const struct morph_rig *rig;
    float progress; /* Progress through life, [0, 1]. */
    /* Screen position in pixels of the body's centre, which is the point z = 0 of the body's
     * coordinate system. */
    float x_px, y_px;
    /* Length on the screen in pixels of one body length of the species, > 0. */
    float length_px;
    /* Rotation. Zero shows the left side with the nose to the left. Yaw turns the nose toward the
     * viewer, pitch turns the back toward the viewer, and roll lowers the nose on the screen. */
    float yaw_rad, pitch_rad, roll_rad;
    float phase_rad; /* Phase of the swimming motion, in radians. */
    float amplitude; /* Strength of the swimming motion. 0 means still, 1 means cruising. */
    float shadow;    /* Darkness of the shadow below the fish, [0, 1]. 0 means no shadow. */
    /* Transparency of the whole fish, [0, 1]. 0 means opaque, 1 means invisible. */
    float fade;
    /* Colour 0xRRGGBBAA that is mixed over the fish's paint with the weight of its alpha. 0 shows
     * only the paint. */
    uint32_t tint;
    /* Number from which the pattern of a goldfish is selected, as in struct scene_fish. Unused for
     * other species. */
    uint32_t look;
    /* Opacity of a goldfish's adult pattern over its juvenile paint, [0, 1]. Unused for other
     * species. */
    float ripe;
    /* Fraction of a goldfish's juvenile grey that has turned into colour, as in struct scene_fish.
     * Unused for other species. */
    float maturity;
};

/* Directions on the screen (right, up, toward the viewer) of the axes of the fish's body. */
struct specimen_axes {
    vec3 right, up, toward;
};
struct specimen_axes specimen_axes(const struct specimen *specimen);

/* Projects a point of the body's coordinate system to the screen position `out` (x, y) in pixels.
 * `point` is in body lengths, as returned by morph_shape(), without the swimming motion. */
void specimen_project(const struct specimen *specimen, vec3 point, float out[2]);

/* Maximum extent of a fish from its body's centre over all key shapes, in body lengths. A box of
 * this extent contains the fish at every age, without the swimming motion. */
struct specimen_bounds {
    /* Extents to the left, to the right, upward and downward, each >= 0. */
    float left, right, up, down;
};
/* Returns the bounds of the specimen with its rotation. */
struct specimen_bounds specimen_bounds(const struct specimen *specimen);

/* Sets position and length so that the fish fits into the box at every age and is centred. Takes
 * about 0.1 ms. */
void specimen_fit(struct specimen *specimen, float x_px, float y_px, float width_px,
                  float height_px);

/* Sets yaw and pitch to the usual view of an illustration. Most species are seen from the left, an
 * eel from slightly above so that its wave is visible, and a stingray from high above. Leaves all
 * other fields unchanged. */
void specimen_portrait(struct specimen *specimen);
