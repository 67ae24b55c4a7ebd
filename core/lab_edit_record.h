/* lab_edit_record.h -- the edited growth curves of one species, as plain data. The growth lab
 * outputs an edit record, the store saves it, and the next start loads it. */
#ifndef KINGYO_CORE_LAB_EDIT_RECORD_H
#define KINGYO_CORE_LAB_EDIT_RECORD_H

#include <stdint.h>

#include "core/morph/species.h"

/* Edited curves of one species. 540 bytes; the core keeps one per species. */
struct lab_edit {
    uint8_t template_id;      /* enum graph_template that the graph started from. Under
                                 TEMPLATE_OWN each body part keeps its own curve; under any other
                                 template every part follows `graph`. */
    uint8_t scale_knot_count; /* Number of entries in `scale_knots`, as in struct species_card; 0:
                                 the growth curve gives the scale. */
    struct graph graph;       /* Graph of the whole fish. */
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
};

struct graph_edit_record {
    uint32_t id;       /* Id of the record, one higher with each record; 0: nothing to save. */
    uint8_t is_own;    /* 1: the species returns to its original curves, and the store deletes the
                          saved edit. */
    uint8_t key_count; /* Number of key shapes of the species. */
    char species[SPECIES_NAME_SIZE];
    struct lab_edit edit;
};

#endif
