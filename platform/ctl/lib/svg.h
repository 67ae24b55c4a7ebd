/* svg.h -- writes pictures as Scalable Vector Graphics (SVG), which drawing programs can edit.
 *
 * Coordinates are in pixels with y downward. A write error is reported by svg_close(). */
#pragma once

#include <stdbool.h>
#include <stdio.h>

#include "platform/os/file.h"

#define SVG_PAPER "#fbfaf8"
#define SVG_INK "#333333"
#define SVG_GREY "#8a8580"
#define SVG_FAINT "#e4dfd8"

struct svg {
    FILE *file; /* Output stream of the picture. The stream writes to the file `out`. */
    struct atomic_file out;
};

/* Creates a picture of `width` x `height` pixels and fills its background. Returns false and sets
 * errno if the file cannot be created. */
bool svg_open(struct svg *svg, const char *path, double width, double height, const char *title);

/* Writes SVG markup that is formatted as by printf(). Special characters are not escaped. */
__attribute__((format(printf, 2, 3))) void svg_put(struct svg *svg, const char *format, ...);

/* Writes one line of text with an outline in the background colour. `anchor` is "start", "middle"
 * or "end" and states which point of the text lies at (`x`, `y`). */
__attribute__((format(printf, 7, 8))) void svg_text(struct svg *svg, double x, double y,
                                                    double size, const char *anchor,
                                                    const char *colour, const char *format, ...);

/* Draws a straight line. `dashes` is an SVG dash pattern, or null for a solid line. */
void svg_line(struct svg *svg, double x0, double y0, double x1, double y1, const char *colour,
              double width, const char *dashes);

/* Draws a filled circle with an edge line. */
void svg_dot(struct svg *svg, double x, double y, double radius, const char *fill,
             const char *edge);

/* Starts a polyline. svg_point() adds each point, and svg_end_line() draws the line. */
void svg_begin_line(struct svg *svg);
void svg_point(struct svg *svg, double x, double y);
void svg_end_line(struct svg *svg, const char *colour, double width, const char *dashes);

/* Completes the picture and closes the file. Returns true if all data was written. Otherwise sets
 * errno, leaves the target file unchanged and returns false. */
bool svg_close(struct svg *svg);
