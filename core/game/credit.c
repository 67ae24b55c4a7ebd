/* credit.c -- from coins to rounds. */
#include "core/game/credit.h"

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/core.h"

#define NEVER_S 1e6f /* Eleven days. */

/* A coin may be the last of a credit, and one of many that fell in one tick: no loop. What finds no
 * room waits as coins. */
static void change_coins(struct credit *credit, uint32_t price)
{
    const uint32_t room = credit->credits < CREDIT_MAX ? CREDIT_MAX - credit->credits : 0u;
    const uint32_t bought = credit->coins / price < room ? credit->coins / price : room;
    credit->credits += bought;
    credit->coins -= bought * price;
}

static void take_coins(struct core *core, uint32_t count, struct output *output)
{
    struct credit *credit = &core->game.credit;
    credit->metered += count;
    credit->coin_tick = core->tick;
    if (core->config.credit_coins > 0) { /* Else the box has one more, and nobody owes for it. */
        credit->coins += count;
        output_sound(output, SOUND_COIN, 0.9f, 0.0f);
    }
}

static void take_service(struct core *core, struct output *output)
{
    struct credit *credit = &core->game.credit;
    if (core->config.credit_coins > 0 && credit->credits < CREDIT_MAX) {
        credit->credits++;
        credit->services++;
        output_sound(output, SOUND_COIN, 0.5f, 0.0f);
    }
}

static void note_coins(struct core *core, uint32_t count, struct output *output)
{
    if (menu_tries_lines(core)) {
        core->game.credit.metered += count; /* A test, but it is in the box. */
    } else if (count > 0) {
        take_coins(core, count, output);
    }
}

/* Whether somebody could play: a seat with a controller that is there, or the bot's. */
static int has_poi(const struct core *core, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t link = input->poi[i].link;
        if (core->bowl[i].present && (link == POI_LINK_LIVE || link == POI_LINK_BOT)) {
            return 1;
        }
    }
    return 0;
}

static void note_tilt(struct core *core, const struct input *input, struct output *output)
{
    struct credit *credit = &core->game.credit;
    if (!((input->held | input->pressed) & INPUT_TILT)) {
        return;
    }
    if (!(credit->warnings & WARN_TILT)) {
        credit->tilts++;
        output_sound(output, SOUND_FOUL, 0.8f, 0.0f);
    }
    credit->tilt_tick = core->tick;
}

static uint8_t warnings(const struct core *core, const struct input *input)
{
    const struct credit *credit = &core->game.credit;
    const int is_tilted =
        credit->tilt_tick != 0 && core->tick - credit->tilt_tick < CREDIT_TILT_TICKS;
    const int is_open = ((input->held | input->pressed) & INPUT_DOOR) != 0;
    return (uint8_t)((is_tilted ? (uint32_t)WARN_TILT : 0u) |
                     (is_open ? (uint32_t)WARN_DOOR : 0u) |
                     (has_poi(core, input) ? 0u : (uint32_t)WARN_NO_POI));
}

void credit_tick(struct core *core, const struct input *input, struct output *output)
{
    struct credit *credit = &core->game.credit;
    note_coins(core, input->coin_count[0], output);
    if (core->game.phase != PHASE_MENU) {
        note_tilt(core, input, output);
        if (input->pressed & INPUT_SERVICE) {
            take_service(core, output);
        }
    }
    if (core->config.credit_coins > 0) {
        change_coins(credit, core->config.credit_coins);
    }
    credit->warnings = warnings(core, input);
}

/* In the menu the slot is open on one page alone: where the operator drops coins to see them
 * counted. A guest would not know that nothing is sold just then. */
static int sends_coins_back(const struct core *core)
{
    const struct credit *credit = &core->game.credit;
    if (core->game.phase == PHASE_MENU) {
        return !menu_tries_lines(core);
    }
    return core->config.credit_coins == 0 || credit->credits >= CREDIT_MAX ||
           credit->warnings != 0;
}

void credit_show_outputs(const struct core *core, struct output *output)
{
    output->coin_lockout = (uint8_t)sends_coins_back(core);
    output->coins_counted = core->game.credit.metered;
    output->tickets = core->game.credit.tickets;
}

int credit_can_play(const struct core *core)
{
    return core->config.credit_coins == 0 || core->game.credit.credits > 0;
}

void credit_ask(struct core *core)
{
    core->game.credit.asked_tick = core->tick;
}

void credit_take(struct core *core)
{
    struct credit *credit = &core->game.credit;
    CORE_ASSERT(credit_can_play(core));
    credit->is_paid = core->config.credit_coins > 0;
    credit->came_back = 0;
    credit->credits -= credit->is_paid;
}

/* There may be more than CREDIT_MAX now, by the one that was taken: it is a person's. */
void credit_give_back(struct core *core)
{
    struct credit *credit = &core->game.credit;
    credit->came_back = credit->is_paid;
    credit->credits += credit->is_paid;
    credit->refunds += credit->is_paid;
    credit->is_paid = 0;
}

void credit_hand_out_tickets(struct core *core)
{
    const struct game *game = &core->game;
    const uint32_t price = core->config.ticket_fish;
    if (price == 0 || game->bot_played || !rules_of(game->mode)->keeps_score) {
        return;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        core->game.credit.tickets += game->player[i].plays ? game->player[i].caught / price : 0u;
    }
}

static float since_s(const struct core *core, uint32_t tick)
{
    return tick != 0 ? (float)(core->tick - tick) * CORE_TICK_S : NEVER_S;
}

void credit_show(const struct core *core, struct scene_credit *out)
{
    const struct credit *credit = &core->game.credit;
    *out = (struct scene_credit){
        .price = core->config.credit_coins,
        .unpaid = (uint8_t)!credit_can_play(core),
        .warnings = credit->warnings,
        .came_back = credit->came_back,
        .coins = credit->coins,
        .credits = credit->credits,
        .coin_s = since_s(core, credit->coin_tick),
        .asked_s = since_s(core, credit->asked_tick),
    };
}

uint64_t credit_hash(uint64_t hash, const struct credit *credit)
{
    const uint32_t words[] = { credit->is_paid,  credit->came_back, credit->warnings,
                               credit->coins,    credit->credits,   credit->metered,
                               credit->services, credit->refunds,   credit->tilts,
                               credit->tickets,  credit->coin_tick, credit->tilt_tick,
                               credit->asked_tick };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    return hash;
}
