/* test_ui_lab.c -- Tests the screens of the growth lab and the album by their vertices.
 *
 * Everything that is drawn must be on the screen, and each control must be drawn where a press
 * selects this control. */
#include "tests/unit/support/core_fixture.h"

#include <stdbool.h>
#include <stdio.h>

#include "core/game/lab/lab.h"
#include "platform/render/textures.h"
#include "platform/render/ui/ui_screens.h"
#include "tests/unit/support/glyphs.h"

#define ROUNDING_PX 0.6f

static const float sizes[][2] = {
    { 1280, 720 }, { 1920, 1080 }, { 3840, 2160 }, { 1080, 1920 }, { 720, 1280 },
    { 1024, 768 }, { 480, 800 },   { 3440, 1440 }, { 640, 360 },   { 1280, 1280 },
};
#define SIZE_COUNT (sizeof sizes / sizeof *sizes)

static struct ui_batch batch;
static struct ui_memory memory;
static uint32_t longest;

static int open_lab(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = 1u << CHOICE_LAB };
    open_core(&config);
    memset(&memory, 0, sizeof memory);
    return 0;
}

static void take(uint32_t species)
{
    while (core.game.lab.species != species) {
        press(INPUT_OK);
    }
    core.game.lab.playing = 0;
}

static void lay_out(float width, float height)
{
    core.game.lab.upright = width < POINTER_UPRIGHT_ASPECT * height;
    look();
    ui_screens(&batch, &memory, &scene, width, height);
    longest = batch.quad_count > longest ? batch.quad_count : longest;
}

static void check_inside(float width, float height)
{
    assert_int_equal(batch.dropped_count, 0);
    assert_int_equal(batch.unbaked_count, 0);
    float share = 0.0f;
    const uint32_t covered = glyph_find_covered(&batch, &share);
    if (covered < batch.quad_count) {
        const struct ui_vertex *v = &batch.vertices[covered * 4u];
        fail_msg(
            "%gx%g species %u language %d: the letter at %.1f, %.1f is covered to a share of %.2f",
            (double)width, (double)height, core.game.lab.species, scene.language, (double)v->x,
            (double)v->y, (double)share);
    }
    for (uint32_t i = 0; i < batch.quad_count * 4u; i++) {
        const struct ui_vertex *v = &batch.vertices[i];
        const int lights = batch.kinds[i / 4u] == UI_GLOW;
        if (!lights && (v->x < -ROUNDING_PX || v->y < -ROUNDING_PX || v->x > width + ROUNDING_PX ||
                        v->y > height + ROUNDING_PX)) {
            fail_msg("%gx%g species %u: quad %u of kind %d is at %.1f, %.1f", (double)width,
                     (double)height, core.game.lab.species, i / 4u, batch.kinds[i / 4u],
                     (double)v->x, (double)v->y);
        }
    }
}

static void test_the_lab_fits_every_screen_with_every_species(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * species_table_count; k++) {
        const float *size = sizes[k % SIZE_COUNT];
        take((uint32_t)(k / SIZE_COUNT));
        for (uint32_t variant = 0; variant < 8; variant++) {
            core.game.lab.progress = (float)variant / 7.0f;
            core.game.lab.compare = variant & 1u;
            core.game.lab.path = variant >> 1 & 1u;
            core.game.lab.layer = variant & 4u ? LAB_LAYER_SIZE : 1;
            core.game.language = (uint8_t)(variant % LANGUAGE_COUNT);
            core.game.lab.has_pointer = 1;
            /* Holds the poi in the middle, because a drawn poi near the edge may extend beyond the
             * screen. */
            core.game.lab.x = core.game.lab.y = 400.0f;
            lay_out(size[0], size[1]);
            check_inside(size[0], size[1]);
            const uint32_t keys = scene.lab.card.key_count;
            assert_int_equal(batch.specimen_count, keys + 1u + (variant & 1u));
        }
    }
    print_message("the longest screen has %u quads of %u\n", longest, UI_QUADS_MAX);
    /* 200 quads must be left for graphs with twelve knots and for languages with longer words. */
    assert_in_range(longest, 1, UI_QUADS_MAX - 200u);
}

/* Returns 1 if a round dot of the colour `colour` is drawn with its centre at (x, y). */
static bool is_dot(float x, float y, uint32_t colour)
{
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const struct ui_vertex *v = &batch.vertices[i * 4u];
        const float dx = 0.5f * (v[0].x + v[3].x) - x, dy = 0.5f * (v[0].y + v[3].y) - y;
        const uint32_t fill = (uint32_t)v->fill[0] << 24 | (uint32_t)v->fill[1] << 16 |
                              (uint32_t)v->fill[2] << 8 | v->fill[3];
        if (batch.kinds[i] == UI_PANEL && fill == colour && dx * dx + dy * dy < 0.3f &&
            v->shape[0] > 2.0f && v->shape[0] == v->shape[2]) {
            return true;
        }
    }
    return false;
}

/* Holds the poi over a point of the lab page and runs a tick. The poi is under water if `down` is
 * 1, which presses the control at that point. */
static void point_at(struct layout_point at, int down)
{
    const struct layout_point canvas = pointer_layout_size(core.game.lab.upright);
    input.upright = core.game.lab.upright;
    hold(0, v3((at.x / canvas.x - 0.5f) * core.world.tank.size_m.x, down ? -0.02f : 0.035f,
               (at.y / canvas.y - 0.5f) * core.world.tank.size_m.z));
    tick();
}

/* Each knot of the selected curve must be drawn as a dot. A press on the centre of the dot must
 * select this knot. */
static void test_every_knot_is_selected_at_its_drawn_position(void **state)
{
    (void)state;
    static const uint32_t red = 0xd23a2cffu;
    for (uint32_t s = 0; s < 4; s++) {
        const float width = sizes[s][0], height = sizes[s][1];
        lay_out(width, height);
        const struct layout_point canvas = pointer_layout_size(core.game.lab.upright);
        const float unit =
            core.game.lab.upright ? width / canvas.x : f_min(width / canvas.x, height / canvas.y);
        const struct layout_box plot =
            lab_box(core.game.lab.upright, scene.lab.card.key_count, LAB_PLOT);
        for (uint32_t i = 0; i < core.game.lab.edit.graph.knot_count; i++) {
            const struct graph_knot *knot = &core.game.lab.edit.graph.knots[i];
            const struct layout_point at = { plot.x + knot->progress * plot.width,
                                             plot.y + (1.0f - knot->weight[0]) * plot.height };
            core.game.lab.layer = 0;
            lay_out(width, height);
            assert_true(is_dot(0.5f * width + (at.x - 0.5f * canvas.x) * unit,
                               0.5f * height + (at.y - 0.5f * canvas.y) * unit, red));
            point_at(at, 0);
            point_at(at, 1);
            assert_int_equal(core.game.lab.holds, HOLD_WEIGHT);
            assert_int_equal(core.game.lab.held_knot, i);
            assert_int_equal(core.game.lab.layer, 0);
            point_at(at, 0);
        }
    }
}

static void test_the_lab_fish_stays_between_stage_and_ruler(void **state)
{
    (void)state;
    for (uint32_t k = 0; k < SIZE_COUNT * species_table_count; k++) {
        const float *size = sizes[k % SIZE_COUNT];
        take((uint32_t)(k / SIZE_COUNT));
        core.game.lab.progress = 1.0f;
        /* While the lab shows the paths of points, the fish does not swim, so its position is
         * constant. */
        core.game.lab.path = 1;
        core.game.lab.compare = k % 2u == 1u;
        lay_out(size[0], size[1]);
        const struct specimen *fish = &batch.specimens[0];
        const struct specimen_bounds reach = specimen_bounds(fish);
        const struct layout_point canvas = pointer_layout_size(core.game.lab.upright);
        const struct layout_box stage =
            lab_box(core.game.lab.upright, scene.lab.card.key_count, LAB_STAGE);
        const float unit = core.game.lab.upright ? size[0] / canvas.x
                                                 : f_min(size[0] / canvas.x, size[1] / canvas.y);
        const float left = 0.5f * size[0] + (stage.x - 0.5f * canvas.x) * unit;
        const float top = 0.5f * size[1] + (stage.y - 0.5f * canvas.y) * unit;
        const int beside = core.game.lab.compare && !core.game.lab.upright;
        const int over = core.game.lab.compare && core.game.lab.upright;
        const float stage_width = stage.width * (beside ? 0.5f : 1.0f);
        const float stage_height = stage.height * (over ? 0.5f : 1.0f);
        const float caption = core.game.lab.compare ? 48.0f : 0.0f;
        assert_true(fish->x_px - reach.left * fish->length_px >= left);
        assert_true(fish->x_px + reach.right * fish->length_px <= left + stage_width * unit);
        assert_true(fish->y_px - reach.up * fish->length_px >= top + caption * unit);
        assert_true(fish->y_px + reach.down * fish->length_px <=
                    top + (stage_height - 50.0f) * unit);
        const float wide = (reach.left + reach.right) * fish->length_px;
        const float high = (reach.up + reach.down) * fish->length_px;
        assert_true(wide > 0.8f * stage_width * unit ||
                    high > (core.game.lab.compare ? 0.45f : 0.6f) * stage_height * unit);
    }
}

/* The recording contains a species that this kiosk does not have. The lab can then show the morph
 * graph of the species, but no fish. */
static void test_an_unknown_species_has_a_graph_and_no_fish(void **state)
{
    (void)state;
    static struct core_config config;
    config = (struct core_config){ .seed = 5, .fish_count = 12, .modes = 1u << CHOICE_LAB };
    config.book.card_count = 1;
    config.book.cards[0] = species_table[0]->card;
    config.book.cards[0].id[0] = 'x';
    open_core(&config);
    take(species_table_count);
    lay_out(1280, 720);
    check_inside(1280, 720);
    assert_int_equal(batch.specimen_count, 0);
}

/* The recorded species was in a slot of the library. The slot now has the same species (`other` is
 * 0), another species (1), or a species with the same id and another number of key shapes (2). Only
 * in the first case may the fish be drawn. */
static void test_only_the_recorded_species_is_shown(void **state)
{
    (void)state;
    static struct core_config config;
    static struct library library;
    config = (struct core_config){ .seed = 5, .fish_count = 12, .modes = 1u << CHOICE_LAB };
    config.book.card_count = 1;
    library.species_count = library.line_count = 1;
    config.book.cards[0] = species_table[0]->card;
    config.book.cards[0].id[0] = 'x';
    open_core(&config);
    take(species_table_count);
    memory.library = &library;
    for (uint32_t other = 0; other < 3; other++) {
        library.slots[0].species = *species_table[0];
        library.slots[0].species.card.id[0] = other == 1 ? 'y' : 'x';
        library.slots[0].species.card.key_count =
            (uint8_t)(species_table[0]->card.key_count - (other == 2 ? 1u : 0u));
        lay_out(1280, 720);
        check_inside(1280, 720);
        assert_int_equal(batch.specimen_count > 0, other == 0);
    }
}

static uint32_t glyphs_of(uint32_t colour)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        const uint8_t *fill = batch.vertices[i * 4u].fill;
        count += batch.kinds[i] == UI_GLYPH && ((uint32_t)fill[0] << 24 | (uint32_t)fill[1] << 16 |
                                                (uint32_t)fill[2] << 8 | fill[3]) == colour;
    }
    return count;
}

static uint32_t letters_in(const char *words)
{
    uint32_t count = 0;
    for (; *words; words++) {
        count += *words != ' ';
    }
    return count;
}

/* The lab shows several texts in turn: how to use the controller, the number of rejected files, and
 * each rejected file with its reason. */
static void test_each_rejected_file_is_shown_with_its_reason(void **state)
{
    (void)state;
    static struct library library;
    memset(&library, 0, sizeof library);
    library.line_count = 2;
    for (uint32_t i = 0; i < 2; i++) {
        library.lines[i].slot = LIBRARY_SLOT_NONE;
        memset(library.lines[i].file, 'f', sizeof library.lines[i].file - 1u - 20u * i);
        memset(library.lines[i].why, 'w', sizeof library.lines[i].why - 1u - 30u * i);
    }
    library_note_graph(&library, "graphs/wakin.graph:3: wakin has 5 keys");
    memory.library = &library;
    core.config.book.refused = 2;
    const uint32_t start = core.game.tick;
    for (uint32_t s = 0; s < SIZE_COUNT; s++) {
        const float width = sizes[s][0], height = sizes[s][1];
        uint32_t seen = 0;
        for (uint32_t turn = 0; turn < 6; turn++) {
            core.game.tick = start + 60u + turn * 4u * CORE_TICK_HZ;
            core.game.lab.stir_tick = core.game.lab.act_tick = core.game.tick;
            core.game.language = LANGUAGE_EN;
            lay_out(width, height);
            check_inside(width, height);
            const uint32_t letters = glyphs_of(0xf0c089ffu);
            for (uint32_t i = 0; i < library_fault_count(&library); i++) {
                const struct library_line fault = library_fault(&library, i);
                seen |= letters == letters_in(fault.file) + letters_in(fault.why) ? 1u << i : 0u;
            }
        }
        /* `seen` has one bit for each of the three files, and all three must have been shown. On a
         * portrait screen there may be no room for these texts. */
        assert_true(seen == 7u || (seen == 0u && width < height));
    }
    core.game.tick = start;
}

static void test_the_ordinary_morph_in_the_lab_is_linear(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        take(i);
        core.game.lab.compare = 1;
        core.game.lab.path = 1;
        lay_out(1280, 720);
        for (uint32_t p = 0; p < LAB_PREVIEW_POINT_COUNT; p++) {
            const struct lab_preview_path *way = &memory.bench.ways[p];
            const vec3 from = way->ordinary[0], to = way->ordinary[LAB_PREVIEW_STEPS];
            for (uint32_t k = 0; way->is_there && k <= LAB_PREVIEW_STEPS; k++) {
                const float t = (float)k / (float)LAB_PREVIEW_STEPS;
                assert_float_equal(v3_length(v3_sub(way->ordinary[k], v3_lerp(from, to, t))), 0.0f,
                                   1e-3f);
            }
        }
        assert_ptr_equal(batch.specimens[1].species, &memory.bench.ordinary);
    }
}

static void test_an_edited_knot_changes_the_path_of_a_point(void **state)
{
    (void)state;
    core.game.lab.path = 1;
    lay_out(1280, 720);
    const vec3 before = memory.bench.ways[LAB_PREVIEW_EYE].at[LAB_PREVIEW_STEPS / 2u];
    lab_edit_template(&core.game.lab.edit, &species_table[0]->card, TEMPLATE_ORDINARY);
    lay_out(1280, 720);
    const vec3 after = memory.bench.ways[LAB_PREVIEW_EYE].at[LAB_PREVIEW_STEPS / 2u];
    assert_true(v3_length(v3_sub(before, after)) > 1e-3f);
}

/* The bow of a path is its largest distance from the infinite line through the two ends of the
 * path. `kingyoctl morph path` uses the same definition. */
static void test_the_bow_is_measured_from_the_infinite_line(void **state)
{
    (void)state;
    for (uint32_t s = 0; s < species_table_count; s++) {
        take(s);
        lay_out(1280, 720);
        for (uint32_t p = 0; p < LAB_PREVIEW_POINT_COUNT; p++) {
            const struct lab_preview_path *way = &memory.bench.ways[p];
            const vec3 along = v3_sub(way->at[LAB_PREVIEW_STEPS], way->at[0]);
            float bow = 0.0f;
            for (uint32_t i = 0; way->is_there && i <= LAB_PREVIEW_STEPS; i++) {
                const vec3 off = v3_sub(way->at[i], way->at[0]);
                bow = f_max(bow, v3_length(v3_cross(off, along)) / v3_length(along));
            }
            assert_float_equal(way->bow, bow, 1e-5f);
        }
    }
}

/* ---- Tests of the album of caught fish ------------------------------------------------------ */

static void catch_fish(uint32_t count)
{
    core.game.album = (struct album){ 0 };
    for (uint32_t i = 0; i < 12; i++) {
        core.world.tank.fish[i].gait = i < count ? GAIT_BOWL : GAIT_SWIM;
        core.world.tank.fish[i].holder = 0;
        core.world.tank.fish[i].look = 0x1234567u * (i + 1u);
    }
    album_note(&core.game.album, &core.world, 0, count);
    core.game.phase = PHASE_ALBUM;
}

static void test_the_album_fits_every_screen_with_one_to_six_fish(void **state)
{
    (void)state;
    ticks(3000);
    for (uint32_t k = 0; k < SIZE_COUNT * ALBUM_FISH_MAX; k++) {
        const float *size = sizes[k % SIZE_COUNT];
        const uint32_t count = 1u + (uint32_t)(k / SIZE_COUNT);
        catch_fish(count);
        for (uint32_t part = 1; part <= 5; part++) {
            core.game.language = (uint8_t)(part % LANGUAGE_COUNT);
            core.game.phase_tick = core.game.tick - part * album_ticks(count) / 5u;
            lay_out(size[0], size[1]);
            check_inside(size[0], size[1]);
            assert_int_equal(batch.specimen_count, count);
        }
    }
}

/* Returns how many discs and rings the album has with two fish, of which `presents` are presents. A
 * player who caught no fish has a present. */
static uint32_t album_rings(const float size[2], uint32_t presents)
{
    uint32_t rings = 0;
    catch_fish(2);
    for (uint32_t i = 0; i < 2u; i++) {
        core.game.player[i].caught = i < presents ? 0u : 1u;
        core.game.album.fish[i].owner = i;
    }
    core.game.phase_tick = core.game.tick - album_ticks(2);
    lay_out(size[0], size[1]);
    check_inside(size[0], size[1]);
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        rings += batch.kinds[i] == UI_RING;
    }
    return rings;
}

/* The bow lets a visitor who does not read see which fish is a present. */
static void test_each_present_in_the_album_has_a_bow(void **state)
{
    (void)state;
    ticks(300);
    for (uint32_t k = 0; k < SIZE_COUNT; k++) {
        const uint32_t none = album_rings(sizes[k], 0);
        const uint32_t bow = album_rings(sizes[k], 1) - none;
        assert_true(bow >= 4u);
        assert_int_equal(album_rings(sizes[k], 2) - none, 2u * bow);
    }
}

static void test_each_album_fish_has_its_pattern_from_the_tank(void **state)
{
    (void)state;
    ticks(300);
    catch_fish(3);
    core.game.phase_tick = core.game.tick - 200u;
    lay_out(1280, 720);
    for (uint32_t i = 0; i < 3; i++) {
        assert_int_equal(batch.specimens[i].look, core.world.tank.fish[i].look);
        assert_ptr_equal(batch.specimens[i].species,
                         textures_variety(core.world.tank.fish[i].look));
    }
    assert_int_not_equal(batch.specimens[0].look, batch.specimens[1].look);
}

/* At the age of its catch, an album fish has its full adult pattern. As a hatchling, the fish has
 * no pattern. */
static void test_an_album_fish_looks_on_its_catch_day_as_in_the_tank(void **state)
{
    (void)state;
    uint32_t met = 0, hatched = 0;
    ticks(300);
    catch_fish(ALBUM_FISH_MAX);
    for (uint32_t i = 0; i < core.game.album.fish_count; i++) {
        core.game.album.fish[i].age_days = 20.0f + 25.0f * (float)i;
    }
    for (uint32_t part = 0; part <= 200; part++) {
        core.game.phase_tick = core.game.tick - part * album_ticks(ALBUM_FISH_MAX) / 200u;
        lay_out(1280, 720);
        for (uint32_t i = 0; i < ALBUM_FISH_MAX; i++) {
            if (scene.album.fish[i].is_caught) {
                met++;
                assert_float_equal(batch.specimens[i].ripe, 1.0f, 1e-4f);
            } else if (scene.album.fish[i].progress == 0.0f && i > 2) {
                hatched++;
                assert_float_equal(batch.specimens[i].ripe, 0.0f, 0.0f);
            }
        }
    }
    assert_true(met > 0 && hatched > 0);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, open_lab)
    const struct CMUnitTest tests[] = {
        TEST(test_the_lab_fits_every_screen_with_every_species),
        TEST(test_every_knot_is_selected_at_its_drawn_position),
        TEST(test_the_lab_fish_stays_between_stage_and_ruler),
        TEST(test_an_unknown_species_has_a_graph_and_no_fish),
        TEST(test_only_the_recorded_species_is_shown),
        TEST(test_each_rejected_file_is_shown_with_its_reason),
        TEST(test_the_ordinary_morph_in_the_lab_is_linear),
        TEST(test_an_edited_knot_changes_the_path_of_a_point),
        TEST(test_the_album_fits_every_screen_with_one_to_six_fish),
        TEST(test_each_present_in_the_album_has_a_bow),
        TEST(test_the_bow_is_measured_from_the_infinite_line),
        TEST(test_an_album_fish_looks_on_its_catch_day_as_in_the_tank),
        TEST(test_each_album_fish_has_its_pattern_from_the_tank),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
