/* test_lab.c -- the growth lab, played by inputs alone: a poi in a hand, a mouse, or buttons. */
#include "tests/unit/support/stall_stand.h"

#include "core/base/rng.h"

#define ALL ((1u << CHOICE_COUNT) - 1u)
#define UP_M 0.035f /* As a mouse hovers. */
#define DOWN_M (-0.01f)

static const struct species_card *card(void)
{
    return lab_book_card(&core.config.book, core.game.lab.species);
}

static struct layout_point middle_of(enum lab_part part)
{
    const struct layout_box box = lab_box(core.game.lab.upright, card()->key_count, part);
    return (struct layout_point){ box.x + 0.5f * box.width, box.y + 0.5f * box.height };
}

/* A hand with a wrist over that point of the canvas. */
static void hover(struct layout_point at)
{
    const struct layout_point canvas = pointer_layout_size(core.game.lab.upright);
    hold(0, v3((at.x / canvas.x - 0.5f) * core.world.tank.size_m.x, UP_M,
               (at.y / canvas.y - 0.5f) * core.world.tank.size_m.z));
    tick();
}

static void go_down(void)
{
    input.poi[0].target.position_m.y = DOWN_M;
    tick();
}

static void come_up(void)
{
    input.poi[0].target.position_m.y = UP_M;
    tick();
}

static void tap(enum lab_part part)
{
    hover(middle_of(part));
    go_down();
    come_up();
}

static void drag_down(struct layout_point from, struct layout_point to)
{
    const struct layout_point canvas = pointer_layout_size(core.game.lab.upright);
    hover(from);
    go_down();
    for (uint32_t i = 1; i <= 10; i++) {
        const float share = 0.1f * (float)i;
        const float x = f_lerp(from.x, to.x, share), y = f_lerp(from.y, to.y, share);
        hold(0, v3((x / canvas.x - 0.5f) * core.world.tank.size_m.x, DOWN_M,
                   (y / canvas.y - 0.5f) * core.world.tank.size_m.z));
        tick();
    }
    come_up();
}

static struct layout_point knot_at(uint32_t knot, uint32_t key)
{
    const struct layout_box plot = lab_box(core.game.lab.upright, card()->key_count, LAB_PLOT);
    const struct graph_knot *at = &core.game.lab.edit.graph.knots[knot];
    return (struct layout_point){ plot.x + at->progress * plot.width,
                                  plot.y + (1.0f - at->weight[key]) * plot.height };
}

static int open_lab(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = 1u << CHOICE_LAB };
    open_stall(&config);
    assert_int_equal(core.game.phase, PHASE_LAB);
    return 0;
}

/* ---- In and out ----------------------------------------------------------------------------- */

static void test_a_stall_that_offers_the_lab_alone_opens_it(void **state)
{
    (void)state;
    assert_int_equal(look()->phase, PHASE_LAB);
    assert_int_equal(scene.lab.species_count, species_table_count);
    tap(LAB_LEAVE);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    press(INPUT_START); /* And START opens it again: there is nothing to choose. */
    assert_int_equal(core.game.phase, PHASE_LAB);
}

/* A hand is not down at once: the rest of its way must not be a dip that opens the lab again. */
static void test_a_hand_that_goes_on_down_after_leaving_opens_nothing(void **state)
{
    (void)state;
    hover(middle_of(LAB_LEAVE));
    for (int32_t mm = 30; mm >= -60; mm -= 5) {
        input.poi[0].target.position_m.y = 0.001f * (float)mm;
        tick();
    }
    come_up();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    ticks(60);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    lead(0, v3(0.0f, STAND_BELOW_M, 0.0f));
    assert_int_equal(core.game.phase, PHASE_LAB);
}

static void test_the_lab_hangs_beside_the_modes_and_a_dip_takes_it(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = ALL };
    open_stall(&config);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    ticks(GAME_MODE_SELECT_TICKS_MIN);
    for (uint32_t i = 0; i < 3; i++) {
        press(INPUT_RIGHT);
    }
    assert_int_equal(look()->choice, CHOICE_LAB);
    assert_int_equal(scene.mode, MODE_PRACTICE); /* No mode is the lab's: scores are by mode. */
    press(INPUT_RIGHT);
    assert_int_equal(look()->choice, MODE_FESTIVAL);
    dip(0, 0.40f, 0.0f); /* The last fourth of the tank. */
    assert_int_equal(core.game.phase, PHASE_LAB);
}

static void test_the_dip_that_opens_it_presses_nothing(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = ALL };
    open_stall(&config);
    press(INPUT_START);
    ticks(GAME_MODE_SELECT_TICKS_MIN);
    const struct layout_point over = middle_of(LAB_SMOOTH), canvas = pointer_layout_size(0);
    dip(0, (over.x / canvas.x - 0.5f) * core.world.tank.size_m.x,
        (over.y / canvas.y - 0.5f) * core.world.tank.size_m.z);
    ticks(30);
    assert_int_equal(core.game.phase, PHASE_LAB);
    assert_int_equal(core.game.lab.holds, HOLD_BUTTON);
    assert_int_equal(look()->lab.template_id, TEMPLATE_OWN);
    assert_int_equal(scene.lab.playing, 1);
    come_up();
    go_down(); /* Now it is meant. */
    assert_int_equal(look()->lab.template_id, TEMPLATE_SMOOTH);
}

static void test_nothing_that_is_done_there_is_a_score(void **state)
{
    (void)state;
    const uint32_t rounds = core.game.round_count;
    tap(LAB_SAVE);
    tap(LAB_LEAVE);
    assert_int_equal(output.record.id, 0);
    assert_int_equal(core.game.round_count, rounds);
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        assert_int_equal(core.game.accounts.ranking.row[mode][RANK_DAY][0].caught, 0);
    }
}

static void test_a_minute_without_anybody_ends_it(void **state)
{
    (void)state;
    tap(LAB_PLAY);
    input.poi[0].link = POI_SOURCE_ABSENT;
    ticks(LAB_IDLE_TICKS - 60u);
    assert_int_equal(core.game.phase, PHASE_LAB);
    ticks(61);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* It stirs, and never presses: a poi on its cord. */
static void test_a_poi_that_swings_keeps_nobody_there(void **state)
{
    (void)state;
    const uint32_t begin = core.game.tick;
    while (core.game.phase == PHASE_LAB && core.game.tick - begin <= LAB_SWING_TICKS + 120u) {
        hover((struct layout_point){ core.game.tick / 60u % 2u ? 300.0f : 400.0f, 72.0f });
        ticks(20);
    }
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_in_range(core.game.tick - begin, LAB_SWING_TICKS - 60u, LAB_SWING_TICKS + 120u);
}

static void test_start_plays_and_held_leaves(void **state)
{
    (void)state;
    assert_int_equal(core.game.lab.playing, 1);
    press(INPUT_START);
    assert_int_equal(core.game.lab.playing, 0);
    input.held = INPUT_START;
    ticks(LAB_END_TICKS - 1u);
    assert_int_equal(core.game.phase, PHASE_LAB);
    ticks(1);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* ---- Life ----------------------------------------------------------------------------------- */

static void test_a_life_plays_to_its_end_rests_and_begins_anew(void **state)
{
    (void)state;
    ticks(LAB_LIFE_TICKS + 2u);
    assert_float_equal(core.game.lab.progress, 1.0f, 0.0f);
    ticks(LAB_REST_TICKS - 10u);
    assert_float_equal(look()->lab.progress, 1.0f, 0.0f);
    assert_float_equal(scene.lab.age_days, card()->key_age_days[card()->key_count - 1u], 1.0f);
    ticks(20);
    assert_true(core.game.lab.progress < 0.05f);
}

static void test_the_line_of_life_is_scrubbed(void **state)
{
    (void)state;
    const struct layout_box box = lab_box(0, card()->key_count, LAB_AGE);
    const float y = box.y + 20.0f;
    drag_down((struct layout_point){ lab_age_x(0, card()->key_count, 0.1f), y },
              (struct layout_point){ lab_age_x(0, card()->key_count, 0.65f), y });
    assert_float_equal(core.game.lab.progress, 0.65f, 1e-3f);
    assert_int_equal(core.game.lab.playing, 0);
    drag_down((struct layout_point){ lab_age_x(0, card()->key_count, 0.65f), y },
              (struct layout_point){ 5.0f, y });
    assert_float_equal(core.game.lab.progress, 0.0f, 0.0f);
}

static void test_the_growth_curve_is_scrubbed_by_age(void **state)
{
    (void)state;
    const struct layout_box chart = lab_box(0, card()->key_count, LAB_CHART);
    tap(LAB_CHART);
    const float half_days = 0.5f * card()->key_age_days[card()->key_count - 1u];
    assert_true(chart.width > 0.0f);
    assert_float_equal(look()->lab.age_days, half_days, 0.01f * half_days);
}

static void test_left_and_right_lead_through_life_and_ok_turns_the_page(void **state)
{
    (void)state;
    input.held = INPUT_RIGHT;
    ticks(540);
    assert_float_equal(core.game.lab.progress, 0.5f, 0.01f);
    input.held = INPUT_LEFT;
    ticks(60);
    assert_float_equal(core.game.lab.progress, 0.444f, 0.01f);
    input.held = 0;
    press(INPUT_OK);
    assert_int_equal(core.game.lab.species, 1u % species_table_count);
    assert_float_equal(core.game.lab.progress, 0.0f, 0.01f);
}

static void test_every_species_comes_round_both_ways(void **state)
{
    (void)state;
    for (uint32_t i = 1; i <= species_table_count; i++) {
        tap(LAB_NEXT);
        assert_int_equal(core.game.lab.species, i % species_table_count);
        assert_true(lab_edit_is_valid(&core.game.lab.edit, card()));
    }
    tap(LAB_BACK);
    assert_int_equal(core.game.lab.species, species_table_count - 1u);
}

static void test_a_key_leads_to_its_time_and_takes_its_curve(void **state)
{
    (void)state;
    tap((enum lab_part)(LAB_KEY + 2));
    assert_int_equal(core.game.lab.layer, 2);
    assert_float_equal(core.game.lab.progress, 2.0f / (float)(card()->key_count - 1u), 1e-6f);
    assert_float_equal(look()->lab.length_m, card()->key_length_m[2],
                       1e-3f * card()->key_length_m[2]);
}

/* ---- Hands ---------------------------------------------------------------------------------- */

/* Whatever the window's shape, what is under the pointer is what is meant. */
static void test_a_mouse_means_what_is_under_it_on_any_screen(void **state)
{
    (void)state;
    static const float sizes[][2] = { { 1280, 720 },  { 1920, 1080 }, { 1024, 768 },
                                      { 2560, 1080 }, { 1080, 1920 }, { 480, 800 } };
    const struct view *view = &tank_preset(core.world.tank.preset)->view;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        const float width = sizes[s][0], height = sizes[s][1];
        const int upright = width < POINTER_UPRIGHT_ASPECT * height;
        const struct layout_point canvas = pointer_layout_size(upright);
        const float unit = upright ? width / canvas.x : f_min(width / canvas.x, height / canvas.y);
        for (uint32_t i = 0; i < 25; i++) {
            const struct layout_point wanted = { canvas.x * (0.1f + 0.2f * (float)(i % 5u)),
                                                 canvas.y * (0.1f + 0.2f * (float)(i / 5u)) };
            const float x_px = 0.5f * width + (wanted.x - 0.5f * canvas.x) * unit;
            const float y_px = 0.5f * height + (wanted.y - 0.5f * canvas.y) * unit;
            for (uint32_t dipped = 0; dipped < 2; dipped++) {
                const vec3 hand_m =
                    view_point_on_plane(view, width / height, 2.0f * x_px / width - 1.0f,
                                        1.0f - 2.0f * y_px / height, dipped ? -0.05f : UP_M);
                const struct layout_point got = pointer_project(view, upright, hand_m);
                assert_float_equal(got.x, wanted.x, 0.5f);
                assert_float_equal(got.y, wanted.y, 0.5f);
            }
        }
    }
}

static void test_a_mouse_presses_as_a_poi_does(void **state)
{
    (void)state;
    const struct view *view = &tank_preset(core.world.tank.preset)->view;
    const struct layout_point at = middle_of(LAB_COMPARE);
    const float x = at.x / 640.0f - 1.0f, y = 1.0f - at.y / 360.0f;
    for (uint32_t i = 0; i < 3; i++) {
        const float height_m = i == 1 ? -0.05f : UP_M;
        input.poi[0] = (struct poi_input){
            .link = POI_SOURCE_LIVE,
            .target.position_m = view_point_on_plane(view, 16.0f / 9.0f, x, y, height_m),
        };
        ticks(3);
    }
    assert_int_equal(look()->lab.compare, 1);
    assert_int_equal(scene.lab.points, LAB_COMPARE);
}

static void test_parts_do_not_overlap_and_lie_on_their_canvas(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < 2u * 6u; k++) {
        const int upright = (int)(k % 2u);
        const uint32_t keys = 3u + k / 2u;
        const struct layout_point canvas = pointer_layout_size(upright);
        for (uint32_t a = 1; a < LAB_PRESSED_COUNT; a++) {
            const struct layout_box box = lab_box(upright, keys, (enum lab_part)a);
            if (box.width == 0.0f) {
                assert_in_range(a, LAB_KEY + keys, LAB_KEY_LAST);
                continue;
            }
            assert_true(box.x >= 0.0f && box.x + box.width <= canvas.x);
            assert_true(box.y >= 0.0f && box.y + box.height <= canvas.y);
            assert_true(box.height >= 40.0f); /* A finger's breadth for a wet hand. */
            for (uint32_t b = a + 1u; b < LAB_PRESSED_COUNT; b++) {
                const struct layout_box other = lab_box(upright, keys, (enum lab_part)b);
                const int apart = box.x + box.width <= other.x || other.x + other.width <= box.x ||
                                  box.y + box.height <= other.y || other.y + other.height <= box.y;
                if (!apart && other.width > 0.0f) {
                    fail_msg("parts %u and %u overlap (%d, %u keys)", a, b, upright, keys);
                }
            }
            const struct layout_point middle = { box.x + 0.5f * box.width,
                                                 box.y + 0.5f * box.height };
            assert_int_equal(lab_part_at(upright, keys, middle), a);
        }
    }
}

static void test_a_hand_that_goes_lets_go(void **state)
{
    (void)state;
    hover(knot_at(1, 1));
    go_down();
    assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
    input.poi[0].link = POI_SOURCE_LOST;
    tick();
    assert_int_equal(core.game.lab.holds, HOLD_NOTHING);
    assert_int_equal(look()->lab.has_hand, 0);
    hover(middle_of(LAB_STAGE));
    input.poi[0].target.position_m.x = 0.0f / 0.0f; /* No number is no hand, and no crash. */
    tick();
    assert_int_equal(look()->lab.has_hand, 0);
}

/* Both are down when the first goes, and when it comes back. */
static void test_what_one_hand_held_never_leaps_to_another(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 5, .fish_count = 12, .players = 2, .modes = 1u << CHOICE_LAB
    };
    open_stall(&config);
    hover(knot_at(1, 1));
    go_down();
    assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
    const struct lab_edit before = core.game.lab.edit;
    const struct poi_input first = input.poi[0];
    hold(1, v3(0.0f, DOWN_M, 0.0f));
    ticks(3);
    for (uint32_t i = 0; i < 2; i++) {
        input.poi[0].link = i == 0 ? POI_SOURCE_LOST : POI_SOURCE_LIVE;
        ticks(3);
        assert_int_equal(look()->lab.has_hand, 1);
        assert_int_equal(core.game.lab.hand, 1u - i);
        assert_int_equal(core.game.lab.holds, HOLD_BUTTON);
        assert_memory_equal(&core.game.lab.edit, &before, sizeof before);
    }
    come_up();
    input.poi[0] = first;
    tick();
    assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
}

/* ---- The graph ------------------------------------------------------------------------------ */

static void test_a_dragged_knot_keeps_the_constraint_all_the_way(void **state)
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

/* The button's hand is another than the one that holds: nobody need let go first. */
static void test_a_page_turned_under_a_held_knot_leaves_it_alone(void **state)
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

static void test_templates_take_the_places_of_the_graph(void **state)
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

static void test_knots_are_added_where_life_stands_and_taken_away_there(void **state)
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

static void test_a_knot_that_a_drawing_needs_stays(void **state)
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

/* Where many keys' knots lie one upon the other, the curve in hand is meant. */
static void test_of_knots_in_one_place_that_of_the_curve_in_hand_is_taken(void **state)
{
    (void)state;
    tap(LAB_PAIRWISE);
    for (uint32_t key = 0; key < card()->key_count; key++) {
        const uint32_t knot = key == 2 ? 3u : 2u; /* Another key's: this one has nothing there. */
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

static void test_the_scale_is_drawn_by_hand_and_tells_on_the_ruler(void **state)
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

static void test_a_saved_graph_is_handed_out_known_as_kept_and_there_on_return(void **state)
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
    assert_int_equal(look()->lab.keeping, LAB_NOT_SAVED); /* Of this one. */
    tap(LAB_BACK);
    assert_memory_equal(&core.game.lab.edit, &made, sizeof made);
    tap(LAB_RESET);
    tap(LAB_SAVE);
    assert_int_equal(output.edit.id, 2);
    assert_int_equal(output.edit.is_own, 1); /* The file goes. */
}

/* No store, or one whose card is full: it is told, and a later try may go well. */
static void test_a_graph_that_cannot_be_kept_is_no_longer_being_saved(void **state)
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
    input.edit_refused = 1; /* A later one; this one is on the disk. */
    tick();
    assert_int_equal(look()->lab.keeping, LAB_SAVED);
}

static void test_what_the_book_says_is_on_the_table_at_start(void **state)
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
    open_stall(&config);
    assert_int_equal(look()->lab.template_id, TEMPLATE_ORDINARY);
    assert_int_equal(scene.lab.species_count, species_table_count + 1u);
    tap(LAB_BACK); /* The maker's is the last. */
    assert_int_equal(look()->lab.card.id[0], 'x');
    config.book.edits[0].graph.knots[0].weight[0] = 0.5f;
    assert_int_equal(core_init(&core, &config), CORE_ERR_RANGE);
}

/* ---- Any hands ------------------------------------------------------------------------------ */

static void play_wildly(uint32_t seed, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t bits = rng_u32((struct rng_key){ seed, i / 12u, 0, RNG_TEST });
        const float x = (float)(bits & 255u) / 255.0f - 0.5f;
        const float z = (float)(bits >> 8 & 255u) / 255.0f - 0.5f;
        hold(0, v3(x * core.world.tank.size_m.x, bits >> 16 & 1u ? DOWN_M : UP_M,
                   z * core.world.tank.size_m.z));
        input.upright = (bits >> 20 & 15u) == 0;
        input.pressed = bits >> 24 == 7u || i % 97u == 0 ? INPUT_OK : 0;
        tick();
        if (core.game.phase != PHASE_LAB) {
            press(INPUT_START);
        }
        assert_true(lab_edit_is_valid(&core.game.lab.edit, card()));
        assert_true(core.game.lab.progress >= 0.0f && core.game.lab.progress <= 1.0f);
        look();
    }
}

static void test_the_same_hands_make_the_same_lab_and_wild_ones_break_nothing(void **state)
{
    uint64_t hashes[2];
    for (uint32_t i = 0; i < 2; i++) {
        open_lab(state);
        play_wildly(11, 3000);
        hashes[i] = core_hash(&core);
    }
    assert_true(hashes[0] == hashes[1]);
    open_lab(state);
    play_wildly(12, 3000);
    assert_true(core_hash(&core) != hashes[0]);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, open_lab)
    const struct CMUnitTest tests[] = {
        TEST(test_a_stall_that_offers_the_lab_alone_opens_it),
        TEST(test_a_hand_that_goes_on_down_after_leaving_opens_nothing),
        TEST(test_the_lab_hangs_beside_the_modes_and_a_dip_takes_it),
        TEST(test_the_dip_that_opens_it_presses_nothing),
        TEST(test_nothing_that_is_done_there_is_a_score),
        TEST(test_a_minute_without_anybody_ends_it),
        TEST(test_a_poi_that_swings_keeps_nobody_there),
        TEST(test_start_plays_and_held_leaves),
        TEST(test_a_life_plays_to_its_end_rests_and_begins_anew),
        TEST(test_the_line_of_life_is_scrubbed),
        TEST(test_the_growth_curve_is_scrubbed_by_age),
        TEST(test_left_and_right_lead_through_life_and_ok_turns_the_page),
        TEST(test_every_species_comes_round_both_ways),
        TEST(test_a_key_leads_to_its_time_and_takes_its_curve),
        TEST(test_a_mouse_means_what_is_under_it_on_any_screen),
        TEST(test_a_mouse_presses_as_a_poi_does),
        TEST(test_parts_do_not_overlap_and_lie_on_their_canvas),
        TEST(test_a_hand_that_goes_lets_go),
        TEST(test_what_one_hand_held_never_leaps_to_another),
        TEST(test_a_dragged_knot_keeps_the_constraint_all_the_way),
        TEST(test_a_page_turned_under_a_held_knot_leaves_it_alone),
        TEST(test_templates_take_the_places_of_the_graph),
        TEST(test_knots_are_added_where_life_stands_and_taken_away_there),
        TEST(test_a_knot_that_a_drawing_needs_stays),
        TEST(test_of_knots_in_one_place_that_of_the_curve_in_hand_is_taken),
        TEST(test_the_scale_is_drawn_by_hand_and_tells_on_the_ruler),
        TEST(test_a_saved_graph_is_handed_out_known_as_kept_and_there_on_return),
        TEST(test_a_graph_that_cannot_be_kept_is_no_longer_being_saved),
        TEST(test_what_the_book_says_is_on_the_table_at_start),
        TEST(test_the_same_hands_make_the_same_lab_and_wild_ones_break_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
