/* morph_graph.h -- the paper of a deformation graph: where things are, and its axes. */
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

/* From progress and shares, [0, 1] each, to the paper. */
double graph_x(double progress);
double graph_y(double share);

#define GRAPH_WORDS 24u

/* "545 d", from two years on "4.01 y". */
void graph_print_age(char out[GRAPH_WORDS], double days);

/* Keys are drawn at measured lengths: 125.5 mm; between them three digits are enough. */
void graph_print_length(char out[GRAPH_WORDS], double mm, int digits);

/* What the axis on the right reads from its foot to its top. */
struct graph_lengths {
    double low_mm, high_mm;
    bool is_log; /* By factors, else by differences from 0. */
};

/* By factors where a life spans more than ten, unless `is_even` asks for the paper's own look. */
struct graph_lengths graph_lengths(const struct species_card *card, bool is_even);
double graph_length_y(const struct graph_lengths *lengths, double mm);

/* Shares on the left; progress below, and under it ages with lengths; lengths on the right. */
void graph_axes(struct svg *svg, const struct species_card *card,
                const struct graph_lengths *lengths);

#endif
