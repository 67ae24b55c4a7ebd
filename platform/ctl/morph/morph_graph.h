/* morph_graph.h -- the layout and the axes of the picture of a deformation graph.
 *
 * The graph shows how the weights of the key shapes change during a fish's life. Progress is the
 * share of the life, from 0 to 1. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_GRAPH_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_GRAPH_H

#include "core/morph/morph.h"
#include "platform/ctl/lib/svg.h"

#define MORPH_GRAPH_WIDTH 1280.0
#define MORPH_GRAPH_HEIGHT 760.0
#define MORPH_GRAPH_LEFT 110.0
#define MORPH_GRAPH_RIGHT 1150.0
#define MORPH_GRAPH_TOP 270.0
#define MORPH_GRAPH_BOTTOM 600.0

/* morph_graph_x() converts a progress in [0, 1] to pixels from the left. morph_graph_y() converts a
 * weight in [0, 1] to pixels from the top. */
double morph_graph_x(double progress);
double morph_graph_y(double share);

#define MORPH_GRAPH_WORDS 24u

/* Writes an age to `out` in days, for example "545 d". An age of two years or more is written in
 * years, for example "4.01 y". */
void morph_graph_print_age(char out[MORPH_GRAPH_WORDS], double days);

/* Writes a length in mm with `digits` significant digits. Lengths at keys are measured with four
 * digits, for example 125.5 mm. Lengths between keys need only three digits. */
void morph_graph_print_length(char out[MORPH_GRAPH_WORDS], double mm, int digits);

/* Range of the length axis at the right of the picture. */
struct morph_graph_lengths {
    double low_mm, high_mm;
    /* True for a logarithmic axis. False for a linear axis that starts at 0. */
    bool is_log;
};

/* Returns the range of the length axis. The axis is logarithmic if the greatest length of the life
 * is more than ten times the least length. `is_even` forces a linear axis as in the 2005 thesis. */
struct morph_graph_lengths morph_graph_lengths(const struct species_card *card, bool is_even);

/* Converts a length in mm to pixels from the top of the picture. */
double morph_graph_length_y(const struct morph_graph_lengths *lengths, double mm);

/* Draws the axes of the graph. The left axis shows weights and the right axis shows lengths. Below
 * the graph are the progress and the ages with their lengths. */
void morph_graph_axes(struct svg *svg, const struct species_card *card,
                      const struct morph_graph_lengths *lengths);

#endif
