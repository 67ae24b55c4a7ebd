/* morph_graph.h -- the layout of a deformation graph's picture, and its axes. */
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

/* morph_graph_x() converts progress and morph_graph_y() a share, each in [0, 1], to pixels of the
 * picture. */
double morph_graph_x(double progress);
double morph_graph_y(double share);

#define MORPH_GRAPH_WORDS 24u

/* Writes an age as "545 d", or as "4.01 y" from two years on. */
void morph_graph_print_age(char out[MORPH_GRAPH_WORDS], double days);

/* Writes a length in mm with `digits` digits. Keys have measured lengths such as 125.5 mm. Three
 * digits are enough between keys. */
void morph_graph_print_length(char out[MORPH_GRAPH_WORDS], double mm, int digits);

/* Range of the length axis on the right. */
struct morph_graph_lengths {
    double low_mm, high_mm;
    /* True if the axis is logarithmic. Otherwise the axis is linear and starts at 0. */
    bool is_log;
};

/* Returns the range of the length axis. The axis is logarithmic if the lengths of a life span more
 * than a factor of ten, unless `is_even` requests the linear axis of the thesis. */
struct morph_graph_lengths morph_graph_lengths(const struct species_card *card, bool is_even);

/* Converts a length in mm to the height in the picture, pixels. */
double morph_graph_length_y(const struct morph_graph_lengths *lengths, double mm);

/* Draws the axes: shares on the left, progress below, ages with lengths under the progress, and
 * lengths on the right. */
void morph_graph_axes(struct svg *svg, const struct species_card *card,
                      const struct morph_graph_lengths *lengths);

#endif
