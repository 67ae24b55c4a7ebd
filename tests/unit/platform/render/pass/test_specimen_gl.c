/* test_specimen_gl.c -- Tests the drawing of specimens, which are single fish on the pages of the
 * lab and the album. The tests cover all species, their textures, and the texture slots on the
 * GPU. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <SDL.h>

#include "platform/render/pass/specimen_pass.h"
#include "tests/unit/support/gl_context.h"

#define WIDTH 320u
#define HEIGHT 200u
#define SIZE (WIDTH * HEIGHT * 4u)
/* Margin in pixels around a fish. The swimming motion must stay within the margin. */
#define BOX_PX 20.0f

static struct gl_status status;
static struct specimen_pass pass;
static struct textures textures;
static struct gl_target target;
static struct straight_memory memory;
static struct species changed;
static struct display_transform whole;
static uint8_t pictures[2][SIZE];

static int open_pass(void **state)
{
    (void)state;
    open_gl_context("specimen");
    whole = display_transform_of(&(struct display_settings){ .light = 1.0f }, (float)WIDTH,
                                 (float)HEIGHT);
    textures_open(&status, &textures);
    specimen_pass_open(&status, &pass, &textures);
    gl_target_open(
        &status, "sheet", &target,
        &(struct gl_target_desc){
            .internal_format = GL_RGBA8, .width = WIDTH, .height = HEIGHT, .depth = true });
    assert_string_equal(status.text, "");
    return 0;
}

static int close_pass(void **state)
{
    (void)state;
    specimen_pass_close(&pass);
    gl_target_close(&target);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return 0;
}

static struct specimen fish_of(const struct species *species, float progress)
{
    struct specimen fish = { .species = species, .progress = progress };
    specimen_portrait(&fish);
    specimen_fit(&fish, BOX_PX, BOX_PX, (float)WIDTH - 2.0f * BOX_PX,
                 (float)HEIGHT - 2.0f * BOX_PX);
    return fish;
}

static void picture(uint8_t out[SIZE], const struct specimen *fish, float grey)
{
    gl_target_bind(&target);
    glClearColor(grey, grey, grey, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    specimen_pass_finish(&pass, fish);
    specimen_pass_draw(&pass, fish, &whole);
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, out);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static bool is_ground(const uint8_t *pixel, uint8_t grey)
{
    return pixel[0] == grey && pixel[1] == grey && pixel[2] == grey;
}

/* Returns the pixel at which a point of the fish is drawn. The unit of `point` is the body
 * length. */
static const uint8_t *pixel_at(const uint8_t pixels[SIZE], const struct specimen *fish, vec3 point)
{
    float at[2];
    specimen_project(fish, point, at);
    return pixels + ((HEIGHT - 1u - (uint32_t)at[1]) * WIDTH + (uint32_t)at[0]) * 4u;
}

static void test_every_species_is_drawn_inside_its_box_at_every_age(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        for (uint32_t step = 0; step <= 4; step++) {
            struct specimen fish = fish_of(species_table[i], 0.25f * (float)step);
            uint32_t drawn = 0;
            fish.amplitude = 1.0f;
            fish.phase_rad = (float)step;
            picture(pictures[0], &fish, 0.0f);
            for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) {
                const uint32_t x = p % WIDTH, y = p / WIDTH;
                const bool edge = x == 0 || y == 0 || x == WIDTH - 1u || y == HEIGHT - 1u;
                drawn += !is_ground(pictures[0] + p * 4u, 0);
                assert_true(!edge || is_ground(pictures[0] + p * 4u, 0));
            }
            /* The thinnest fish is an eel of 280 x 10 pixels, and even this fish covers more than
             * 500 pixels. */
            assert_true(drawn > 500u);
        }
    }
}

static void test_equal_specimens_give_equal_pictures_and_an_older_one_differs(void **state)
{
    (void)state;
    struct specimen fish = fish_of(&species_wakin, 0.5f);
    picture(pictures[0], &fish, 0.2f);
    picture(pictures[1], &fish, 0.2f);
    assert_memory_equal(pictures[0], pictures[1], SIZE);
    fish.progress = 0.52f;
    picture(pictures[1], &fish, 0.2f);
    assert_memory_not_equal(pictures[0], pictures[1], SIZE);
}

static void test_a_grown_goldfish_is_red_and_a_tint_covers_it(void **state)
{
    (void)state;
    struct specimen fish = fish_of(&species_wakin, 1.0f);
    picture(pictures[0], &fish, 0.0f);
    const uint8_t *pixel = pixel_at(pictures[0], &fish, v3(0.0f, 0.05f, -0.1f));
    assert_true(pixel[0] > 120 && pixel[0] > 2 * pixel[1] && pixel[0] > 2 * pixel[2]);
    fish.tint = 0x2040ffffu;
    picture(pictures[0], &fish, 0.0f);
    assert_true(pixel[2] > 120 && pixel[2] > pixel[0]);
}

/* A mature goldfish has the red and white pattern that the number `look` selects. A young goldfish
 * has the red colour of its species. */
static void test_a_mature_goldfish_has_its_pattern_and_a_young_one_its_coat(void **state)
{
    (void)state;
    struct specimen fish = fish_of(&species_wakin, 1.0f);
    const vec3 flank = v3(0.0f, 0.05f, -0.02f);
    fish.look = 1u << 31u | 15u << 8u; /* This pattern is white but for the tail and a cheek. */
    picture(pictures[0], &fish, 0.0f);
    const uint8_t *pixel = pixel_at(pictures[0], &fish, flank);
    assert_true(pixel[0] > 2 * pixel[1]); /* The fish is not mature yet, so it has the red colour of
                                             its species. */
    fish.ripe = fish.maturity = 1.0f;
    picture(pictures[0], &fish, 0.0f);
    assert_true(pixel[1] > 140 && pixel[2] > 120);
    fish.look = 0; /* The pattern number 0 is completely red. */
    picture(pictures[0], &fish, 0.0f);
    assert_true(pixel[0] > 2 * pixel[1]);
}

static void test_a_transparent_larva_shows_the_background_and_an_adult_does_not(void **state)
{
    (void)state;
    struct specimen fish = fish_of(&species_wakin, 0.0f);
    const vec3 flank = v3(0.0f, 0.0f, 0.05f);
    for (uint32_t adult = 0; adult < 2; adult++) {
        fish.progress = adult ? 1.0f : 0.0f;
        picture(pictures[0], &fish, 0.0f);
        picture(pictures[1], &fish, 1.0f);
        const int32_t through = (int32_t)pixel_at(pictures[1], &fish, flank)[1] -
                                (int32_t)pixel_at(pictures[0], &fish, flank)[1];
        print_message("%s: %d of 255 of the ground's light comes through\n",
                      adult ? "adult" : "larva", through);
        assert_true(adult ? through <= 3 : through > 40);
    }
}

static void test_a_faded_out_specimen_is_invisible(void **state)
{
    (void)state;
    struct specimen fish = fish_of(&species_wakin, 1.0f);
    fish.fade = 1.0f;
    fish.shadow = 1.0f;
    picture(pictures[0], &fish, 0.6f);
    for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) {
        assert_true(is_ground(pictures[0] + p * 4u, 153));
    }
}

static void test_a_specimen_is_drawn_over_any_previous_depth(void **state)
{
    (void)state;
    struct specimen fish = fish_of(&species_wakin, 1.0f);
    picture(pictures[0], &fish, 0.0f);
    gl_target_bind(&target);
    glClearDepthf(0.0f); /* A depth of 0 is in front of every fish, but the fish must be drawn all
                            the same. */
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glClearDepthf(1.0f);
    specimen_pass_draw(&pass, &fish, &whole);
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, pictures[1]);
    assert_memory_equal(pictures[0], pictures[1], SIZE);
}

static void test_a_species_reloaded_into_a_slot_looks_the_same(void **state)
{
    (void)state;
    straight_thesis(species_table[1], &memory, &changed);
    struct specimen fish = fish_of(&changed, 0.4f);
    picture(pictures[0], &fish, 0.3f);
    for (uint32_t i = 1; i <= SPECIMEN_OTHERS; i++) {
        struct specimen other = fish;
        other.edition = 100u + i;
        picture(pictures[1], &other, 0.3f);
    }
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        assert_true(pass.slots[i].species != &changed || pass.slots[i].edition != fish.edition);
    }
    picture(pictures[1], &fish, 0.3f);
    assert_memory_equal(pictures[0], pictures[1], SIZE);
}

static void test_a_changed_species_in_the_same_memory_is_repainted(void **state)
{
    (void)state;
    straight_thesis(species_table[1], &memory, &changed);
    struct specimen fish = fish_of(&changed, 1.0f);
    picture(pictures[0], &fish, 0.3f);
    straight_thesis(species_table[2], &memory, &changed);
    fish.edition = 1;
    picture(pictures[1], &fish, 0.3f);
    assert_memory_not_equal(pictures[0], pictures[1], SIZE);
    struct specimen straight = fish;
    straight.species = species_table[2];
    straight.edition = 0;
    straight.progress = (float)species_table[2]->card.thesis_key[2] /
                        (float)(species_table[2]->card.key_count - 1u);
    picture(pictures[0], &straight, 0.3f); /* At a key shape, the linear morph has the same shape as
                                              the species. */
    uint32_t off = 0;
    for (uint32_t i = 0; i < SIZE; i++) {
        const int32_t d = (int32_t)pictures[0][i] - (int32_t)pictures[1][i];
        off += d > 24 || d < -24;
    }
    print_message("%u of %u values differ by more than 24\n", off, SIZE);
    assert_true(off < SIZE / 200u);
}

/* Reads the texture of each key shape from the GPU. Compares each texel with paint_at(), which
 * computes the colours on the CPU. */
static void test_the_texture_of_a_key_matches_paint_at(void **state)
{
    (void)state;
    static uint8_t sheet[PAINT_SIZE * PAINT_SIZE][4];
    const struct species *const species = species_table[1];
    struct specimen fish = fish_of(species, 1.0f);
    picture(pictures[0], &fish, 0.0f);
    const struct fish_texture *skin = NULL;
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        skin = pass.slots[i].species == species ? &pass.slots[i].skin : skin;
    }
    assert_non_null(skin);
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    uint32_t off = 0, count = 0;
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        float weights[MORPH_KEY_MAX] = { 0.0f };
        weights[key] = 1.0f;
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, skin->paints, 0,
                                  (GLint)(key * skin->per_key));
        assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
        glReadPixels(0, 0, PAINT_SIZE, PAINT_SIZE, GL_RGBA, GL_UNSIGNED_BYTE, sheet);
        for (uint32_t i = 0; i < PAINT_SIZE * PAINT_SIZE; i++) {
            struct species_vertex at;
            const float x = (float)(i % PAINT_SIZE) + 0.5f, y = (float)(i / PAINT_SIZE) + 0.5f;
            if (!paint_atlas_at(x, y, &at)) {
                continue;
            }
            const struct paint paint = paint_at(species, weights, &at);
            const float red = (float)sheet[i][0] / 255.0f, clear = (float)sheet[i][3] / 255.0f;
            off += f_abs(red - paint.colour.x) > 0.004f || f_abs(clear - paint.clear) > 0.004f;
            count++;
        }
    }
    glDeleteFramebuffers(1, &framebuffer);
    print_message("%u of %u texels are means of four points\n", off, count);
    assert_true(off < count / 8u); /* A texel at the edge of a part is the mean of four points, so
                                      only such texels may differ. */
}

static uint32_t empty_slots(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < SPECIES_BUILT_IN; i++) {
        count += !pass.slots[i].species;
    }
    return count;
}

static void open_anew(void)
{
    specimen_pass_close(&pass);
    memset(&pass, 0, sizeof pass);
    specimen_pass_open(&status, &pass, &textures);
    assert_string_equal(status.text, "");
}

static void draw_only(const struct specimen *fish)
{
    gl_target_bind(&target);
    specimen_pass_draw(&pass, fish, &whole);
}

static uint32_t bands_painted(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        for (uint32_t sheet = 0; sheet < FISH_TEXTURE_SHEETS; sheet++) {
            count += pass.slots[i].skin.bands_done[sheet];
        }
    }
    return count;
}

static const struct fish_texture *skin_of(const struct species *species)
{
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        if (pass.slots[i].species == species) {
            return &pass.slots[i].skin;
        }
    }
    return NULL;
}

/* Draws a page with one large fish and a thumbnail of each key shape, as the lab does. */
static void draw_page(const struct species *species)
{
    const struct specimen fish = fish_of(species, 0.37f);
    struct specimen thumb = fish;
    thumb.length_px = 20.0f;
    draw_only(&fish);
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        thumb.progress = (float)key / (float)(species->card.key_count - 1u);
        draw_only(&thumb);
    }
}

/* Returns the number of texture bands that are painted until the large fish has its fine texture.
 * The bands of the last frame are not counted, because some of them may belong to other
 * textures. */
static uint32_t bands_to_fine(const struct species *species)
{
    draw_page(species);
    const uint32_t begun = bands_painted();
    uint32_t painted = begun;
    for (uint32_t frame = 0; frame < 1000 && !fish_texture_is_fine(skin_of(species)); frame++) {
        painted = bands_painted();
        specimen_pass_work(&pass, true);
        draw_page(species);
    }
    assert_true(fish_texture_is_fine(skin_of(species)));
    return painted - begun;
}

/* The large fish needs the two textures for its age. Until both are fine, the textures of other
 * key shapes must not be refined. */
static void test_the_visible_texture_is_refined_first(void **state)
{
    (void)state;
    uint32_t most = 0;
    open_anew();
    for (uint32_t i = 0; i < species_table_count; i++) {
        const uint32_t bands = bands_to_fine(species_table[i]);
        print_message("%s: %u bands\n", species_table[i]->card.id, bands);
        assert_true(bands < 2u * FISH_TEXTURE_BANDS);
        most = bands > most ? bands : most;
    }
    assert_true(most > FISH_TEXTURE_BANDS / 2u);
}

static void test_all_built_in_species_are_painted_in_idle_time(void **state)
{
    (void)state;
    open_anew();
    specimen_pass_work(&pass, false);
    assert_int_equal(empty_slots(), SPECIES_BUILT_IN);
    for (uint32_t frame = 0; frame < 20000 && empty_slots() > 0; frame++) {
        specimen_pass_work(&pass, true);
    }
    assert_int_equal(empty_slots(), 0);
    uint32_t done = 0;
    for (uint32_t frame = 0; frame < 20000 && done < SPECIES_BUILT_IN; frame++) {
        specimen_pass_work(&pass, true);
        done = 0;
        for (uint32_t i = 0; i < SPECIES_BUILT_IN; i++) {
            done += fish_texture_is_done(&pass.slots[i].skin);
        }
    }
    assert_int_equal(done, SPECIES_BUILT_IN);
}

static void test_the_ordinary_morph_has_the_texture_of_its_species(void **state)
{
    (void)state;
    struct specimen fish = fish_of(species_table[3], 0.5f);
    draw_only(&fish);
    straight_species(species_table[3], &memory, &changed);
    struct specimen rival = fish_of(&changed, 0.5f);
    rival.edition = 900;
    draw_only(&rival);
    const struct fish_texture *worn = NULL;
    for (uint32_t i = SPECIES_BUILT_IN; i < SPECIMEN_SLOTS; i++) {
        worn = pass.slots[i].edition == 900 ? pass.slots[i].worn : worn;
    }
    assert_ptr_equal(worn, &pass.slots[3].skin);
}

/* The coarse texture must be interpolated. Otherwise each of its samples would be visible as a
 * block. */
static void test_the_coarse_texture_shows_no_blocks(void **state)
{
    (void)state;
    static uint8_t sheet[PAINT_SIZE * PAINT_SIZE][4];
    const struct species *const species = species_table[1];
    open_anew();
    struct specimen fish = fish_of(species, 1.0f);
    draw_only(&fish);
    const struct fish_texture *const skin = &pass.slots[1].skin;
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, skin->paints, 0,
                              (GLint)(skin->sheet_count - 1u));
    glReadPixels(0, 0, PAINT_SIZE, PAINT_SIZE, GL_RGBA, GL_UNSIGNED_BYTE, sheet);
    glDeleteFramebuffers(1, &framebuffer);
    int32_t steepest = 0;
    for (uint32_t i = 0; i < PAINT_BODY_HEIGHT * PAINT_SIZE; i++) {
        const int32_t next = (int32_t)sheet[i % PAINT_SIZE < PAINT_SIZE - 1u ? i + 1u : i][0];
        const int32_t step = next - (int32_t)sheet[i][0];
        steepest = step > steepest ? step : -step > steepest ? -step : steepest;
    }
    print_message("steepest step from texel to texel: %d of 255\n", steepest);
    /* The coarse texture has a sample in every fourth texel. Interpolated texels therefore differ
     * from their neighbours by at most a quarter of 255. */
    assert_true(steepest <= 64);
}

/* The weights of a computed morph graph may be negative, and paint_at() treats negative weights as
 * 0. The selection of textures must do the same. */
static void test_a_negative_weight_selects_no_texture(void **state)
{
    (void)state;
    const float weights[MORPH_KEY_MAX] = { -0.2f, 1.0f, 0.0f, 0.2f };
    const float painted[MORPH_KEY_MAX] = { 0.0f, 1.0f, 0.0f, 0.2f };
    float sheets[2][3];
    struct fish_texture *const skin = &pass.slots[1].skin;
    assert_true(skin->species.card.key_count >= 4);
    fish_texture_request(skin, &pass.brush, weights, 100.0f, sheets[0]);
    fish_texture_request(skin, &pass.brush, painted, 100.0f, sheets[1]);
    for (uint32_t i = 0; i < 3; i++) {
        assert_float_equal(sheets[0][i], sheets[1][i], 1e-6f);
    }
}

/* A leptocephalus (larva of an eel) has 60 muscle lines on 0.9 of its length. At this size, a line
 * is 5 pixels wide and a texel 9 pixels. The lines must nevertheless be sharp. */
static void test_the_muscle_lines_of_a_leptocephalus_are_sharp(void **state)
{
    (void)state;
    const float length_px = 2400.0f;
    struct specimen fish = { .species = species_table[3], /* kuroanago */
                             .length_px = length_px,
                             .x_px = 0.5f * (float)WIDTH,
                             .y_px = 0.5f * (float)HEIGHT };
    picture(pictures[0], &fish, 0.0f);
    const uint8_t *const row = pictures[0] + HEIGHT / 2u * WIDTH * 4u;
    uint32_t lines = 0;
    for (uint32_t x = 2; x < WIDTH; x++) {
        const int32_t rise = (int32_t)row[x * 4u + 1u] - (int32_t)row[(x - 2u) * 4u + 1u];
        const int32_t before =
            (int32_t)row[(x - 1u) * 4u + 1u] - (int32_t)row[(x > 3u ? x - 3u : 0u) * 4u + 1u];
        lines += rise > 24 && before <= 24;
    }
    const float expected = (float)WIDTH / length_px * 60.0f / 0.9f;
    print_message("%u lines, %.1f expected\n", lines, (double)expected);
    /* The tolerance allows for the texture coordinate u, which is not exactly uniform along the
     * body. */
    assert_true(f_abs((float)lines - expected) <= 2.5f);
}

static void test_a_finished_texture_needs_no_more_work(void **state)
{
    (void)state;
    struct specimen fish = fish_of(&species_wakin, 1.0f);
    picture(pictures[0], &fish, 0.0f);
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        if (pass.slots[i].species == &species_wakin) {
            assert_int_equal(fish_texture_work(&pass.slots[i].skin, &pass.brush, 5), 5);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_species_is_drawn_inside_its_box_at_every_age),
        cmocka_unit_test(test_equal_specimens_give_equal_pictures_and_an_older_one_differs),
        cmocka_unit_test(test_a_grown_goldfish_is_red_and_a_tint_covers_it),
        cmocka_unit_test(test_a_mature_goldfish_has_its_pattern_and_a_young_one_its_coat),
        cmocka_unit_test(test_a_transparent_larva_shows_the_background_and_an_adult_does_not),
        cmocka_unit_test(test_a_faded_out_specimen_is_invisible),
        cmocka_unit_test(test_a_specimen_is_drawn_over_any_previous_depth),
        cmocka_unit_test(test_a_species_reloaded_into_a_slot_looks_the_same),
        cmocka_unit_test(test_a_changed_species_in_the_same_memory_is_repainted),
        cmocka_unit_test(test_the_texture_of_a_key_matches_paint_at),
        cmocka_unit_test(test_a_finished_texture_needs_no_more_work),
        cmocka_unit_test(test_the_muscle_lines_of_a_leptocephalus_are_sharp),
        cmocka_unit_test(test_the_visible_texture_is_refined_first),
        cmocka_unit_test(test_all_built_in_species_are_painted_in_idle_time),
        cmocka_unit_test(test_the_ordinary_morph_has_the_texture_of_its_species),
        cmocka_unit_test(test_the_coarse_texture_shows_no_blocks),
        cmocka_unit_test(test_a_negative_weight_selects_no_texture),
    };
    return cmocka_run_group_tests(tests, open_pass, close_pass);
}
