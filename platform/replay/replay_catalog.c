/* replay_catalog.c -- serializes the species and graphs of the growth lab. One function per
 * structure both reads and writes. */
#include "platform/replay/replay_catalog.h"

#include <string.h>

#include "platform/replay/replay_serializer.h"

static void walk_graph(struct replay_serializer *walk, struct graph *graph)
{
    replay_serialize_bytes(walk, &graph->knot_count, 1);
    replay_serialize_bytes(walk, &graph->line, 1);
    replay_serialize_bytes(walk, &graph->solved, 1);
    for (uint32_t i = 0; i < GRAPH_KNOT_MAX; i++) {
        replay_serialize_floats(walk, &graph->knots[i].progress, 1);
        replay_serialize_floats(walk, graph->knots[i].weight, MORPH_KEY_MAX);
    }
}

static void walk_scale(struct replay_serializer *walk, struct scale_knot knots[GRAPH_KNOT_MAX])
{
    for (uint32_t i = 0; i < GRAPH_KNOT_MAX; i++) {
        replay_serialize_floats(walk, &knots[i].progress, 1);
        replay_serialize_floats(walk, &knots[i].length_m, 1);
    }
}

static void walk_growth(struct replay_serializer *walk, struct growth *growth)
{
    replay_serialize_floats(walk, &growth->length_inf_m, 1);
    replay_serialize_floats(walk, &growth->k_per_year, 1);
    replay_serialize_floats(walk, &growth->t0_year, 1);
    replay_serialize_floats(walk, &growth->fade_year, 1);
    replay_serialize_u32(walk, &growth->point_count);
    for (uint32_t i = 0; i < GROWTH_POINT_MAX; i++) {
        replay_serialize_floats(walk, &growth->points[i].age_days, 1);
        replay_serialize_floats(walk, &growth->points[i].length_m, 1);
    }
}

static void walk_card(struct replay_serializer *walk, struct species_card *card)
{
    replay_serialize_bytes(walk, card->id, sizeof card->id);
    replay_serialize_bytes(walk, &card->key_count, 1);
    replay_serialize_bytes(walk, &card->measure, 1);
    replay_serialize_bytes(walk, &card->motion, 1);
    replay_serialize_bytes(walk, &card->form, 1);
    replay_serialize_bytes(walk, card->thesis_key, sizeof card->thesis_key);
    replay_serialize_bytes(walk, &card->thesis_template, 1);
    replay_serialize_bytes(walk, card->key_names, sizeof card->key_names);
    replay_serialize_floats(walk, card->key_age_days, MORPH_KEY_MAX);
    replay_serialize_floats(walk, card->key_length_m, MORPH_KEY_MAX);
    walk_growth(walk, &card->growth);
    replay_serialize_bytes(walk, &card->scale_knot_count, 1);
    walk_scale(walk, card->scale_knots);
    replay_serialize_bytes(walk, &card->curve_count, 1);
    replay_serialize_bytes(walk, card->curve_names, sizeof card->curve_names);
    for (uint32_t i = 0; i < MORPH_CURVE_MAX; i++) {
        walk_graph(walk, &card->curves[i]);
    }
}

static void walk_edit(struct replay_serializer *walk, struct lab_edit *edit)
{
    replay_serialize_bytes(walk, &edit->template_id, 1);
    replay_serialize_bytes(walk, &edit->scale_knot_count, 1);
    walk_graph(walk, &edit->graph);
    walk_scale(walk, edit->scale_knots);
}

static void walk_book(struct replay_serializer *walk, struct lab_book *book)
{
    replay_serialize_bytes(walk, &book->card_count, 1);
    replay_serialize_bytes(walk, &book->refused, 1);
    replay_serialize_bytes(walk, book->has_edit, sizeof book->has_edit);
    for (uint32_t i = 0; i < book->card_count && i < SPECIES_EXTRA_MAX; i++) {
        walk_card(walk, &book->cards[i]);
    }
    for (uint32_t i = 0; i < SPECIES_MAX; i++) {
        if (book->has_edit[i]) {
            walk_edit(walk, &book->edits[i]);
        }
    }
}

size_t replay_catalog_encode(const struct lab_book *book, uint8_t out[REPLAY_CATALOG_MAX])
{
    struct lab_book copy = *book; /* The copy is needed because the serializer takes a non-const
                                     pointer. */
    struct replay_serializer walk = { .out = out, .size = REPLAY_CATALOG_MAX };
    uint32_t edits = 0;
    for (uint32_t i = 0; i < SPECIES_MAX; i++) {
        edits += book->has_edit[i] != 0;
    }
    if (book->card_count == 0 && book->refused == 0 && edits == 0) {
        return 0;
    }
    walk_book(&walk, &copy);
    return walk.bad ? 0 : walk.at;
}

int replay_catalog_decode(struct lab_book *book, const uint8_t *bytes, size_t size)
{
    struct replay_serializer walk = { .in = bytes, .size = size };
    *book = (struct lab_book){ 0 };
    walk_book(&walk, book);
    if (walk.bad || walk.at != size || !lab_book_is_valid(book)) {
        *book = (struct lab_book){ 0 };
        return 0;
    }
    return 1;
}
