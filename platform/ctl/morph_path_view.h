/* morph_path_view.h -- what a picture of a part's way shows, and where on the paper. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_PATH_VIEW_H
#define KINGYO_PLATFORM_CTL_MORPH_PATH_VIEW_H

#include "platform/ctl/morph_outline.h"
#include "platform/ctl/morph_path.h"

#define PATH_WIDTH 1280.0
#define PATH_HEIGHT 640.0
#define PATH_SAMPLES 200u
#define PATH_LENS 500.0 /* The enlarged square's side. */

/* A frame of the paper, and what of the fish it shows. */
struct window {
    double x, y, width, height; /* Of the frame. */
    double length_px;
    vec3 middle;                /* What is in its middle, ... */
    double shift_x, shift_y;    /* ... but for this. */
    enum outline_view view;
};

struct picture {
    const struct path_plan *plan;
    struct svg svg;
    struct morph_rig keys;         /* That reaches every key whole. */
    vec3 way[PATH_SAMPLES + 1u];   /* The part's, ... */
    vec3 drawn[PATH_SAMPLES + 1u]; /* ... and with --thesis what our own method makes of it. */
    vec3 farthest;                 /* From the chord. */
    float farthest_progress, farthest_lengths;
};

/* Fills the picture's ways; plan and keys are there already. */
void path_walk(struct picture *picture);

/* Where a key's drawing has the part's vertex. */
vec3 path_key(const struct picture *picture, uint32_t key);

/* Where the shape solved for a key has it: beyond the drawing, so that the way passes through the
 * drawing (2005 thesis, section 4.2). */
vec3 path_solved(const struct picture *picture, uint32_t key);

/* An outline's view, place and size in a window. */
struct outline path_outline(const struct window *window);

void path_place(const struct window *window, vec3 p, double *x, double *y);

/* From the side, unless another view shows more of the way. */
enum outline_view path_best_view(const struct picture *picture);

/* The window that holds all keys' fish, and the one that enlarges the way and its keys, drawn and
 * solved. */
struct window path_whole(const struct picture *picture, enum outline_view view);
struct window path_lens(const struct picture *picture, enum outline_view view);

#endif
