/* file_graph.c -- fuzz target: arbitrary text as a saved morph graph (DATA/graphs/SPECIES.graph).
 * The parser must either accept the text, or reject it with a message of one line that begins with
 * a line number. An accepted graph must give finite blend weights, and must not change by a bit
 * when it is written and read again.
 *
 * Input: a byte that selects the species, and the text. */
#include <string.h>

#include "platform/store/graph_file.h"
#include "tests/fuzz/trap.h"

#define STEPS 8u

static void hold_why(const char why[GRAPH_FILE_WHY_SIZE])
{
    const size_t length = strnlen(why, GRAPH_FILE_WHY_SIZE);
    HOLD(length > 0 && length < GRAPH_FILE_WHY_SIZE && why[0] >= '1' && why[0] <= '9');
    HOLD(!memchr(why, '\n', length) && !memchr(why, '\x1b', length));
}

static void hold_weights(const struct lab_edit *edit, const struct species_card *card)
{
    static struct species_card edited;
    lab_edit_apply(edit, card, &edited);
    for (uint32_t i = 0; i <= STEPS; i++) {
        float weights[MORPH_KEY_MAX];
        graph_weights(&edit->graph, card->key_count, (float)i / (float)STEPS, weights);
        for (uint32_t key = 0; key < card->key_count; key++) {
            HOLD(f_is_finite(weights[key]));
        }
        HOLD(f_is_finite(life_length_m(&edited, (float)i / (float)STEPS)));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct lab_edit again;
    char why[GRAPH_FILE_WHY_SIZE] = "", written[GRAPH_FILE_TEXT_MAX];
    if (size == 0) {
        return 0;
    }
    const struct species_card *card = &species_table[bytes[0] % species_table_count]->card;
    struct graph_edit_record record = { .id = 1, .key_count = card->key_count };
    if (!graph_file_parse((const char *)bytes + 1, size - 1u, card, &record.edit, why)) {
        hold_why(why);
        return 0;
    }
    HOLD(lab_edit_is_valid(&record.edit, card));
    hold_weights(&record.edit, card);
    memcpy(record.species, card->id, sizeof record.species);
    const size_t length = graph_file_format(&record, written);
    HOLD(length < GRAPH_FILE_TEXT_MAX && graph_file_parse(written, length, card, &again, why));
    HOLD(memcmp(&again, &record.edit, sizeof again) == 0);
    return 0;
}
