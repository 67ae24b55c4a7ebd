/* hour.c -- generates the random inputs of many players at one kiosk during a simulated hour. */
#include "tests/power/hour.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/fmath.h"
#include "core/base/rng.h"
#include "core/game/accounting/accounts.h"
#include "core/game/phases.h"
#include "platform/cpu.h"
#include "tests/power/tape.h"
#include "tests/unit/support/newest_record.h"

/* Length of a round in seconds. Rounds are short so that many of them are played. */
#define ROUND_S 20u
#define TICKS_A_FRAME 2u

enum {
    DRAW_COIN = 1,
    DRAW_COINS,
    DRAW_SERVICE,
    DRAW_START,
    DRAW_FISH,
    DRAW_VOLUME,
    DRAW_RESET,
    DRAW_EDIT
};

int hour_open(struct hour *hour, uint32_t seed, struct hal_storage store)
{
    cpu_set_float();
    memset(hour, 0, sizeof *hour);
    hour->seed = seed;
    struct core_config config = { .seed = seed };
    store.ledger.ops->load(store.ledger.self, &config.persistent);
    settings_reset(&config.persistent.settings);
    config.persistent.settings.value[SET_PLAY] = PLAY_PAID;
    config.persistent.settings.value[SET_PRICE] = 2;
    config.persistent.settings.value[SET_MODES] = 1 << MODE_FESTIVAL;
    config.persistent.settings.value[SET_ROUND_S] = (int32_t)ROUND_S;
    /* There is only one fish, because these tests do not examine how fish swim. */
    config.persistent.settings.value[SET_FISH] = 1;
    config.persistent.settings.value[SET_TICKET_FISH] = 1;
    config_apply_settings(&config, &config.persistent.settings);
    hour->kept_id = hour->acked_id = config.persistent.ledger.last_id;
    hour->output.entry_id = hour->kept_id;
    return core_init(&hour->core, &config) == CORE_OK ? 0 : -1;
}

static uint32_t draw(const struct hour *hour, uint32_t what)
{
    return rng_u32((struct rng_key){ hour->seed, hour->core.game.tick, what, RNG_TEST });
}

/* Returns 1 at random, on average once in `seconds` seconds of game time. */
static int happens(const struct hour *hour, uint32_t what, uint32_t seconds)
{
    const uint32_t ticks = seconds * CORE_TICK_HZ / (hour->haste ? hour->haste : 1u);
    return draw(hour, what) % (ticks ? ticks : 1u) == 0;
}

/* Moves the poi in a circle above the water, as a sign that a player is present. */
static void move_poi(struct hour *hour)
{
    const float turn = 0.01f * (float)(hour->core.game.tick % 6283u);
    hour->input.poi[0] = (struct poi_input){
        .link = POI_SOURCE_LIVE,
        .has_wrist = 1,
        .target.position_m = v3(0.15f * f_cos(turn), 0.06f, 0.1f * f_sin(turn)),
    };
}

static void run_trial(struct hour *hour)
{
    struct input *input = &hour->input;
    input->pressed = 0;
    memset(input->coin_count, 0, sizeof input->coin_count);
    /* The simulated hour covers four calendar days: one for every 15 minutes. */
    input->day = (uint16_t)(9800u + hour->core.game.tick / (900u * CORE_TICK_HZ));
    input->minute = (uint16_t)(hour->core.game.tick / CORE_TICK_HZ % 1440u);
    if (happens(hour, DRAW_COIN, 9) && !hour->output.coin_lockout) {
        input->coin_count[0] = 1u + draw(hour, DRAW_COINS) % 3u;
        hour->coins += input->coin_count[0];
    }
    if (happens(hour, DRAW_SERVICE, 120)) {
        input->pressed |= INPUT_SERVICE;
        hour->services++;
    }
    if (happens(hour, DRAW_START, 2)) {
        input->pressed |= INPUT_START;
    }
    move_poi(hour);
}

static void land_fish(struct hour *hour)
{
    if (hour->core.game.phase == PHASE_ROUND && happens(hour, DRAW_FISH, 4)) {
        const struct catch_result caught[POI_MAX] = { { .landed = 1, .bowled = 1 } };
        game_score(hour->core.game.player, &hour->core.game.album, &hour->core.game,
                   &hour->core.world, caught, false, &hour->output);
    }
}

/* Writes the ledger entry of a changed volume. The operator's menu would write the same entry, but
 * is not opened. */
static void turn_volume(struct hour *hour)
{
    const int32_t value = 5 * (int32_t)(draw(hour, DRAW_VOLUME) / 7919u % 21u);
    const struct ledger_entry entry = { .kind = LEDGER_SETTING,
                                        .detail = SET_VOLUME,
                                        .value = value };
    if (ledger_write(&hour->core.game.accounts, hour->core.game.tick, &entry, &hour->output) != 0) {
        hour->core.config.persistent.settings.value[SET_VOLUME] = value;
    }
}

static void give_name(struct hour *hour)
{
    static const char *const names[] = { "きんぎょ", "KINGYO", "たろう", "HANA" };
    struct ledger_entry entry = { .kind = LEDGER_NAME, .detail = 0, .count = hour->named_id };
    snprintf(entry.name, sizeof entry.name, "%s", names[hour->named_id % 4u]);
    ledger_write(&hour->core.game.accounts, hour->core.game.tick, &entry, &hour->output);
}

static void write_ledger(struct hour *hour)
{
    const uint32_t round_id = newest_record(&hour->output)->id;
    if (happens(hour, DRAW_VOLUME, 100)) {
        turn_volume(hour);
    }
    if (happens(hour, DRAW_RESET, 600)) {
        const struct ledger_entry entry = { .kind = LEDGER_RESET, .detail = AUDIT_GROUP_MACHINE };
        ledger_write(&hour->core.game.accounts, hour->core.game.tick, &entry, &hour->output);
    }
    if (round_id != hour->named_id) {
        hour->named_id = round_id;
        give_name(hour);
    }
}

/* ---- Passing data to the store -------------------------------------------------------------- */

size_t hour_replay(uint32_t round_id, uint8_t out[HOUR_REPLAY_MAX])
{
    const size_t size = 1000u + round_id * 379u % (HOUR_REPLAY_MAX - 1000u);
    for (size_t i = 0; i < size; i++) {
        out[i] = (uint8_t)(round_id * 31u + i * i * 7u + i / 251u);
    }
    return size;
}

static void note(struct hour *hour, const struct ledger_entry *entry)
{
    if (entry->id >= HOUR_ENTRIES_MAX) {
        fprintf(stderr, "power: more than %u entries in an hour\n", HOUR_ENTRIES_MAX);
        abort();
    }
    hour->entries[entry->id] = *entry;
    hour->rounds += entry->kind == LEDGER_ROUND;
    if (entry->kind == LEDGER_ROUND && !entry->round.unscored &&
        ranking_place(&hour->core.game.accounts.ranking, entry->round.mode, RANK_DAY, entry->id,
                      0) < RANK_ROWS) {
        hour->replay_id = entry->id;
    }
}

/* Simulates the ticket dispenser. In the tick in which a pulse begins, a mark is recorded on the
 * tape. After a power cut, each mark thus stands for a pulse that has really begun. */
static void dispense(struct hour *hour, uint32_t requested_before)
{
    hour->pulse_ticks -= hour->pulse_ticks > 0;
    if (hour->output.tickets != requested_before) {
        hour->pulse_ticks = HOUR_PULSE_TICKS;
        tape_mark(TAPE_TICKET, hour->output.tickets);
    }
    hour->input.tickets_done = hour->output.tickets - (hour->pulse_ticks > 0);
}

static void pass_to_store(struct hour *hour, struct hal_storage store)
{
    while (hour->kept_id != hour->output.entry_id) {
        const struct ledger_entry *entry =
            &hour->output.entries[(hour->kept_id + 1u) % LEDGER_RING];
        tape_mark(TAPE_KEPT, entry->id);
        if (store.ledger.ops->append(store.ledger.self, entry) != HAL_OK) {
            return;
        }
        note(hour, entry);
        hour->kept_id++;
    }
}

/* Passes the newest replay to the store. The thread of the store reads from the buffer, so the
 * buffer must not change before the store has stored the previous replay. */
static void pass_replay(struct hour *hour, struct hal_storage store)
{
    const int is_buffer_free = hour->replay_acked_id == hour->replay_taken_id;
    if (hour->replay_id != 0 && hour->replay_id != hour->replay_taken_id && is_buffer_free) {
        const size_t size = hour_replay(hour->replay_id, hour->replay);
        if (store.replays.ops->store(store.replays.self, hour->replay_id, hour->replay, size) ==
            HAL_OK) {
            hour->replay_taken_id = hour->replay_id;
        }
    }
}

struct graph_edit_record hour_edit(uint32_t number)
{
    struct graph_edit_record edit = { .id = number, .key_count = 1, .species = "wakin" };
    edit.edit.graph.knot_count = 2;
    edit.edit.graph.knots[1].progress = 1.0f;
    edit.edit.graph.knots[1].weight[0] = (float)number;
    return edit;
}

/* Stores an edited morph graph at random times, on average once in `edit_each_s` seconds. The test
 * numbers all graphs of its run from 1. The store numbers its graphs from 1 after each opening, so
 * `edit_first` is the difference. */
static void save_graph(struct hour *hour, struct hal_storage store)
{
    if (hour->edit_each_s > 0 && draw(hour, DRAW_EDIT) % (hour->edit_each_s * 60u) == 0) {
        struct graph_edit_record edit = hour_edit(hour->edit_number + 1u);
        edit.id -= hour->edit_first;
        tape_mark(TAPE_EDIT_KEPT, hour->edit_number + 1u);
        hour->edit_number += store.edits.ops->store(store.edits.self, &edit) == HAL_OK;
    }
}

static void ask(struct hour *hour, struct hal_storage store)
{
    const uint32_t saved_id = store.ledger.ops->committed_id(store.ledger.self);
    if (saved_id > hour->acked_id) {
        hour->acked_id = saved_id;
        tape_mark(TAPE_ACKED, saved_id);
    }
    const uint32_t replay_id = store.replays.ops->stored_id(store.replays.self);
    if (replay_id != hour->replay_acked_id) {
        hour->replay_acked_id = replay_id;
        tape_mark(TAPE_REPLAY_ACKED, replay_id);
    }
    const uint32_t edit = hour->edit_first + store.edits.ops->stored_id(store.edits.self);
    if (hour->edit_each_s > 0 && edit > hour->edit_acked) {
        hour->edit_acked = edit;
        tape_mark(TAPE_EDIT_ACKED, edit);
    }
    hour->input.record_saved_id = hour->acked_id;
    hour->input.store_well = store.ledger.ops->is_healthy(store.ledger.self);
}

void hour_frame(struct hour *hour, struct hal_storage store)
{
    ask(hour, store);
    hour->output.sound_count = 0;
    for (uint32_t i = 0; i < TICKS_A_FRAME; i++) {
        const uint32_t requested = hour->output.tickets;
        run_trial(hour);
        if (core_tick(&hour->core, &hour->input, &hour->output) != CORE_OK) {
            fputs("power: " CPU_FLOAT_WRONG "\n", stderr);
            exit(70);
        }
        dispense(hour, requested);
        land_fish(hour);
        write_ledger(hour);
    }
    pass_to_store(hour, store);
    pass_replay(hour, store);
    save_graph(hour, store);
}
