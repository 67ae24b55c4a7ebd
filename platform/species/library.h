/* library.h -- the species library: the makers' species in the kiosk's data folder, and the reason
 * for each rejected file. A maker is a user who draws a species.
 *
 * The files DATA/species/NAME.kfish are read once, at program start, in alphabetical order. An
 * invalid file causes an error line for the operator and never prevents the program start. The
 * operator's screens show rejected species files and rejected deformation graphs (graph_file.h).
 * The game uses only valid species. */
#pragma once

#include "platform/species/pack.h"

#define LIBRARY_FOLDER "species"
/* Maximum number of files that are read. The number is limited because the operator's screen shows
 * one line for each file. Further files are only counted. */
#define LIBRARY_LINE_MAX 32u
/* Size of the buffer for a path in bytes. A longer path is truncated. */
#define LIBRARY_FILE_SIZE 72u
/* Value of the field `slot` of struct library_line for a rejected file. */
#define LIBRARY_SLOT_NONE 255u

struct library_line {
    char file[LIBRARY_FILE_SIZE]; /* Path of the file, relative to the data folder. */
    /* Index of the library slot that holds the species. LIBRARY_SLOT_NONE means that the file was
     * rejected. */
    uint8_t slot;
    /* Reason why the file was rejected. "" means that the file was accepted. */
    char why[VALIDATE_WHY_SIZE];
};

/* Species library. An object of this type has about 2.1 MB and must be static. */
struct library {
    uint32_t species_count; /* Number of valid species. They are the first elements of `slots`. */
    uint32_t line_count;
    /* Number of files that were not read because the folder has more than LIBRARY_LINE_MAX
     * files. */
    uint32_t unread_count;
    struct library_line lines[LIBRARY_LINE_MAX];
    uint32_t graph_count; /* Number of saved deformation graphs that were rejected. */
    struct library_line graphs[SPECIES_MAX];
    struct species_slot slots[SPECIES_EXTRA_MAX];
};

/* Reads the files of `data`/species. The library is empty if the folder is missing, or if `data` is
 * null or "". */
void library_fill(struct library *library, const char *data);

/* Records that a saved deformation graph was rejected. `line` is "FILE: reason", with FILE relative
 * to the data folder. */
void library_note_graph(struct library *library, const char *line);

/* Returns the number of faults (rejected or unread files) that the operator's screens show. */
uint32_t library_fault_count(const struct library *library);
/* Returns fault number `index` for the operator's screens. The rejected species files come first,
 * then one entry with the number of unread files, then the rejected graphs. `index` must be below
 * library_fault_count(). */
struct library_line library_fault(const struct library *library, uint32_t index);

/* Returns the number of built-in species plus the number of species in the library. */
uint32_t library_count(const struct library *library);
/* Returns species number `index`. The built-in species come first, then the library's species.
 * `index` must be below library_count(). */
const struct species *library_species(const struct library *library, uint32_t index);
