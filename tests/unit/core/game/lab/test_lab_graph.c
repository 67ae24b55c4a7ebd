/* test_lab_graph.c -- tests how the growth lab edits and saves a morph graph. */
#include "tests/unit/support/lab_fixture.h"

static void test_a_dragged_knot_always_keeps_the_constraint(void **state)
{
    (void)state;
    const struct layout_box plot = lab_box(0, card()->key_count, LAB_PLOT);
    tap((enum lab_part)(LAB_KEY + 1));
    const struct layout_point from = knot_at(1, 1);
    hover(from);
    go_down();
    assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
    assert_int_equal(core.game.lab.held_knot, 1);
    for (uint32_t i = 0; i <= 60; i++) {
        const struct layout_point canvas = pointer_layout_size(0);
        const float x = from.x + 0.5f * (float)i, y = from.y + plot.height * 0.02f * (float)i;
        hold(0, v3((x / canvas.x - 0.5f) * core.world.tank.size_m.x, DOWN_M,
                   (y / canvas.y - 0.5f) * core.world.tank.size_m.z));
        tick();
        assert_true(lab_edit_is_valid(&core.game.lab.edit, card()));
        float sum = 0.0f;
        for (uint32_t key = 0; key < card()->key_count; key++) {
            assert_true(look()->lab.weight[key] >= 0.0f);
            sum += scene.lab.weight[key];
        }
        assert_float_equal(sum, 1.0f, 1e-6f);
    }
    come_up();
    assert_true(core.game.lab.edit.graph.knots[1].weight[1] < 0.95f);
    assert_int_equal(look()->lab.is_own, 0);
    assert_int_equal(scene.lab.is_kept, 0);
}

/* OK selects the next species while the poi holds a knot. The poi must release the knot, because
 * its motion would otherwise edit the graph of the next species. */
static void test_a_page_change_does_not_move_a_held_knot(void **state)
{
    (void)state;
    for (uint32_t layer = 0; layer < 2; layer++) {
        const struct layout_box plot = lab_box(0, card()->key_count, LAB_PLOT);
        const struct species_card *first = card();
        struct layout_point at = knot_at(card()->curves[0].knot_count - 1u, card()->key_count - 1u);
        if (layer == 1) {
            tap(LAB_SIZE);
            at.y =
                plot.y + (1.0f - lab_length_share(first, life_length_m(first, 1.0f))) * plot.height;
        }
        hover(at);
        go_down();
        assert_int_equal(core.game.lab.holds, layer == 1 ? HOLD_SIZE : HOLD_WEIGHT);
        for (uint32_t i = 1; i <= species_table_count; i++) {
            press(INPUT_OK);
            input.poi[0].target.position_m.z += 0.002f;
            ticks(3);
            assert_int_equal(core.game.lab.species, i % species_table_count);
            assert_int_equal(core.game.lab.holds, HOLD_BUTTON);
            assert_int_equal(look()->lab.is_own, 1);
        }
        come_up();
    }
}

static void test_a_template_replaces_the_graph(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < TEMPLATE_COUNT; i++) {
        struct graph expected = card()->curves[0];
        tap((enum lab_part)(LAB_OWN + i));
        if (i != TEMPLATE_OWN) {
            graph_from_template(&expected, (enum graph_template)i, card()->key_count,
                                SIMULTANEOUS_PEAK);
        }
        assert_memory_equal(&core.game.lab.edit.graph, &expected, sizeof expected);
        assert_int_equal(look()->lab.template_id, i);
    }
}

static void test_knots_are_added_and_removed_at_the_present_progress(void **state)
{
    (void)state;
    const uint32_t before = card()->curves[0].knot_count;
    core.game.lab.progress = 0.4f;
    core.game.lab.playing = 0;
    tap(LAB_ADD);
    assert_int_equal(core.game.lab.edit.graph.knot_count, before + 1u);
    tap(LAB_REMOVE);
    assert_int_equal(core.game.lab.edit.graph.knot_count, before);
    assert_int_equal(look()->lab.is_own, 1);
}

static void test_a_required_knot_is_not_removed(void **state)
{
    (void)state;
    tap(LAB_SIMULTANEOUS);
    assert_int_equal(core.game.lab.edit.graph.solved, 1);
    for (uint32_t i = 0; i < 2u * GRAPH_KNOT_MAX; i++) {
        core.game.lab.progress = (float)(i % 5u) * 0.25f;
        core.game.lab.playing = 0;
        tap(LAB_REMOVE);
        assert_true(lab_edit_is_valid(&core.game.lab.edit, card()));
    }
    assert_in_range(core.game.lab.edit.graph.knot_count, 3, card()->key_count);
}

/* Several keys may have knots at the same point of the page. A press on this point must take the
 * knot of the selected key's curve. */
static void test_the_selected_curve_has_priority_among_knots_in_one_place(void **state)
{
    (void)state;
    tap(LAB_PAIRWISE);
    for (uint32_t key = 0; key < card()->key_count; key++) {
        /* Key 2 has no own knot at the place of knot 2, so this test uses knot 3 for it. */
        const uint32_t knot = key == 2 ? 3u : 2u;
        tap((enum lab_part)(LAB_KEY + key));
        struct layout_point at = knot_at(knot, key);
        at.x += 5.0f;
        at.y -= 5.0f;
        hover(at);
        go_down();
        assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
        assert_int_equal(core.game.lab.held_knot, knot);
        assert_int_equal(core.game.lab.layer, key);
        come_up();
        tap(LAB_PAIRWISE);
    }
}

static void test_an_edit_of_the_size_curve_changes_the_ruler(void **state)
{
    (void)state;
    const struct layout_box plot = lab_box(0, card()->key_count, LAB_PLOT);
    tap(LAB_SIZE);
    assert_int_equal(core.game.lab.layer, LAB_LAYER_SIZE);
    const float share = lab_length_share(card(), card()->key_length_m[1]);
    const float x = plot.x + plot.width / (float)(card()->key_count - 1u);
    drag_down((struct layout_point){ x, plot.y + (1.0f - share) * plot.height },
              (struct layout_point){ x, plot.y + 0.2f * plot.height });
    assert_int_equal(core.game.lab.edit.scale_knot_count, card()->key_count);
    assert_float_equal(look()->lab.length_m, lab_length_of_share(card(), 0.8f),
                       0.02f * scene.lab.length_m);
    tap(LAB_RESET);
    assert_int_equal(core.game.lab.edit.scale_knot_count, card()->scale_knot_count);
}

static void test_a_saved_graph_is_stored_acknowledged_and_present_on_return(void **state)
{
    (void)state;
    tap(LAB_SMOOTH);
    const struct lab_edit made = core.game.lab.edit;
    assert_int_equal(output.edit.id, 0);
    tap(LAB_SAVE);
    assert_int_equal(output.edit.id, 1);
    assert_string_equal(output.edit.species, card()->id);
    assert_memory_equal(&output.edit.edit, &made, sizeof made);
    assert_int_equal(output.edit.is_own, 0);
    assert_int_equal(look()->lab.keeping, LAB_SAVING);
    input.edit_saved_id = 1;
    tick();
    assert_int_equal(look()->lab.keeping, LAB_SAVED);
    assert_int_equal(scene.lab.is_kept, 1);
    tap(LAB_NEXT);
    /* The state LAB_SAVED belonged to the first species. No save was requested for the species that
     * is shown now. */
    assert_int_equal(look()->lab.keeping, LAB_NOT_SAVED);
    tap(LAB_BACK);
    assert_memory_equal(&core.game.lab.edit, &made, sizeof made);
    tap(LAB_RESET);
    tap(LAB_SAVE);
    assert_int_equal(output.edit.id, 2);
    /* After the reset the species has its original graph again (`is_own`), so the store must delete
     * the saved graph. */
    assert_int_equal(output.edit.is_own, 1);
}

/* If there is no store, or the store is full, the page must show that saving failed. A later
 * attempt may succeed. */
static void test_a_failed_save_is_reported(void **state)
{
    (void)state;
    tap(LAB_SMOOTH);
    input.edit_refused = 1;
    tick();
    assert_int_equal(look()->lab.keeping, LAB_NOT_SAVED);
    tap(LAB_SAVE);
    assert_int_equal(look()->lab.keeping, LAB_UNSAVED);
    input.edit_refused = 0;
    tick();
    assert_int_equal(look()->lab.keeping, LAB_SAVING);
    tap(LAB_SAVE);
    assert_int_equal(output.edit.id, 2);
    input.edit_saved_id = 2;
    /* Save 2 is on the disk. The failure that the store reports now (`edit_refused`) belongs to
     * another save, so the page must still show that save 2 succeeded. */
    input.edit_refused = 1;
    tick();
    assert_int_equal(look()->lab.keeping, LAB_SAVED);
}

static void test_the_lab_starts_with_the_graphs_of_the_book(void **state)
{
    (void)state;
    static struct core_config config;
    config = (struct core_config){ .seed = 5, .fish_count = 12, .modes = 1u << CHOICE_LAB };
    config.book.has_edit[0] = 1;
    lab_edit_own(&config.book.edits[0], &species_table[0]->card);
    lab_edit_template(&config.book.edits[0], &species_table[0]->card, TEMPLATE_ORDINARY);
    config.book.card_count = 1;
    config.book.cards[0] = species_table[0]->card;
    config.book.cards[0].id[0] = 'x';
    open_core(&config);
    assert_int_equal(look()->lab.template_id, TEMPLATE_ORDINARY);
    assert_int_equal(scene.lab.species_count, species_table_count + 1u);
    /* From the first species, LAB_BACK leads to the last one, which is the custom species 'x'. */
    tap(LAB_BACK);
    assert_int_equal(look()->lab.card.id[0], 'x');
    config.book.edits[0].graph.knots[0].weight[0] = 0.5f;
    assert_int_equal(core_init(&core, &config), CORE_ERR_RANGE);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, open_lab)
    const struct CMUnitTest tests[] = {
        TEST(test_a_dragged_knot_always_keeps_the_constraint),
        TEST(test_a_page_change_does_not_move_a_held_knot),
        TEST(test_a_template_replaces_the_graph),
        TEST(test_knots_are_added_and_removed_at_the_present_progress),
        TEST(test_a_required_knot_is_not_removed),
        TEST(test_the_selected_curve_has_priority_among_knots_in_one_place),
        TEST(test_an_edit_of_the_size_curve_changes_the_ruler),
        TEST(test_a_saved_graph_is_stored_acknowledged_and_present_on_return),
        TEST(test_a_failed_save_is_reported),
        TEST(test_the_lab_starts_with_the_graphs_of_the_book),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
