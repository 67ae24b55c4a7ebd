/* svg.c -- writes lines, dots and texts as SVG markup. */
#include "platform/ctl/lib/svg.h"

#include <errno.h>
#include <stdarg.h>

#include "core/base/panic.h"
#include "core/base/printable.h"

#define TEXT_MAX 256

bool svg_open(struct svg *svg, const char *path, double width, double height, const char *title)
{
    CORE_ASSERT(path && width > 0.0 && height > 0.0);
    const int error = file_atomic_open(&svg->out, path);
    if (error != 0) {
        errno = -error;
        return false;
    }
    svg->file = svg->out.file;
    fprintf(svg->file,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" "
            "viewBox=\"0 0 %g %g\" font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n<title>",
            width, height, width, height);
    fputs(title, svg->file); /* The title is a constant text of Kingyo and contains no special
                                characters. */
    fprintf(svg->file, "</title>\n<rect width=\"%g\" height=\"%g\" fill=\"%s\"/>\n", width, height,
            SVG_PAPER);
    return true;
}

void svg_put(struct svg *svg, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vfprintf(svg->file, format, arguments);
    va_end(arguments);
}

void svg_text(struct svg *svg, double x, double y, double size, const char *anchor,
              const char *colour, const char *format, ...)
{
    char text[TEXT_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    fprintf(svg->file,
            "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%g\" text-anchor=\"%s\" fill=\"%s\" "
            "stroke=\"%s\" stroke-width=\"3\" stroke-opacity=\"0.8\" paint-order=\"stroke\">",
            x, y, size, anchor, colour, SVG_PAPER);
    printable(text);
    for (const char *c = text; *c; c++) { /* Characters that are special in XML become entities. */
        const char *word = *c == '<' ? "&lt;" : *c == '&' ? "&amp;" : NULL;
        if (word) {
            fputs(word, svg->file);
        } else {
            fputc(*c, svg->file);
        }
    }
    fputs("</text>\n", svg->file);
}

void svg_line(struct svg *svg, double x0, double y0, double x1, double y1, const char *colour,
              double width, const char *dashes)
{
    svg_begin_line(svg);
    svg_point(svg, x0, y0);
    svg_point(svg, x1, y1);
    svg_end_line(svg, colour, width, dashes);
}

void svg_dot(struct svg *svg, double x, double y, double radius, const char *fill, const char *edge)
{
    fprintf(svg->file,
            "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%g\" fill=\"%s\" stroke=\"%s\" "
            "stroke-width=\"1.6\"/>\n",
            x, y, radius, fill, edge);
}

void svg_begin_line(struct svg *svg)
{
    fputs("<polyline points=\"", svg->file);
}

void svg_point(struct svg *svg, double x, double y)
{
    fprintf(svg->file, "%.2f,%.2f ", x, y);
}

void svg_end_line(struct svg *svg, const char *colour, double width, const char *dashes)
{
    fprintf(svg->file,
            "\" fill=\"none\" stroke=\"%s\" stroke-width=\"%g\" stroke-linejoin=\"round\" "
            "stroke-linecap=\"round\" stroke-dasharray=\"%s\"/>\n",
            colour, width, dashes ? dashes : "none");
}

bool svg_close(struct svg *svg)
{
    fputs("</svg>\n", svg->file);
    const int error = file_atomic_close(&svg->out);
    errno = -error;
    return error == 0;
}
