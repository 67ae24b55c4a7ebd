/* library.h -- the species library: makers' species found in the kiosk's data folder, and the
 * reason for each rejected file.
 *
 * DATA/species/NAME.kfish are read once, at the start, in the order of their names. An invalid file
 * produces a line for the operator and never prevents the start. Screens show rejected species
 * files and rejected graphs (graph_file.h); only valid species are available to the game. */
#ifndef KINGYO_PLATFORM_SPECIES_LIBRARY_H
#define KINGYO_PLATFORM_SPECIES_LIBRARY_H

#include "platform/species/pack.h"

#define LIBRARY_FOLDER "species"
/* The number of lines that a screen shows; further files are only counted. */
#define LIBRARY_LINE_MAX 32u
#define LIBRARY_FILE_SIZE 64u /* Buffer size of a file's name; a longer name is truncated. */
#define LIBRARY_SLOT_NONE 255u

struct library_line {
    char file[LIBRARY_FILE_SIZE]; /* File name without the folder. */
    uint8_t slot;                 /* Slot of the species, or LIBRARY_SLOT_NONE. */
    char why[VALIDATE_WHY_SIZE];  /* Reason of the rejection; otherwise "". */
};

/* Species library, about 2.1 MB, for static storage. */
struct library {
    uint32_t species_count; /* Filled slots, from the first. */
    uint32_t line_count;
    uint32_t unread_count; /* Files beyond LIBRARY_LINE_MAX, the last by name. */
    struct library_line lines[LIBRARY_LINE_MAX];
    uint32_t graph_count; /* Number of rejected saved graphs. */
    struct library_line graphs[SPECIES_MAX];
    struct species_slot slots[SPECIES_EXTRA_MAX];
};

/* Reads the files of `data`/species. A missing folder gives an empty library. `data` may be null or
 * "". */
void library_fill(struct library *library, const char *data);

/* Records a rejected saved graph: "FILE: why", the file without the data folder. */
void library_note_graph(struct library *library, const char *line);

/* Return the faults for the operator: rejected species in the library's order, then the number of
 * unread files, then rejected graphs. `index` must be below library_fault_count(). */
uint32_t library_fault_count(const struct library *library);
struct library_line library_fault(const struct library *library, uint32_t index);

/* Return the built-in species followed by the library's species. `index` must be below
 * library_count(). */
uint32_t library_count(const struct library *library);
const struct species *library_species(const struct library *library, uint32_t index);

#endif
