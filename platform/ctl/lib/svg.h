/* svg.h -- writes pictures as Scalable Vector Graphics, which other programs can edit.
 *
 * Coordinates are pixels with y downward. An error of the file is remembered until svg_close(). */
#ifndef KINGYO_PLATFORM_CTL_LIB_SVG_H
#define KINGYO_PLATFORM_CTL_LIB_SVG_H

#include <stdbool.h>
#include <stdio.h>

#include "platform/os/atomic_file.h"

#define SVG_PAPER "#fbfaf8"
#define SVG_INK "#333333"
#define SVG_GREY "#8a8580"
#define SVG_FAINT "#e4dfd8"

struct svg {
    FILE *file; /* File of `out`. */
    struct atomic_file out;
};

/* Creates a picture with a background of the given size in pixels. Returns false and sets errno if
 * the file cannot be created. */
bool svg_open(struct svg *svg, const char *path, double width, double height, const char *title);

/* Writes markup without escaping. */
__attribute__((format(printf, 2, 3))) void svg_put(struct svg *svg, const char *format, ...);

/* Writes one line of text with a background margin. `anchor` is start, middle or end. */
__attribute__((format(printf, 7, 8))) void svg_text(struct svg *svg, double x, double y,
                                                    double size, const char *anchor,
                                                    const char *colour, const char *format, ...);

/* Draws a straight line. */
void svg_line(struct svg *svg, double x0, double y0, double x1, double y1, const char *colour,
              double width, const char *dashes);

/* Draws a filled circle. */
void svg_dot(struct svg *svg, double x, double y, double radius, const char *fill,
             const char *edge);

/* Draws a polyline. Call svg_begin_line(), svg_point() for each point, and then svg_end_line(). */
void svg_begin_line(struct svg *svg);
void svg_point(struct svg *svg, double x, double y);
void svg_end_line(struct svg *svg, const char *colour, double width, const char *dashes);

/* Ends the picture. Returns true if all data was written. Otherwise sets errno, leaves the target
 * file unchanged and returns false. */
bool svg_close(struct svg *svg);

#endif
