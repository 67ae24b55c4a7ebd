/* test_vision_bare.c -- checks that the bot uses nothing that the scene does not show. The test
 * overwrites all invisible members of the state, and the bot must still move identically. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/game_fields.h"
#include "core/base/hash.h"
#include "core/game/bot/bot.h"
#include "core/game/bot/vision.h"
#include "core/scene_helpers.h"
#include "core/tank/behavior/surface_breathing.h"
#include "tests/unit/support/bot_fixture.h"

/* Byte that overwrites the invisible members. As a float its bytes give 12, as an int 10^9, and as
 * a byte 65. */
#define NONSENSE 0x41

static struct bot_fixture fixture;
static struct core bare;
static struct scene scene, other_scene;

/* Starts a festival for two players. The second poi is held still over the water, and one player
 * holds a fan. */
static void begin(uint32_t seed)
{
    const struct core_config config = { .seed = seed, .players = 2 };
    bot_fixture_open(&fixture, &config, &technique_expert);
    fixture.input.poi[1] = (struct poi_input){ .link = POI_SOURCE_LIVE,
                                               .has_wrist = 1,
                                               .target.position_m = v3(0.2f, 0.1f, 0.1f) };
    fixture.input.shade[0] = (struct shade_input){ 1, -0.1f, 0.05f, 0.1f };
    bot_fixture_begin(&fixture);
}

/* Position of a struct member that the scene shows unchanged. */
struct member {
    size_t offset, size;
};
#define MEMBER(type, field) { offsetof(struct type, field), sizeof(((struct type *)0)->field) }
#define COUNT(list) (sizeof(list) / sizeof(list)[0])

static const struct member core_parts[] = {
    MEMBER(core, game.tick),
    MEMBER(core, config.modes),
    MEMBER(core, config.grade),
    MEMBER(core, config.round_s),
    MEMBER(core, game.phase),
    MEMBER(core, game.language),
    MEMBER(core, game.mode),
    MEMBER(core, game.lab_chosen),
    MEMBER(core, game.upright),
    MEMBER(core, game.bot_played),
    MEMBER(core, game.paused),
    MEMBER(core, game.call),
    MEMBER(core, game.call_tick),
    MEMBER(core, game.phase_tick),
    MEMBER(core, game.point_tick),
    MEMBER(core, game.round_s),
    MEMBER(core, game.accounts.ranking),
    MEMBER(core, game.hints.shown),
    MEMBER(core, world.tank.preset),
    MEMBER(core, world.tank.size_m),
    MEMBER(core, world.tank.wall_height_m),
    MEMBER(core, world.tank.oxygen.pump),
};

static const struct member player_parts[] = {
    MEMBER(player, plays), MEMBER(player, out),         MEMBER(player, fouls),
    MEMBER(player, foul),  MEMBER(player, foul_tick),   MEMBER(player, caught),
    MEMBER(player, level), MEMBER(player, has_pointer), MEMBER(player, pointer),
};

static const struct member fish_parts[] = {
    MEMBER(fish, position_m),     MEMBER(fish, angles),   MEMBER(fish, length_m),
    MEMBER(fish, tail_phase_rad), MEMBER(fish, bend_rad), MEMBER(fish, tail_amplitude),
    MEMBER(fish, age_days),       MEMBER(fish, look),
};

static const struct member poi_parts[] = {
    MEMBER(poi, position_m),        MEMBER(poi, angles),
    MEMBER(poi, sheet.radius_m),    MEMBER(poi, sheet.sag_m),
    MEMBER(poi, sheet.state),       MEMBER(poi, sheet.stress),
    MEMBER(poi, sheet.paper_cells), MEMBER(poi, sheet.paper_cells_new),
};

static const struct member bowl_parts[] = {
    MEMBER(bowl, present), MEMBER(bowl, position_m), MEMBER(bowl, heel_x),
    MEMBER(bowl, heel_z),  MEMBER(bowl, fish_count),
};

static const struct member shade_parts[] = {
    MEMBER(shade, cast.present),  MEMBER(shade, cast.x_m),  MEMBER(shade, cast.z_m),
    MEMBER(shade, cast.radius_m), MEMBER(shade, cast.dark),
};

static void keep(void *to, const void *from, const struct member *parts, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        memcpy((char *)to + parts[i].offset, (const char *)from + parts[i].offset, parts[i].size);
    }
}
#define KEEP(to, from, parts) keep(to, from, parts, COUNT(parts))

/* Copies only those parts of a fish's state that the scene shows: the members in fish_parts,
 * whether the fish gulps at the surface, and whether it is in the tank, on a poi or in a bowl. */
static void keep_fish(struct fish *fish, const struct fish *from)
{
    KEEP(fish, from, fish_parts);
    const int gulps = surface_breathes(from);
    const int swims = scene_place_of(from->gait) == SCENE_IN_TANK;
    fish->gait = gulps ? (uint8_t)GAIT_SURFACE : swims ? (uint8_t)GAIT_ESCAPE : from->gait;
    fish->air = gulps ? (uint8_t)AIR_GULPS : fish->air;
}

/* Copies only the visible state of a poi. The scene shows whether a player or a bot controls the
 * poi: the handle of a bot points to its place. The scene shows the water as a depth, and wetness
 * and damage in 255 steps. */
static void keep_poi(struct poi *poi, const struct poi *from)
{
    KEEP(poi, from, poi_parts);
    poi->link = from->link;
    poi->immersed = 0.0f;
    poi->water_kg = (1.0f - from->immersed) * from->water_kg;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        const float wet = (float)scene_wetness(&from->sheet, i);
        const float whole = (float)scene_integrity(&from->sheet, i) - 1.0f;
        poi->sheet.wetness[i] = f_min((wet + 0.5f) / 255.0f, 1.0f);
        poi->sheet.damage[i] = 1.0f - f_min((whole + 0.5f) / 254.0f, 1.0f);
    }
    /* The scene shows how strongly each fish on the paper thrashes, and to which side. */
    poi->carried_count = from->carried_count;
    for (uint32_t i = 0; i < from->carried_count; i++) {
        poi->carried_fish[i].fish = from->carried_fish[i].fish;
        poi->carried_fish[i].side = from->carried_fish[i].side;
        poi->carried_fish[i].vigour = from->carried_fish[i].vigour;
    }
}

/* Copies only the visible state of a bowl. The scene shows the bowl's water and its fish together
 * as one level. */
static void keep_bowl(struct bowl *bowl, const struct bowl *from)
{
    KEEP(bowl, from, bowl_parts);
    /* The hand that holds the poi shows on which side of the tank the bowl is moored. */
    bowl->home_m.x = from->home_m.x < 0.0f ? -1.0f : 1.0f;
    bowl->home_m.z = from->home_m.z < 0.0f ? -1.0f : 1.0f;
    bowl->water_kg = from->water_kg + from->fish_kg;
    bowl->fish_kg = 0.0f;
}

static void keep_tank(struct tank *tank, const struct tank *from)
{
    const uint32_t newest = from->water.newest;
    tank->fish_count = from->fish_count;
    for (uint32_t i = 0; i < from->fish_count; i++) {
        keep_fish(&tank->fish[i], &from->fish[i]);
    }
    for (uint32_t i = 0; i < TANK_SHADE_MAX; i++) {
        KEEP(&tank->shade[i], &from->shade[i], shade_parts);
    }
    tank->water.newest = (uint8_t)newest;
    memcpy(tank->water.height_m[newest], from->water.height_m[newest],
           sizeof from->water.height_m[newest]);
}

/* Makes a reduced copy of the core. Members that a bot may see are copied, and all other members
 * are filled with NONSENSE. */
static void bare_of(struct core *core, const struct core *from)
{
    memset(core, NONSENSE, sizeof *core);
    KEEP(core, from, core_parts);
    core->game.album.fish_count = 0; /* No present falls into a bowl before the first result. */
    keep_tank(&core->world.tank, &from->world.tank);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        KEEP(&core->game.player[i], &from->game.player[i], player_parts);
        keep_poi(&core->world.poi[i], &from->world.poi[i]);
        keep_bowl(&core->world.bowl[i], &from->world.bowl[i]);
    }
}

/* Compares one member of the scenes of the complete and the reduced state. Structs with padding
 * must be compared member by member instead. */
#define SAME_SCENE(field) (memcmp(&scene.field, &other_scene.field, sizeof scene.field) == 0)

static int bowls_and_fans_are_equal(void)
{
    int same = 1;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        same = same && SAME_SCENE(bowl[i].present) && SAME_SCENE(bowl[i].position_m) &&
               SAME_SCENE(bowl[i].angles) && SAME_SCENE(bowl[i].water_below_m) &&
               SAME_SCENE(bowl[i].fish_count);
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        same = same && SAME_SCENE(fan[i].present) && SAME_SCENE(fan[i].x_m) &&
               SAME_SCENE(fan[i].z_m) && SAME_SCENE(fan[i].radius_m) && SAME_SCENE(fan[i].dark);
    }
    return same;
}

static int players_are_equal(void)
{
    int same = 1;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        same = same && SAME_SCENE(player[i].plays) && SAME_SCENE(player[i].lost) &&
               SAME_SCENE(player[i].fouls) && SAME_SCENE(player[i].foul) &&
               SAME_SCENE(player[i].foul_s) && SAME_SCENE(player[i].out) &&
               SAME_SCENE(player[i].level) && SAME_SCENE(player[i].has_pointer) &&
               SAME_SCENE(player[i].x) && SAME_SCENE(player[i].y);
    }
    return same;
}

static int games_are_equal(void)
{
    return SAME_SCENE(phase) && SAME_SCENE(language) && SAME_SCENE(hint) && SAME_SCENE(phase_s) &&
           SAME_SCENE(seconds_left) && SAME_SCENE(caught) && SAME_SCENE(best_today) &&
           SAME_SCENE(by_bot) && SAME_SCENE(mode) && SAME_SCENE(modes) && SAME_SCENE(grade) &&
           SAME_SCENE(choice) && SAME_SCENE(tags) && SAME_SCENE(pointed_tags) &&
           SAME_SCENE(upright) && SAME_SCENE(paused) && SAME_SCENE(call) && SAME_SCENE(call_s) &&
           SAME_SCENE(offer);
}

static int scenes_are_equal(const struct core *core, const struct core *other)
{
    memset(&scene, 0, sizeof scene);
    memset(&other_scene, 0, sizeof other_scene);
    core_scene(core, &scene);
    core_scene(other, &other_scene);
    return SAME_SCENE(tick) && SAME_SCENE(view) && SAME_SCENE(tank_size_m) &&
           SAME_SCENE(wall_height_m) && SAME_SCENE(fish_count) && SAME_SCENE(fish) &&
           SAME_SCENE(poi) && SAME_SCENE(slope) && SAME_SCENE(pump.present) &&
           SAME_SCENE(pump.runs) && bowls_and_fans_are_equal() && players_are_equal() &&
           games_are_equal();
}

static void test_a_reduced_state_gives_the_same_scene(void **state)
{
    (void)state;
    begin(8);
    for (uint32_t i = 0; i < 20u * CORE_TICK_HZ; i++) {
        bot_fixture_tick(&fixture);
        if (i % 50u == 0) {
            bare_of(&bare, &fixture.core);
            assert_true(scenes_are_equal(&fixture.core, &bare));
        }
    }
}

/* Changes a member so much that the scene must change. Flips bit 22 of each 4-byte value, or bit 0
 * of the first byte if the size is not a multiple of 4. A second call restores the member. */
static void change(void *of, const struct member *part)
{
    unsigned char *const at = (unsigned char *)of + part->offset;
    if (part->size % 4u == 0) {
        for (size_t i = 2; i < part->size; i += 4u) {
            at[i] ^= 0x40u;
        }
    } else {
        at[0] ^= 1u;
    }
}

/* Changes one member of the reduced state. Returns 1 if the scene changes. */
static int shows(void *of, const struct member *part)
{
    change(of, part);
    const int shown = !scenes_are_equal(&fixture.core, &bare);
    change(of, part);
    return shown;
}

static void each_shows(void *of, const struct member *parts, size_t count, uint32_t *seen)
{
    for (size_t i = 0; i < count; i++) {
        *seen |= (uint32_t)shows(of, &parts[i]) << i;
    }
}
#define EACH_SHOWS(of, parts, seen) each_shows(of, parts, COUNT(parts), seen)
#define ALL_OF(parts) ((1u << COUNT(parts)) - 1u)

/* Each member that is copied into the reduced state must be visible. Otherwise the bot would get
 * data that a player does not see. */
static void test_every_kept_member_of_a_reduced_state_changes_the_scene(void **state)
{
    (void)state;
    static const uint8_t phases[] = { PHASE_ROUND, PHASE_MODE_SELECT };
    uint32_t core = 0, player = 0, fish = 0, poi = 0, bowl = 0, shade = 0;
    begin(8);
    /* The colour of a fish depends on its age only in a certain range, and this age is in that
     * range. */
    fixture.core.world.tank.fish[3].age_days = 80.0f;
    fixture.core.config.modes = 1u << MODE_FESTIVAL | 1u << MODE_PRACTICE;
    /* Raises the number of cells of new paper, because change() increases the number of cells, and
     * the sheet asserts that it has no more cells than when it was new. */
    fixture.core.world.poi[0].sheet.paper_cells_new = 0x7f0000u;
    for (size_t i = 0; i < sizeof phases; i++) {
        fixture.core.game.phase = phases[i];
        bare_of(&bare, &fixture.core);
        assert_true(scenes_are_equal(&fixture.core, &bare));
        EACH_SHOWS(&bare, core_parts, &core);
        EACH_SHOWS(&bare.game.player[0], player_parts, &player);
        EACH_SHOWS(&bare.world.tank.fish[3], fish_parts, &fish);
        EACH_SHOWS(&bare.world.poi[0], poi_parts, &poi);
        EACH_SHOWS(&bare.world.bowl[0], bowl_parts, &bowl);
        EACH_SHOWS(&bare.world.tank.shade[0], shade_parts, &shade);
    }
    assert_int_equal(core, ALL_OF(core_parts));
    assert_int_equal(player, ALL_OF(player_parts));
    assert_int_equal(fish, ALL_OF(fish_parts));
    assert_int_equal(poi, ALL_OF(poi_parts));
    assert_int_equal(bowl, ALL_OF(bowl_parts));
    assert_int_equal(shade, ALL_OF(shade_parts));
}

static void test_a_bot_moves_identically_with_a_reduced_state(void **state)
{
    (void)state;
    static struct bot twin;
    begin(8);
    for (uint32_t i = 0; i < 12u * CORE_TICK_HZ; i++) {
        twin = fixture.bot;
        bare_of(&bare, &fixture.core);
        const struct vision sight = { &bare.game, &bare.world, 0 };
        const struct poi_target blind = bot_tick(&twin, &sight);
        bot_fixture_tick(&fixture);
        assert_memory_equal(&blind, &fixture.input.poi[0].target, sizeof blind);
        assert_true(field_hash(HASH_START, &bot_fields, &twin) ==
                    field_hash(HASH_START, &bot_fields, &fixture.bot));
    }
    assert_true(fixture.core.world.poi[0].dips > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_reduced_state_gives_the_same_scene),
        cmocka_unit_test(test_every_kept_member_of_a_reduced_state_changes_the_scene),
        cmocka_unit_test(test_a_bot_moves_identically_with_a_reduced_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
