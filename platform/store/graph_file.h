/* graph_file.h -- a species' graph as saved in the growth lab: DATA/graphs/SPECIES.graph, a text.
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
 * The lines must have this order; '#' begins a comment. Numbers are written with enough digits to
 * be read back exactly. A file is written under a temporary name and then renamed, so that a power
 * cut leaves the old file or the new one. A file that does not fit its species is rejected with one
 * message that names the line. */
#ifndef KINGYO_PLATFORM_STORE_GRAPH_FILE_H
#define KINGYO_PLATFORM_STORE_GRAPH_FILE_H

#include <stddef.h>
#include <stdio.h>

#include "core/game/lab/lab_book.h"
#include "core/output.h"

#define GRAPH_FILE_VERSION 1u
#define GRAPH_FILE_FOLDER "graphs"
#define GRAPH_FILE_SUFFIX ".graph"
#define GRAPH_FILE_WHY_SIZE 160u
#define GRAPH_FILE_TEXT_MAX 4096u /* The longest graph takes 2.2 KB. */

/* ---- Implemented in graph_text.c ---- */

/* Formats `record` into `out`. Returns the length, which is < GRAPH_FILE_TEXT_MAX. */
size_t graph_file_format(const struct graph_edit_record *record, char out[GRAPH_FILE_TEXT_MAX]);

/* Parses `size` bytes of any content as a graph of `card`. Returns 1, or 0 with "LINE: reason" in
 * `why`. */
int graph_file_parse(const char *text, size_t size, const struct species_card *card,
                     struct lab_edit *edit, char why[GRAPH_FILE_WHY_SIZE]);

/* ---- Implemented in graph_file.c ---- */

/* Saves the edit in `data`/graphs, or deletes the saved file if the edit restores the species' own
 * graph. The change is on disk when the call returns. Returns 0 or a negative errno. */
int graph_file_write(const char *data, const struct graph_edit_record *record);

/* Loads the saved graphs of all species into `book`. A file that cannot be used is reported through
 * `warn` as "PATH:LINE: reason", and the species keeps its own graph. */
struct graph_file_warn {
    void (*tell)(void *context, const char *line); /* Null: no report. */
    void *context;
};
void graph_file_load(const char *data, struct lab_book *book, struct graph_file_warn warn);

#endif
