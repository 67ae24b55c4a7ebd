/* shelf.h -- makers' species that the kiosk found in its data folder, and what it thought of each.
 *
 * DATA/species/NAME.kfish are read once, at the start, in the order of their names. A file that is
 * no sound species costs a line and never the start. Screens show what was refused, these files and
 * graphs that nobody could read (edit_file.h); only species are handed on. */
#ifndef KINGYO_PLATFORM_SPECIES_SHELF_H
#define KINGYO_PLATFORM_SPECIES_SHELF_H

#include "platform/species/pack.h"

#define SHELF_FOLDER "species"
#define SHELF_LINE_MAX 32u  /* A screen's worth; further files are only counted. */
#define SHELF_FILE_SIZE 64u /* Of a file's name; a longer one is shown cut. */
#define SHELF_SLOT_NONE 255u

struct shelf_line {
    char file[SHELF_FILE_SIZE]; /* Without the folder. */
    uint8_t slot;               /* Which of the slots it is in, or SHELF_SLOT_NONE ... */
    char why[VET_WHY_SIZE];     /* ... for this reason; else "". */
};

/* About 2.1 MB, for static storage. */
struct shelf {
    uint32_t species_count; /* Slots filled, from the first. */
    uint32_t line_count;
    uint32_t unread_count;  /* Files beyond SHELF_LINE_MAX, the last by name. */
    struct shelf_line lines[SHELF_LINE_MAX];
    uint32_t graph_count; /* Saved graphs that were refused: */
    struct shelf_line graphs[SPECIES_MAX];
    struct species_slot slots[SPECIES_EXTRA_MAX];
};

/* Reads what lies in `data`/species; no such folder is an empty shelf. `data` may be null or "". */
void shelf_fill(struct shelf *shelf, const char *data);

/* Notes a saved graph that was refused: "FILE: why", the file without the data folder. */
void shelf_note_graph(struct shelf *shelf, const char *line);

/* What the operator should mend: refused species in the order of the shelf, then how many files had
 * no room, then refused graphs. `index` below shelf_fault_count(). */
uint32_t shelf_fault_count(const struct shelf *shelf);
struct shelf_line shelf_fault(const struct shelf *shelf, uint32_t index);

/* The species of the built-in table and, behind them, of the shelf: `index` below shelf_count(). */
uint32_t shelf_count(const struct shelf *shelf);
const struct species *shelf_species(const struct shelf *shelf, uint32_t index);

#endif
