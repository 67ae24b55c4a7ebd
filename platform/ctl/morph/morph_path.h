/* morph_path.h -- the path of one point of a fish's part during the growth of the fish, as a table
 * and as a picture. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_PATH_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_PATH_H

#include "platform/ctl/morph/morph_options.h"
#include "platform/ctl/morph/morph_outline.h"
#include "platform/species/part.h"

/* Straight line from the first position of the part to its last position, in body coordinates. */
struct chord {
    vec3 from, to;
};

struct morph_path_plan {
    struct morph_options pick;
    const char *part, *side, *svg, *view;
    uint32_t vertex, steps;
    const struct species *ordinary;
    struct morph_rig ordinary_rig;
    struct chord chord, ordinary_chord;
};

/* Draws the path into the SVG file `plan->svg`. Returns EXIT_OK, or prints one line to standard
 * error and returns another exit code. */
enum exit_code morph_path_picture(const struct morph_path_plan *plan, const char *command);

/* ---- Layout and contents of the picture ------------------------------------------------------ */

#define MORPH_PATH_WIDTH 1280.0
#define MORPH_PATH_HEIGHT 640.0
#define MORPH_PATH_SAMPLES 200u
/* Side in pixels of the square window that shows the path enlarged. */
#define MORPH_PATH_LENS 500.0

/* A window of the picture, and the region of the fish that the window shows. */
struct window {
    double x, y, width, height; /* Position and size of the window's frame in pixels. */
    double length_px;
    /* Point of the fish's body that is shown at the middle of the window if `shift_x` and `shift_y`
     * are 0. */
    vec3 middle;
    double shift_x, shift_y; /* Distance of the point `middle` from the middle of the window, in
                                pixels. */
    enum morph_outline_view view;
};

struct picture {
    const struct morph_path_plan *plan;
    struct svg svg;
    struct morph_rig keys;             /* Rig whose weights select exactly one key at the progress
                                          of each key. */
    vec3 way[MORPH_PATH_SAMPLES + 1u]; /* Sampled path of the part, in body coordinates. */
    /* Path of the part by Kingyo's own method, for comparison. Used only with --thesis. */
    vec3 drawn[MORPH_PATH_SAMPLES + 1u];
    vec3 farthest; /* Point of the path with the greatest distance from the chord. */
    float farthest_progress, farthest_lengths;
};

/* Computes the paths of the picture. The caller must set `plan` and `keys` before the call. */
void morph_path_walk(struct picture *picture);

/* Returns the position of the part's vertex in the drawn shape of a key. */
vec3 morph_path_key(const struct picture *picture, uint32_t key);

/* Returns the position of the part's vertex in the solved shape of a key. The solved shape
 * exaggerates the drawn shape so that the path passes through the drawn shape (2005 thesis, section
 * 4.2). */
vec3 morph_path_solved(const struct picture *picture, uint32_t key);

/* morph_path_outline() returns an outline that has the view, the position and the scale of the
 * window. morph_path_place() converts a body point to pixels of the picture. */
struct morph_outline morph_path_outline(const struct window *window);

void morph_path_place(const struct window *window, vec3 p, double *x, double *y);

/* Returns the view in which the path is longest. The side view has preference. */
enum morph_outline_view morph_path_best_view(const struct picture *picture);

/* morph_path_whole() returns the window that shows the whole fish at all keys. morph_path_lens()
 * returns the window that shows the path and its drawn and solved keys enlarged. */
struct window morph_path_whole(const struct picture *picture, enum morph_outline_view view);
struct window morph_path_lens(const struct picture *picture, enum morph_outline_view view);

#endif
