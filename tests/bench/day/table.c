/* table.c -- the kiosk of a simulated day. */
#include "tests/bench/day/table.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/game/phases.h"
#include "core/tank/preset.h"
#include "drivers/null.h"
#include "platform/cpu.h"

/* START is pressed once per second until a round begins. */
#define START_FRAMES PLAYER_HZ
/* Longest time in seconds from the coin to the end of a round, without the length of the round
 * itself. */
#define ROUND_RESERVE_S 60u
/* Longest time in seconds for which the kiosk is simulated while nobody plays. In this time the
 * pump restores the oxygen of the water, so that more time would hardly change the next round. */
#define IDLE_S_MAX 10.0

/* ---- Frames ---------------------------------------------------------------------------------- */

/* Runs one frame of the kiosk. `pressed` is the set of pressed buttons and `coins` the number of
 * coins of this frame. */
static bool run_frame(struct table *table, uint32_t pressed, uint32_t coins)
{
    struct kiosk *kiosk = &table->kiosk;
    for (uint32_t i = 0; i < table->bowls; i++) {
        person_act(&table->persons[i]);
    }
    table->clock.now_ns = table->persons[0].clock.now_ns;
    kiosk->input.pressed = pressed;
    kiosk->input.coin_count[0] = coins;
    if (kiosk_frame(kiosk, &table->hal) != KIOSK_RUNS) {
        return false;
    }
    for (uint32_t i = 0; i < table->bowls; i++) {
        if (table->is_held[i]) {
            person_see(&table->persons[i], &kiosk->scene);
        }
    }
    return true;
}

static bool run_seconds(struct table *table, double seconds)
{
    const uint32_t frames = (uint32_t)(seconds * PLAYER_HZ + 0.5);
    for (uint32_t i = 0; i < frames; i++) {
        if (!run_frame(table, 0, 0)) {
            return false;
        }
    }
    return true;
}

static double now_s(const struct table *table)
{
    return (double)table->clock.now_ns * 1e-9;
}

/* ---- People ---------------------------------------------------------------------------------- */

static const struct habits *habits_of(const struct visitor *visitor)
{
    const char *name = visitor_kinds[visitor->kind].habits;
    uint32_t row = 0;
    while (row < sim_player_table_count && strcmp(sim_player_table[row].name, name) != 0) {
        row++;
    }
    CORE_ASSERT(row < sim_player_table_count);
    return &sim_player_table[row];
}

/* Puts the controller of a bowl into the hand of `visitor`. If `visitor` is null, the controller
 * rests over the bowl. */
static void place_visitor(struct table *table, uint32_t slot, const struct visitor *visitor)
{
    const struct tank_preset *preset = tank_preset(TANK_PRESET_FESTIVAL);
    struct person *person = &table->persons[slot];
    const uint64_t now_ns = table->clock.now_ns;
    const struct habits *habits = visitor ? habits_of(visitor) : &sim_player_table[0];
    const uint32_t seed =
        visitor ? rng_u32((struct rng_key){ visitor->seed, visitor->plays, slot, RNG_TEST }) : 0u;
    person_init(person, habits, &preset->view, slot, seed, now_ns);
    struct device *device = &person->device;
    sim_player_to_screen(&preset->view, preset->bowl_m[slot], &device->x_px, &device->y_px);
    person->command.x_px = device->x_px;
    person->command.y_px = device->y_px;
    table->is_held[slot] = visitor != NULL;
    table->hal.poi[slot] = person_poi(person);
}

/* ---- Rounds ---------------------------------------------------------------------------------- */

/* Inserts the coins and presses START until the phase READY begins. Returns false if no round
 * begins. */
static bool start_round(struct table *table)
{
    const uint8_t *phase = &table->kiosk.core.game.phase;
    uint32_t coins = table->price;
    for (uint32_t i = 0; i < ROUND_RESERVE_S * PLAYER_HZ; i++) {
        const uint32_t pressed = i % START_FRAMES == START_FRAMES / 2u ? INPUT_START : 0;
        if (!run_frame(table, pressed, coins)) {
            return false;
        }
        coins = 0;
        if (*phase == PHASE_READY) {
            return true;
        }
    }
    return false;
}

/* Runs the kiosk from the phase READY through the round to the result screen. */
static bool run_round(struct table *table)
{
    const struct core *core = &table->kiosk.core;
    const uint32_t frames = (core->game.round_s + ROUND_RESERVE_S) * PLAYER_HZ;
    for (uint32_t i = 0; i < frames; i++) {
        if (!run_frame(table, 0, 0)) {
            return false;
        }
        if (core->game.phase == PHASE_RESULT) {
            return true;
        }
    }
    return false;
}

static bool play(void *self, const struct visitor *const *group, uint32_t count, uint8_t level,
                 struct day_round *out)
{
    struct table *table = self;
    CORE_ASSERT(count > 0 && count <= table->bowls);
    const double begin_s = now_s(table);
    for (uint32_t i = 0; i < table->bowls; i++) {
        place_visitor(table, i, i < count ? group[i] : NULL);
    }
    table->kiosk.core.config.level = level;
    if (!run_seconds(table, DAY_CHANGE_S) || !start_round(table) || !run_round(table)) {
        return false;
    }
    for (uint32_t i = 0; i < count; i++) {
        out->caught[i] = table->kiosk.core.game.player[i].caught;
    }
    const bool is_played = run_seconds(table, DAY_RESULT_S);
    out->took_s = now_s(table) - begin_s;
    return is_played;
}

static bool idle(void *self, double seconds)
{
    struct table *table = self;
    for (uint32_t i = 0; i < table->bowls; i++) {
        place_visitor(table, i, NULL);
    }
    return run_seconds(table, seconds < IDLE_S_MAX ? seconds : IDLE_S_MAX);
}

/* ---- Interface ------------------------------------------------------------------------------- */

bool table_open(struct table *table, const struct day_options *options)
{
    *table = (struct table){ .bowls = options->bowls, .price = options->price };
    struct kiosk_config config = { .core = { .seed = options->seed,
                                             .preset = TANK_PRESET_FESTIVAL,
                                             .lanes = cpu_lanes(),
                                             .persistent.ledger.boots = 1 } };
    struct settings *settings = &config.core.persistent.settings;
    settings_reset(settings);
    settings->value[SET_PLAY] = options->price > 0 ? PLAY_PAID : PLAY_FREE;
    settings->value[SET_PRICE] = options->price > 0 ? (int32_t)options->price : 1;
    settings->value[SET_MODES] = 1 << MODE_FESTIVAL;
    settings->value[SET_ROUND_S] = (int32_t)options->round_s;
    settings->value[SET_PLAYERS] = (int32_t)options->bowls;
    settings->value[SET_NAMES] = 0;
    config_apply_settings(&config.core, settings);
    config.core.level = options->level;
    table->hal = null_hal(NULL);
    table->hal.clock = config.stopwatch = sim_clock_device(&table->clock);
    table->hal.storage = storage_sim_device(&table->store);
    for (uint32_t i = 0; i < table->bowls; i++) {
        place_visitor(table, i, NULL);
    }
    return kiosk_init(&table->kiosk, &table->hal, &config) == CORE_OK;
}

struct day_kiosk table_kiosk(struct table *table)
{
    return (struct day_kiosk){ .play = play, .idle = idle, .self = table };
}

struct day_money table_money(const struct table *table)
{
    const uint32_t *count = table->kiosk.core.game.accounts.audits.count;
    return (struct day_money){
        .units = count[AUDIT_UNITS],
        .paid_plays = count[AUDIT_PLAYS_PAID],
        .free_plays = count[AUDIT_PLAYS_FREE],
        .caught = count[AUDIT_CAUGHT],
        .refunds = count[AUDIT_REFUNDS],
    };
}
