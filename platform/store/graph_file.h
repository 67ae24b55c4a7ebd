/* graph_file.h -- saves a species' graph that was edited in the growth lab as a text file,
 * DATA/graphs/SPECIES.graph.
 *
 *   kingyo-graph 1
 *   species hirame
 *   keys 5
 *   template own          (or ordinary, pairwise, simultaneous, smooth)
 *   line smooth           (or straight)
 *   solved 1              (or 0)
 *   knot 0 1 0 0 0 0      progress, then the weight of each key shape; 2 to 12 lines
 *   scale 0 0.0095        progress and length in metres; no line, or 2 to 12 lines
 *   end
 *
 * A key shape is one modelled growth stage of the species. The lines must have this order. A '#'
 * starts a comment. Numbers are written with enough digits to be read back exactly. A file is
 * written under a temporary name and then renamed, so that a power cut leaves either the old file
 * or the new file. A file that does not fit its species is rejected with one message that names the
 * line. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "core/game/lab/lab_edit.h"
#include "core/output.h"

#define GRAPH_FILE_VERSION 1u
#define GRAPH_FILE_FOLDER "graphs"
#define GRAPH_FILE_SUFFIX ".graph"
#define GRAPH_FILE_WHY_SIZE 160u
/* Maximum size of a file in bytes. The longest graph takes 2.2 KB. */
#define GRAPH_FILE_TEXT_MAX 4096u

/* ---- Functions of graph_text.c ------------------------------------------------------------- */

/* Writes `record` as text to `out`. Returns the length, which is less than GRAPH_FILE_TEXT_MAX. */
size_t graph_file_format(const struct graph_edit_record *record, char out[GRAPH_FILE_TEXT_MAX]);

/* Parses `size` bytes, which may have any content, as a graph of the species `card`. Returns true.
 * If the text is invalid, returns false and writes "LINE: reason" to `why`. */
bool graph_file_parse(const char *text, size_t size, const struct species_card *card,
                      struct lab_edit *edit, char why[GRAPH_FILE_WHY_SIZE]);

/* ---- Functions of graph_file.c ------------------------------------------------------------- */

/* Saves the edit in the folder `data`/graphs. If the edit restores the species' own graph,
 * deletes the saved file. The change is on disk when the function returns. Returns 0 or a
 * negative errno. */
int graph_file_write(const char *data, const struct graph_edit_record *record);

/* Callback for rejected files. `line` is "PATH:LINE: reason". */
struct graph_file_warn {
    /* Null means that rejected files are not reported. */
    void (*report)(void *context, const char *line);
    void *context;
};

/* Loads the saved graphs of all species into `book`. A file that cannot be used is reported through
 * `warn`, and the graph of its species stays unchanged. */
void graph_file_load(const char *data, struct lab_book *book, struct graph_file_warn warn);
