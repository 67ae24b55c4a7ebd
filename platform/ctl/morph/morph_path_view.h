/* morph_path_view.h -- the contents of the picture of a part's path, and their layout. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_PATH_VIEW_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_PATH_VIEW_H

#include "platform/ctl/morph/morph_outline.h"
#include "platform/ctl/morph/morph_path.h"

#define MORPH_PATH_WIDTH 1280.0
#define MORPH_PATH_HEIGHT 640.0
#define MORPH_PATH_SAMPLES 200u
#define MORPH_PATH_LENS 500.0 /* Side of the square that shows the path enlarged, pixels. */

/* A window of the picture, and the part of the fish that the window shows. */
struct window {
    double x, y, width, height; /* Position and size of the window's frame, pixels. */
    double length_px;
    /* Body point at the middle of the window, before `shift_x` and `shift_y` are applied. */
    vec3 middle;
    double shift_x, shift_y; /* Offset of `middle` from the window's middle, pixels. */
    enum morph_outline_view view;
};

struct picture {
    const struct morph_path_plan *plan;
    struct svg svg;
    struct morph_rig keys;             /* Rig that reaches every key completely. */
    vec3 way[MORPH_PATH_SAMPLES + 1u]; /* Path of the part. */
    /* Path that Kingyo's own method gives. Used only with --thesis. */
    vec3 drawn[MORPH_PATH_SAMPLES + 1u];
    vec3 farthest; /* Point of the path that is farthest from the chord. */
    float farthest_progress, farthest_lengths;
};

/* Computes the paths of the picture. The caller has already set the plan and the keys. */
void morph_path_walk(struct picture *picture);

/* Returns the position of the part's vertex in a key's drawing. */
vec3 morph_path_key(const struct picture *picture, uint32_t key);

/* Returns the position of the part's vertex in the shape solved for a key. The solved shape lies
 * beyond the drawing so that the path passes through the drawing (2005 thesis, section 4.2). */
vec3 morph_path_solved(const struct picture *picture, uint32_t key);

/* morph_path_outline() returns an outline with the view, position and scale of a window.
 * morph_path_place() converts a body point to pixels. */
struct morph_outline morph_path_outline(const struct window *window);

void morph_path_place(const struct window *window, vec3 p, double *x, double *y);

/* Returns the view that shows the longest path. The side view is preferred. */
enum morph_outline_view morph_path_best_view(const struct picture *picture);

/* morph_path_whole() returns the window that contains the fish of all keys. morph_path_lens()
 * returns the window that enlarges the path and its drawn and solved keys. */
struct window morph_path_whole(const struct picture *picture, enum morph_outline_view view);
struct window morph_path_lens(const struct picture *picture, enum morph_outline_view view);

#endif
