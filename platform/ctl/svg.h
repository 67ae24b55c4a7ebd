/* svg.h -- pictures that people look at and other programs can read on: Scalable Vector Graphics.
 *
 * Coordinates are pixels, y downward. Errors of the file are remembered until svg_close(). */
#ifndef KINGYO_PLATFORM_CTL_SVG_H
#define KINGYO_PLATFORM_CTL_SVG_H

#include <stdbool.h>
#include <stdio.h>

#include "platform/out_file.h"

#define SVG_PAPER "#fbfaf8"
#define SVG_INK "#333333"
#define SVG_GREY "#8a8580"
#define SVG_FAINT "#e4dfd8"

struct svg {
    FILE *file; /* Of `out`. */
    struct out_file out;
};

/* Begins the picture on a paper of that size; false with errno set where there is no such file. */
bool svg_open(struct svg *svg, const char *path, double width, double height, const char *title);

/* Markup as it is. */
__attribute__((format(printf, 2, 3)))
void svg_put(struct svg *svg, const char *format, ...);

/* One line of words, with a little paper around them. `anchor` is start, middle or end. */
__attribute__((format(printf, 7, 8)))
void svg_text(struct svg *svg, double x, double y, double size, const char *anchor,
              const char *colour, const char *format, ...);

void svg_line(struct svg *svg, double x0, double y0, double x1, double y1, const char *colour,
              double width, const char *dashes);

void svg_dot(struct svg *svg, double x, double y, double radius, const char *fill,
             const char *edge);

/* Points of a line, each drawn to from the one before: begin, point ..., end. */
void svg_begin_line(struct svg *svg);
void svg_point(struct svg *svg, double x, double y);
void svg_end_line(struct svg *svg, const char *colour, double width, const char *dashes);

/* Ends the picture. Whether all of it was written; else errno is set and nothing is changed. */
bool svg_close(struct svg *svg);

#endif
