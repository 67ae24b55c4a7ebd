/* name.c -- handles the name entry: which player enters a name, the keyboard, and the ledger
 * entry. */
#include "core/game/ranking/name.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/game/phases.h"
#include "core/game/ranking/leaderboard.h"
#include "core/game/ranking/name_filter.h"

/* ---- Players -------------------------------------------------------------------------------- */

static int round_is_ranked(const struct game *game, uint32_t round_id, uint8_t seat)
{
    for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
        if (ranking_place(&game->accounts.ranking, game->mode, (enum rank_period)period, round_id,
                          seat) < RANK_ROWS) {
            return 1;
        }
    }
    return 0;
}

void name_note_round(struct game *game, const struct settings *settings, uint32_t round_id)
{
    struct name *name = &game->name;
    *name = (struct name){ .round_id = round_id };
    for (uint8_t seat = 0; seat < POI_MAX && round_id != 0; seat++) {
        name->ranked |= (uint8_t)(round_is_ranked(game, round_id, seat) ? 1u << seat : 0u);
    }
    const int is_kept = game->accounts.ledger.boot != 0;
    const int is_wanted = settings->value[SET_NAMES] != 0;
    name->waits = is_kept && is_wanted ? name->ranked : 0u;
}

static uint8_t best_waiting(const struct game *game)
{
    uint8_t best = POI_MAX;
    for (uint8_t seat = 0; seat < POI_MAX; seat++) {
        const int waits = game->name.waits >> seat & 1;
        if (waits && (best == POI_MAX || game->player[seat].caught > game->player[best].caught)) {
            best = seat;
        }
    }
    return best;
}

static uint8_t alphabet_of(uint8_t language)
{
    return language == LANGUAGE_JA ? ALPHABET_HIRAGANA : ALPHABET_LATIN;
}

/* Clears the letters and restarts the timeout for the current player. */
static void ask_for_name(struct name *name, uint32_t tick)
{
    name->key = 0;
    name->letter_count = 0;
    name->points = 0;
    name->presses = 1; /* A poi that is under water presses nothing until it has been above the
                          water. */
    name->held_ticks = 0;
    name->seat_tick = name->act_tick = tick;
}

/* Starts the name entry of the next player. Returns 1, or 0 if no player still needs a name. */
static int begin_next_turn(struct game *game)
{
    struct name *name = &game->name;
    if (name->waits == 0) {
        return 0;
    }
    name->seat = best_waiting(game);
    name->waits &= (uint8_t)~(1u << name->seat);
    name->alphabet = alphabet_of(game->language);
    name->refusals = 0;
    name->has_hand = 0;
    ask_for_name(&game->name, game->tick);
    return 1;
}

int name_begin(struct game *game, struct output *output)
{
    if (!begin_next_turn(game)) {
        return 0;
    }
    game_enter_phase(game, PHASE_NAME);
    output_sound(output, SOUND_CHOOSE, 1.0f, 0.0f);
    return 1;
}

/* ---- Letters -------------------------------------------------------------------------------- */

static int stands_refused(const struct name *name)
{
    char words[LEDGER_NAME_SIZE];
    name_spell(name->letter, name->letter_count, words);
    return name_is_refused(words);
}

void name_keep(struct accounts *accounts, const struct name *name, uint32_t tick,
               struct output *output)
{
    if (name->letter_count == 0 || stands_refused(name)) {
        return;
    }
    struct ledger_entry entry = { .kind = LEDGER_NAME,
                                  .detail = name->seat,
                                  .count = name->round_id };
    name_spell(name->letter, name->letter_count, entry.name);
    ledger_write(accounts, tick, &entry, output);
}

static void finish(struct game *game, struct output *output)
{
    name_keep(&game->accounts, &game->name, game->tick, output);
    if (!begin_next_turn(game)) {
        leaderboard_begin(game);
    }
    output_sound(output, SOUND_CALL, 0.8f, 0.0f);
}

static void take_done(struct game *game, struct output *output)
{
    struct name *name = &game->name;
    if (stands_refused(name) && name->refusals < NAME_REFUSALS_MAX) {
        name->refusals++;
        output_sound(output, SOUND_FOUL, 0.4f, 0.0f);
        ask_for_name(&game->name, game->tick);
        return;
    }
    finish(game, output);
}

/* Adds a letter to the name. When the name is full, highlights the Done key. */
static void add_letter(struct name *name, uint16_t letter)
{
    if (name->letter_count < NAME_LETTERS_MAX) {
        name->letter[name->letter_count++] = letter;
    }
    if (name->letter_count == NAME_LETTERS_MAX) {
        name->key = NAME_DONE;
    }
}

static void change_last(struct name *name)
{
    if (name->letter_count > 0) {
        uint16_t *last = &name->letter[name->letter_count - 1u];
        *last = name_changed(*last);
    }
}

static void activate_key(struct game *game, struct output *output)
{
    struct name *name = &game->name;
    name->act_tick = game->tick;
    output_sound(output, SOUND_TICK, 0.7f, 0.0f);
    switch (name->key) {
    case NAME_ALPHABET:
        name->alphabet = (uint8_t)((name->alphabet + 1u) % ALPHABET_COUNT);
        break;
    case NAME_CHANGE:
        change_last(name);
        break;
    case NAME_ERASE:
        name->letter_count = (uint8_t)(name->letter_count - (name->letter_count > 0));
        break;
    case NAME_DONE:
        take_done(game, output);
        break;
    default:
        add_letter(name, name_letter(name->alphabet, name->key));
        break;
    }
}

/* ---- Pointing ------------------------------------------------------------------------------- */

static void point_at_key(struct name *name, uint32_t tick, uint32_t key, struct output *output)
{
    name->act_tick = tick;
    if (name->key != key) {
        name->key = (uint8_t)key;
        output_sound(output, SOUND_CHOOSE, 0.5f, 0.0f);
    }
}

static int is_there(const struct name *name, uint32_t key)
{
    return key >= NAME_CELLS || name_letter(name->alphabet, key) != 0;
}

/* Moves the highlight to the next key, forward or backward. The highlight wraps around and skips
 * empty cells. */
static void point_on(struct name *name, uint32_t tick, int forward, struct output *output)
{
    uint32_t key = name->key;
    do {
        key = (key + (forward ? 1u : NAME_KEY_COUNT - 1u)) % NAME_KEY_COUNT;
    } while (!is_there(name, key));
    point_at_key(name, tick, key, output);
}

static int runs_on(struct name *name, uint32_t held)
{
    name->held_ticks = held & (INPUT_LEFT | INPUT_RIGHT) ? name->held_ticks + 1u : 0u;
    return name->held_ticks >= NAME_RUN_TICKS && name->held_ticks % NAME_STEP_TICKS == 0;
}

static void heed_buttons(struct game *game, const struct input *input, struct output *output)
{
    struct name *name = &game->name;
    const uint32_t pressed = input->pressed | (runs_on(name, input->held) ? input->held : 0u);
    if (pressed & INPUT_RIGHT) {
        point_on(&game->name, game->tick, 1, output);
    } else if (pressed & INPUT_LEFT) {
        point_on(&game->name, game->tick, 0, output);
    }
    if (input->pressed & (INPUT_OK | INPUT_START)) {
        activate_key(game, output);
    }
}

/* Returns the key under the pointer, from 1; 0 means none. */
static uint8_t key_under(const struct name *name, struct layout_point at)
{
    for (uint32_t key = 0; key < NAME_KEY_COUNT; key++) {
        if (pointer_is_inside(name_box(name->upright, name->alphabet, key), 0.0f, at)) {
            return (uint8_t)(key + 1u);
        }
    }
    return 0;
}

/* Restarts the timeout when the pointer moves, because the player is searching for a letter. */
static void note_stir(struct name *name, uint32_t tick, struct layout_point at)
{
    const float x = at.x - name->rest_x, y = at.y - name->rest_y;
    if (x * x + y * y > POINTER_MOVE_MIN * POINTER_MOVE_MIN) {
        name->rest_x = at.x;
        name->rest_y = at.y;
        name->act_tick = tick;
    }
}

/* Moves the highlight when the pointer enters a key. While the pointer is at rest, the buttons move
 * the highlight. */
static void point_at_key_by_hand(struct game *game, const struct world *world,
                                 const struct input *input, struct output *output)
{
    struct name *name = &game->name;
    const struct pointer_state hand = pointer_of_player(world, input, name->upright, name->seat);
    const int was_down = name->presses || !name->has_hand;
    name->has_hand = hand.present;
    if (!hand.present) {
        name->points = 0;
        return;
    }
    name->x = hand.at.x;
    name->y = hand.at.y;
    note_stir(&game->name, game->tick, hand.at);
    const uint8_t points = key_under(name, hand.at);
    if (points != name->points && points > 0) {
        point_at_key(&game->name, game->tick, points - 1u, output);
    }
    name->points = points;
    name->presses = hand.height_m < (was_down ? POINTER_RELEASE_Y_M : POINTER_PRESS_Y_M);
    if (name->presses && !was_down && points > 0) {
        point_at_key(&game->name, game->tick, points - 1u,
                     output); /* A dip presses the key under the pointer, even if a button has moved
                                 the highlight. */
        activate_key(game, output);
    }
}

/* ---- The tick ------------------------------------------------------------------------------- */

/* Highlights the alphabet key if the highlighted letter's cell is empty in the new alphabet. */
static void point_at_something(struct name *name)
{
    name->key = is_there(name, name->key) ? name->key : (uint8_t)NAME_ALPHABET;
}

void name_tick(struct game *game, const struct world *world, const struct input *input,
               struct output *output)
{
    struct name *name = &game->name;
    const uint8_t seat = name->seat;
    name->upright = input->upright != 0;
    if (name_seconds_left(name, game->tick) <= 0.0f) {
        finish(game, output);
    } else if (game->tick - name->seat_tick >= NAME_SEEN_TICKS) {
        heed_buttons(game, input, output);
        if (game->phase == PHASE_NAME && name->seat == seat) {
            point_at_key_by_hand(game, world, input, output);
        }
    }
    point_at_something(name);
}

float name_seconds_left(const struct name *name, uint32_t tick)
{
    const uint32_t idle = name->act_tick - name->seat_tick + NAME_IDLE_TICKS;
    const uint32_t total = idle < NAME_TICKS_MAX ? idle : NAME_TICKS_MAX;
    const uint32_t elapsed = tick - name->seat_tick;
    return elapsed < total ? (float)(total - elapsed) * CORE_TICK_S : 0.0f;
}

void name_show(const struct game *game, struct scene_name *out)
{
    const struct name *name = &game->name;
    *out = (struct scene_name){ .waits = name->waits };
    if (game->phase != PHASE_NAME) {
        return;
    }
    out->seat = name->seat;
    out->alphabet = name->alphabet;
    out->key = name->key;
    out->upright = name->upright;
    out->has_hand = name->has_hand;
    out->presses = name->presses;
    out->was_refused = name->refusals > 0;
    out->letter_count = name->letter_count;
    memcpy(out->letter, name->letter, sizeof out->letter);
    out->x = name->x;
    out->y = name->y;
}

uint64_t name_hash(uint64_t hash, const struct name *name)
{
    const uint32_t words[] = { name->round_id,  name->ranked,   name->waits,     name->seat,
                               name->alphabet,  name->key,      name->points,    name->upright,
                               name->has_hand,  name->presses,  name->refusals,  name->letter_count,
                               name->seat_tick, name->act_tick, name->held_ticks };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t i = 0; i < NAME_LETTERS_MAX; i++) {
        hash = hash_u32(hash, name->letter[i]);
    }
    hash = hash_float(hash_float(hash, name->x), name->y);
    return hash_float(hash_float(hash, name->rest_x), name->rest_y);
}
