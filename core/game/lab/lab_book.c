/* lab_book.c -- gives access to the species by index, and computes the hash of all species data. */
#include "core/game/lab/lab_book.h"

#include "core/base/hash.h"
#include "core/base/panic.h"

uint32_t lab_book_count(const struct lab_book *book)
{
    return species_table_count + book->card_count;
}

const struct species_card *lab_book_card(const struct lab_book *book, uint32_t species)
{
    CORE_ASSERT(species < lab_book_count(book));
    return species < species_table_count ? &species_table[species]->card
                                         : &book->cards[species - species_table_count];
}

/* ---- Hash ----------------------------------------------------------------------------------- */

static uint64_t graph_hash(uint64_t hash, const struct graph *graph)
{
    hash = hash_u32(hash, graph->knot_count);
    hash = hash_u32(hash, graph->line);
    hash = hash_u32(hash, graph->solved);
    for (uint32_t i = 0; i < GRAPH_KNOT_MAX; i++) {
        hash = hash_float(hash, graph->knots[i].progress);
        hash = hash_floats(hash, graph->knots[i].weight, MORPH_KEY_MAX);
    }
    return hash;
}

static uint64_t scale_hash(uint64_t hash, const struct scale_knot knots[GRAPH_KNOT_MAX])
{
    for (uint32_t i = 0; i < GRAPH_KNOT_MAX; i++) {
        hash = hash_float(hash, knots[i].progress);
        hash = hash_float(hash, knots[i].length_m);
    }
    return hash;
}

uint64_t lab_edit_hash(uint64_t hash, const struct lab_edit *edit)
{
    hash = hash_u32(hash, edit->template_id);
    hash = hash_u32(hash, edit->scale_knot_count);
    hash = graph_hash(hash, &edit->graph);
    return scale_hash(hash, edit->scale_knots);
}

static uint64_t growth_hash(uint64_t hash, const struct growth *growth)
{
    hash = hash_float(hash, growth->length_inf_m);
    hash = hash_float(hash, growth->k_per_year);
    hash = hash_float(hash, growth->t0_year);
    hash = hash_float(hash, growth->fade_year);
    hash = hash_u32(hash, growth->point_count);
    for (uint32_t i = 0; i < GROWTH_POINT_MAX; i++) {
        hash = hash_float(hash, growth->points[i].age_days);
        hash = hash_float(hash, growth->points[i].length_m);
    }
    return hash;
}

static uint64_t card_hash(uint64_t hash, const struct species_card *card)
{
    hash = hash_bytes(hash, card->id, sizeof card->id);
    const uint32_t words[] = { card->key_count,     card->measure,         card->motion,
                               card->form,          card->thesis_key[0],   card->thesis_key[1],
                               card->thesis_key[2], card->thesis_template, card->scale_knot_count,
                               card->curve_count };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    hash = hash_bytes(hash, card->key_names, sizeof card->key_names);
    hash = hash_floats(hash, card->key_age_days, MORPH_KEY_MAX);
    hash = hash_floats(hash, card->key_length_m, MORPH_KEY_MAX);
    hash = growth_hash(hash, &card->growth);
    hash = scale_hash(hash, card->scale_knots);
    hash = hash_bytes(hash, card->curve_names, sizeof card->curve_names);
    for (uint32_t i = 0; i < MORPH_CURVE_MAX; i++) {
        hash = graph_hash(hash, &card->curves[i]);
    }
    return hash;
}

uint64_t lab_book_hash(uint64_t hash, const struct lab_book *book)
{
    hash = hash_u32(hash, book->card_count);
    hash = hash_u32(hash, book->refused);
    hash = hash_bytes(hash, book->has_edit, sizeof book->has_edit);
    for (uint32_t i = 0; i < SPECIES_EXTRA_MAX; i++) {
        hash = card_hash(hash, &book->cards[i]);
    }
    for (uint32_t i = 0; i < SPECIES_MAX; i++) {
        hash = lab_edit_hash(hash, &book->edits[i]);
    }
    return hash;
}
