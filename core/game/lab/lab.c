/* lab.c -- runs one tick of the growth lab: pointer, buttons and playback. */
#include "core/game/lab/lab.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/game.h"
#include "core/game/phases.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

/* Time in seconds in which a held LEFT or RIGHT button changes the displayed progress of the fish's
 * growth from 0 to 1. */
#define BUTTON_LIFE_S 9.0f

void lab_begin(struct game *game, struct world *world, const struct core_config *config,
               struct output *output)
{
    CORE_ASSERT(game->lab.species < lab_book_count(&config->book));
    struct lab *lab = &game->lab;
    table_setup_empty_bowls(world);
    table_setup_prepare(game->control, game, world, config, config->preset);
    game_enter_phase(game, PHASE_LAB);
    lab->stir_tick = lab->act_tick = game->tick;
    lab->start_ticks = 0;
    /* The player opened the lab by a dip of the poi. The pointer counts as pressed until it is
     * released, so that this dip does not press a part of the page. */
    lab->presses = 1;
    lab_take(&game->lab, &config->book, lab->species);
    output_sound(output, SOUND_START, 0.7f, 0.0f);
}

/* ---- Pointer of the growth lab --------------------------------------------------------------- */

/* Returns the pointer of the first player who has a bowl at the tank and a valid pose. */
static struct pointer_state first_pointer(const struct lab *lab, const struct world *world,
                                          const struct input *input)
{
    struct pointer_state pointer = { 0 };
    for (uint32_t i = 0; i < POI_MAX && !pointer.present; i++) {
        if (world->bowl[i].present) {
            pointer = pointer_of_player(world, input, lab->upright, i);
        }
    }
    return pointer;
}

/* Moves the lab's pointer to `pointer` and updates whether the pointer is pressed. After a
 * switch to a different player's pointer, nothing is pressed until the new pointer has been
 * above the water. A drag by the previous player therefore does not continue. Returns true if
 * the player leaves the lab. */
static bool track_lab_hand(struct lab *lab, const struct lab_book *book, uint32_t tick,
                           struct pointer_state pointer, struct output *output)
{
    if (!pointer.present) {
        lab->has_pointer = lab->presses = 0;
        return lab_release(lab, book);
    }
    if (lab->has_pointer && pointer.player != lab->pointer_player) {
        lab->presses = 1;
        lab->holds = HOLD_BUTTON;
        lab->held_knot = LAB_NO_KNOT;
    }
    lab->pointer_player = pointer.player;
    lab->has_pointer = 1;
    lab->x = pointer.at.x;
    lab->y = pointer.at.y;
    const float x = lab->x - lab->stir_x, y = lab->y - lab->stir_y;
    if (x * x + y * y > POINTER_MOVE_MIN * POINTER_MOVE_MIN) {
        lab->stir_x = lab->x;
        lab->stir_y = lab->y;
        lab->stir_tick = tick;
    }
    const bool was_down = lab->presses;
    lab->presses = pointer.height_m < (was_down ? POINTER_RELEASE_Y_M : POINTER_PRESS_Y_M);
    if (!lab->presses) {
        return lab_release(lab, book);
    }
    if (!was_down) {
        lab_press(lab, book, tick, output);
    } else {
        lab_drag(lab, book);
    }
    return false;
}

/* ---- Change of the displayed progress by buttons --------------------------------------------- */

static void step_life(struct lab *lab, float way)
{
    CORE_ASSERT(f_is_finite(way));
    lab->playing = 0;
    lab->rest_ticks = 0;
    lab->progress = f_clamp(lab->progress + way, 0.0f, 1.0f);
}

/* ---- Tick of the lab ------------------------------------------------------------------------ */

static void take_lab_buttons(struct lab *lab, const struct lab_book *book, uint32_t tick,
                             const struct input *input, struct output *output)
{
    const float step = CORE_TICK_S / BUTTON_LIFE_S;
    const uint32_t down = input->held | input->pressed;
    if (down & INPUT_LEFT) {
        step_life(lab, -step);
    }
    if (down & INPUT_RIGHT) {
        step_life(lab, step);
    }
    /* A short press of START starts or stops the playback of the fish's growth. */
    if (input->pressed & INPUT_START) {
        lab_use(lab, book, LAB_PLAY, output);
    }
    if (input->pressed & INPUT_OK) {
        lab_use(lab, book, LAB_NEXT, output);
    }
    const uint32_t guests = ~(uint32_t)INPUT_TEST;
    lab->stir_tick = down & guests ? tick : lab->stir_tick;
    /* Only new presses of a button count as activity, because a button that is held for minutes is
     * stuck. */
    lab->act_tick = input->pressed & guests ? tick : lab->act_tick;
}

void lab_tick(struct game *game, struct world *world, struct core_config *config,
              const struct input *input, struct output *output)
{
    struct lab *lab = &game->lab;
    CORE_ASSERT(game->phase == PHASE_LAB);
    CORE_ASSERT(lab->species < lab_book_count(&config->book) && lab->layer <= LAB_LAYER_SIZE);
    lab->upright = input->upright != 0;
    lab->edit_refused = input->edit_refused != 0;
    lab->saved_id = input->edit_saved_id > lab->saved_id ? input->edit_saved_id : lab->saved_id;
    take_lab_buttons(lab, &config->book, game->tick, input, output);
    if (track_lab_hand(lab, &config->book, game->tick, first_pointer(lab, world, input), output)) {
        attract_begin(game, world, config);
    }
    if (lab->playing && lab->holds == HOLD_NOTHING) {
        lab->progress = f_min(lab->progress + 1.0f / (float)LAB_LIFE_TICKS, 1.0f);
        lab->rest_ticks = lab->progress < 1.0f ? 0u : lab->rest_ticks + 1u;
        if (lab->rest_ticks > LAB_REST_TICKS) {
            lab->progress = 0.0f;
            lab->rest_ticks = 0;
        }
    }
    if (game->phase == PHASE_LAB) {
        const bool is_deserted = game->tick - lab->stir_tick >= LAB_IDLE_TICKS ||
                                 game->tick - lab->act_tick >= LAB_SWING_TICKS;
        lab->start_ticks = input->held & INPUT_START ? lab->start_ticks + 1u : 0u;
        if (lab->start_ticks >= LAB_END_TICKS || is_deserted) {
            attract_begin(game, world, config);
        }
    }
}

/* ---- Displayed state of the lab ------------------------------------------------------------- */

void lab_show(const struct lab *lab, const struct lab_book *book, struct scene_lab *out)
{
    const struct species_card *card = lab_book_card(book, lab->species);
    struct species_card *shown = &out->card;
    lab_edit_apply(&lab->edit, card, shown);
    out->species = lab->species;
    out->species_count = (uint8_t)lab_book_count(book);
    out->refused = book->refused;
    out->template_id = lab->edit.template_id;
    out->layer = lab->layer;
    out->playing = lab->playing;
    out->compare = lab->compare;
    out->path = lab->path;
    out->points = lab->points;
    out->presses = lab->presses;
    out->has_pointer = lab->has_pointer;
    out->holds = lab->holds;
    out->held_knot = lab->held_knot;
    out->upright = lab->upright;
    out->keeping = lab->requested_id == 0               ? LAB_NOT_SAVED
                   : lab->saved_id >= lab->requested_id ? LAB_SAVED
                   : lab->edit_refused                  ? LAB_UNSAVED
                                                        : LAB_SAVING;
    out->is_own = (uint8_t)lab_is_own(lab, book);
    out->is_kept = lab->has_edit[lab->species]
                       ? lab_edit_same(&lab->edit, &lab->edits[lab->species])
                       : out->is_own;
    out->x = lab->x;
    out->y = lab->y;
    out->progress = lab->progress;
    out->age_days = life_age_days(card, lab->progress);
    out->length_m = life_length_m(shown, lab->progress);
    out->scale_knot_count = (uint8_t)lab_edit_scale_knots(&lab->edit, card, out->scale_knots);
    graph_weights(&lab->edit.graph, card->key_count, lab->progress, out->weight);
}
