/* edit.h -- what somebody made of a species' curves in the growth lab: plain data, as it is handed
 * out to be kept and read back at the next start. */
#ifndef KINGYO_CORE_EDIT_H
#define KINGYO_CORE_EDIT_H

#include <stdint.h>

#include "core/morph/species.h"

/* 540 bytes, of which a stall keeps one a species. */
struct lab_edit {
    uint8_t template;         /* enum graph_template that it began as; parts keep their own curves
                                 under TEMPLATE_OWN, and follow `graph` under any other. */
    uint8_t scale_knot_count; /* As species_card's: 0 is the growth curve. */
    struct graph graph;       /* The whole fish's. */
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
};

struct edit_record {
    uint32_t id;       /* 0: nothing to save. Rises by one with each. */
    uint8_t is_own;    /* Back to the species' own: what was kept of it goes. */
    uint8_t key_count; /* Of the species. */
    char species[SPECIES_NAME_SIZE];
    struct lab_edit edit;
};

#endif
