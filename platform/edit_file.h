/* edit_file.h -- a species' graph as saved in the growth lab: DATA/graphs/SPECIES.graph, a text.
 *
 *   kingyo-graph 1
 *   species hirame
 *   keys 5
 *   template own          (or ordinary, pairwise, simultaneous, smooth)
 *   line smooth           (or straight)
 *   solved 1              (or 0)
 *   knot 0 1 0 0 0 0      progress, then each key's weight; 2 to 12 of them
 *   scale 0 0.0095        progress and metres; none, or 2 to 12 of them
 *   end
 *
 * Lines in this order; '#' begins a comment. Numbers are written so that they come back to the last
 * bit. A file is written beside its place and then moved there: a power cut leaves the old one or
 * the new one. What does not fit its species is refused with one line that says where. */
#ifndef KINGYO_PLATFORM_EDIT_FILE_H
#define KINGYO_PLATFORM_EDIT_FILE_H

#include <stddef.h>
#include <stdio.h>

#include "core/game/lab_book.h"
#include "core/output.h"

#define EDIT_FILE_VERSION 1u
#define EDIT_FOLDER "graphs"
#define EDIT_SUFFIX ".graph"
#define EDIT_WHY_SIZE 160u
#define EDIT_TEXT_MAX 4096u /* A graph with every knot has 2.2 KB. */

/* edit_text.c */

/* Writes what is to be kept into `out`; returns its length, < EDIT_TEXT_MAX. */
size_t edit_file_format(const struct edit_record *record, char out[EDIT_TEXT_MAX]);

/* Reads `size` bytes of any content as a graph of `card`. 1, or 0 and `why` says "LINE: what". */
int edit_file_parse(const char *text, size_t size, const struct species_card *card,
                    struct lab_edit *edit, char why[EDIT_WHY_SIZE]);

/* edit_file.c */

/* Keeps it in `data`/graphs, or takes away what was kept when it is the species' own again. On the
 * disk when the call comes back. 0 or a negative errno. */
int edit_file_keep(const char *data, const struct edit_record *record);

/* Reads the graphs of all the book's species into it. A file that cannot be used is told through
 * `warn` as "PATH:LINE: what", and the species keeps its own. */
struct edit_warn {
    void (*tell)(void *context, const char *line); /* Null: nobody listens. */
    void *context;
};
void edit_file_fill(const char *data, struct lab_book *book, struct edit_warn warn);

#endif
