/* morph_graph.h -- the layout of a deformation graph's picture, and its axes. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_GRAPH_H
#define KINGYO_PLATFORM_CTL_MORPH_GRAPH_H

#include "core/morph/morph.h"
#include "platform/ctl/svg.h"

#define GRAPH_WIDTH 1280.0
#define GRAPH_HEIGHT 760.0
#define GRAPH_LEFT 110.0
#define GRAPH_RIGHT 1150.0
#define GRAPH_TOP 270.0
#define GRAPH_BOTTOM 600.0

/* graph_x() converts progress and graph_y() a share, each in [0, 1], to pixels of the picture. */
double graph_x(double progress);
double graph_y(double share);

#define GRAPH_WORDS 24u

/* Writes an age as "545 d", or as "4.01 y" from two years on. */
void graph_print_age(char out[GRAPH_WORDS], double days);

/* Writes a length in mm with `digits` digits. Keys have measured lengths such as 125.5 mm. Three
 * digits are enough between keys. */
void graph_print_length(char out[GRAPH_WORDS], double mm, int digits);

/* Range of the length axis on the right. */
struct graph_lengths {
    double low_mm, high_mm;
    /* True if the axis is logarithmic. Otherwise the axis is linear and starts at 0. */
    bool is_log;
};

/* Returns the range of the length axis. The axis is logarithmic if the lengths of a life span more
 * than a factor of ten, unless `is_even` requests the linear axis of the thesis. */
struct graph_lengths graph_lengths(const struct species_card *card, bool is_even);

/* Converts a length in mm to the height in the picture, pixels. */
double graph_length_y(const struct graph_lengths *lengths, double mm);

/* Draws the axes: shares on the left, progress below, ages with lengths under the progress, and
 * lengths on the right. */
void graph_axes(struct svg *svg, const struct species_card *card,
                const struct graph_lengths *lengths);

#endif
