/* lab_edit_record.h -- the edited growth curves of one species, as plain data. The growth lab
 * outputs an edit record, the store saves it, and the next start loads it. */
#ifndef KINGYO_CORE_LAB_EDIT_RECORD_H
#define KINGYO_CORE_LAB_EDIT_RECORD_H

#include <stdint.h>

#include "core/morph/species.h"

/* Edited curves of one species. 540 bytes; the core keeps one per species. */
struct lab_edit {
    uint8_t template_id;      /* Template from which the graph was started (enum graph_template).
                                 Under TEMPLATE_OWN each body part keeps its own curve. Under any
                                 other template every body part follows `graph`. */
    uint8_t scale_knot_count; /* Number of entries in `scale_knots`, as in struct species_card. 0
                                 means that the growth curve determines the scale. */
    struct graph graph;       /* Deformation graph of the whole fish. */
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
};

struct graph_edit_record {
    uint32_t id;       /* Id of the record. Each record has an id one higher than the previous
                          record. 0 means that no record needs to be saved. */
    uint8_t is_own;    /* 1 if the species returns to its original curves and the store must delete
                          the saved edit; otherwise 0. */
    uint8_t key_count; /* Number of key shapes of the species. */
    char species[SPECIES_NAME_SIZE];
    struct lab_edit edit;
};

#endif
