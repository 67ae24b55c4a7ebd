/* name.c -- handles the name entry: which player enters a name, the keyboard, and the ledger
 * entry. */
#include "core/game/ranking/name.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"
#include "core/game/phases.h"
#include "core/game/ranking/name_filter.h"
#include "core/poi/world.h"

/* ---- Players who enter a name --------------------------------------------------------------- */

void name_note_round(struct name *name, const struct accounts *accounts,
                     const struct settings *settings, uint32_t board, uint32_t round_id)
{
    CORE_ASSERT(board < RANK_BOARD_COUNT);
    const bool is_kept = accounts->ledger.boot != 0;
    const bool is_wanted = settings->value[SET_NAMES] != 0;
    *name = (struct name){ .round_id = round_id };
    for (uint8_t slot = 0; slot < POI_MAX && round_id != 0; slot++) {
        for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
            const uint32_t place =
                ranking_place(&accounts->ranking, board, (enum rank_period)period, round_id, slot);
            name->ranked |= (uint8_t)(place < RANK_ROWS ? 1u << slot : 0u);
        }
    }
    name->waits = is_kept && is_wanted ? name->ranked : 0u;
}

/* Prepares the name entry of the current player: clears the letters and restarts the timeout. */
static void begin_name_entry(struct name *name, uint32_t tick)
{
    CORE_ASSERT(name->slot < POI_MAX);
    name->key = 0;
    name->letter_count = 0;
    name->points = 0;
    /* A poi that is under water presses nothing until it has been above the water. */
    name->presses = 1;
    name->held_ticks = 0;
    name->start_tick = name->act_tick = tick;
}

/* Starts the name entry of the next player, who has the best score of the players who still need a
 * name. Returns true, or false if no player still needs a name. */
static bool begin_next_turn(struct name *name, const struct game *game)
{
    uint8_t best = POI_MAX;
    for (uint8_t slot = 0; slot < POI_MAX; slot++) {
        const bool waits = name->waits >> slot & 1;
        if (waits && (best == POI_MAX || game->player[slot].caught > game->player[best].caught)) {
            best = slot;
        }
    }
    if (best == POI_MAX) {
        return false;
    }
    name->slot = best;
    name->waits &= (uint8_t)~(1u << best);
    name->alphabet = game->language == LANGUAGE_JA ? ALPHABET_HIRAGANA : ALPHABET_LATIN;
    name->refusals = 0;
    name->has_pointer = 0;
    begin_name_entry(name, game->tick);
    return true;
}

bool name_begin(struct game *game, struct output *output)
{
    CORE_ASSERT(game->name.letter_count <= NAME_LETTERS_MAX);
    if (!begin_next_turn(&game->name, game)) {
        return false;
    }
    game_enter_phase(game, PHASE_NAME);
    output_sound(output, SOUND_CHOOSE, 1.0f, 0.0f);
    return true;
}

/* ---- Pressed keys of the keyboard ------------------------------------------------------------ */

static bool has_refused_word(const struct name *name)
{
    CORE_ASSERT(name->letter_count <= NAME_LETTERS_MAX);
    char words[LEDGER_NAME_SIZE];
    name_spell(name->letter, name->letter_count, words);
    return name_is_refused(words);
}

void name_keep(struct accounts *accounts, const struct name *name, uint32_t tick,
               struct output *output)
{
    CORE_ASSERT(name->slot < POI_MAX);
    if (name->letter_count == 0 || has_refused_word(name)) {
        return;
    }
    struct ledger_entry entry = { .kind = LEDGER_NAME,
                                  .detail = name->slot,
                                  .count = name->round_id };
    name_spell(name->letter, name->letter_count, entry.name);
    ledger_write(accounts, tick, &entry, output);
}

/* Presses the highlighted key. Returns true if the key completes the name. */
static bool activate_key(struct name *name, uint32_t tick, struct output *output)
{
    CORE_ASSERT(name->key < NAME_KEY_COUNT && name->letter_count <= NAME_LETTERS_MAX);
    name->act_tick = tick;
    output_sound(output, SOUND_TICK, 0.7f, 0.0f);
    switch (name->key) {
    case NAME_ALPHABET:
        name->alphabet = (uint8_t)((name->alphabet + 1u) % ALPHABET_COUNT);
        break;
    case NAME_CHANGE:
        if (name->letter_count > 0) {
            uint16_t *last = &name->letter[name->letter_count - 1u];
            *last = name_changed(*last);
        }
        break;
    case NAME_ERASE:
        name->letter_count = (uint8_t)(name->letter_count - (name->letter_count > 0));
        break;
    case NAME_DONE:
        if (has_refused_word(name) && name->refusals < NAME_REFUSALS_MAX) {
            name->refusals++;
            output_sound(output, SOUND_FOUL, 0.4f, 0.0f);
            begin_name_entry(name, tick);
            break;
        }
        return true;
    default: /* The key is a letter, which is added to the name. When the name is full, the Done
                key is highlighted. */
        if (name->letter_count < NAME_LETTERS_MAX) {
            name->letter[name->letter_count++] = name_letter(name->alphabet, name->key);
        }
        name->key = name->letter_count == NAME_LETTERS_MAX ? (uint8_t)NAME_DONE : name->key;
        break;
    }
    return false;
}

/* ---- Highlight of a key by buttons or pointer ------------------------------------------------ */

static void point_at_key(struct name *name, uint32_t tick, uint32_t key, struct output *output)
{
    CORE_ASSERT(key < NAME_KEY_COUNT);
    name->act_tick = tick;
    if (name->key != key) {
        name->key = (uint8_t)key;
        output_sound(output, SOUND_CHOOSE, 0.5f, 0.0f);
    }
}

static bool is_key_present(const struct name *name, uint32_t key)
{
    return key >= NAME_CELLS || name_letter(name->alphabet, key) != 0;
}

/* Moves the highlight to the next key, forward or backward. The highlight wraps around and skips
 * empty cells. */
static void point_on(struct name *name, uint32_t tick, bool forward, struct output *output)
{
    CORE_ASSERT(name->key < NAME_KEY_COUNT);
    uint32_t key = name->key;
    do {
        key = (key + (forward ? 1u : NAME_KEY_COUNT - 1u)) % NAME_KEY_COUNT;
    } while (!is_key_present(name, key));
    point_at_key(name, tick, key, output);
}

/* Handles the buttons during the name entry. LEFT and RIGHT move the highlight from key to key, and
 * repeat while they are held. OK and START press the highlighted key. Returns true if the name is
 * complete. */
static bool take_name_buttons(struct name *name, uint32_t tick, const struct input *input,
                              struct output *output)
{
    name->held_ticks = input->held & (INPUT_LEFT | INPUT_RIGHT) ? name->held_ticks + 1u : 0u;
    const bool repeats =
        name->held_ticks >= NAME_RUN_TICKS && name->held_ticks % NAME_STEP_TICKS == 0;
    const uint32_t pressed = input->pressed | (repeats ? input->held : 0u);
    if (pressed & INPUT_RIGHT) {
        point_on(name, tick, 1, output);
    } else if (pressed & INPUT_LEFT) {
        point_on(name, tick, 0, output);
    }
    return (input->pressed & (INPUT_OK | INPUT_START)) && activate_key(name, tick, output);
}

/* Moves the highlight when the player's pointer enters a key. Motion of the pointer restarts the
 * timeout, because the player is searching for a letter. While the pointer is at rest, the buttons
 * move the highlight. Returns true if the name is complete. */
static bool point_at_key_by_hand(struct name *name, uint32_t tick, const struct world *world,
                                 const struct input *input, struct output *output)
{
    const struct pointer_state pointer = pointer_of_player(world, input, name->upright, name->slot);
    const bool was_down = name->presses || !name->has_pointer;
    uint8_t points = 0; /* Key under the pointer, counted from 1. 0 means no key. */
    name->has_pointer = pointer.present;
    if (!pointer.present) {
        name->points = 0;
        return false;
    }
    name->x = pointer.at.x;
    name->y = pointer.at.y;
    const float x = pointer.at.x - name->rest_x, y = pointer.at.y - name->rest_y;
    if (x * x + y * y > POINTER_MOVE_MIN * POINTER_MOVE_MIN) {
        name->rest_x = pointer.at.x;
        name->rest_y = pointer.at.y;
        name->act_tick = tick;
    }
    for (uint32_t key = 0; key < NAME_KEY_COUNT && points == 0; key++) {
        const struct layout_box box = name_box(name->upright, name->alphabet, key);
        points = pointer_is_inside(box, 0.0f, pointer.at) ? (uint8_t)(key + 1u) : 0u;
    }
    if (points != name->points && points > 0) {
        point_at_key(name, tick, points - 1u, output);
    }
    name->points = points;
    name->presses = pointer.height_m < (was_down ? POINTER_RELEASE_Y_M : POINTER_PRESS_Y_M);
    if (name->presses && !was_down && points > 0) {
        /* A dip of the poi presses the key under the pointer, even if a button has moved the
         * highlight. */
        point_at_key(name, tick, points - 1u, output);
        return activate_key(name, tick, output);
    }
    return false;
}

/* ---- Tick of the name entry ----------------------------------------------------------------- */

void name_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *input, struct output *output)
{
    (void)config;
    struct name *name = &game->name;
    CORE_ASSERT(game->phase == PHASE_NAME && name->slot < POI_MAX);
    name->upright = input->upright != 0;
    const bool is_seen = game->tick - name->start_tick >= NAME_SEEN_TICKS;
    if (game_seconds_left(game, game->tick) <= 0.0f ||
        (is_seen && (take_name_buttons(name, game->tick, input, output) ||
                     point_at_key_by_hand(name, game->tick, world, input, output)))) {
        name_keep(&game->accounts, name, game->tick, output);
        if (!begin_next_turn(name, game)) {
            game_enter_phase(game, PHASE_LEADERBOARD);
        }
        output_sound(output, SOUND_CALL, 0.8f, 0.0f);
    }
    /* If the cell of the highlighted letter is empty in a new alphabet, highlight the key
     * NAME_ALPHABET instead. */
    name->key = is_key_present(name, name->key) ? name->key : (uint8_t)NAME_ALPHABET;
}

void name_show(const struct game *game, struct scene_name *out)
{
    const struct name *name = &game->name;
    *out = (struct scene_name){ .waits = name->waits };
    if (game->phase != PHASE_NAME) {
        return;
    }
    out->slot = name->slot;
    out->alphabet = name->alphabet;
    out->key = name->key;
    out->upright = name->upright;
    out->has_pointer = name->has_pointer;
    out->presses = name->presses;
    out->was_refused = name->refusals > 0;
    out->letter_count = name->letter_count;
    memcpy(out->letter, name->letter, sizeof out->letter);
    out->x = name->x;
    out->y = name->y;
}
