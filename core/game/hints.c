/* hints.c -- the rules that select a hint from the player's actions. */
#include "core/game/phases.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/poi/world.h"

/* Ticks between two evaluations of the hint rules: ten evaluations per second. */
#define CHECK_TICKS 12u
/* Distance that a player's poi must move so that its motion counts as deliberate. */
#define MOVED_M 0.15f
/* Speed of the ring through the water above which the motion of the poi counts as too fast. */
#define HASTE_M_S 0.35f
/* Number of paper cells torn between two evaluations of the hint rules that triggers the hint about
 * fast motion. */
#define HASTE_CELLS 3u
#define HASTE_TICKS (3u * CORE_TICK_HZ)
#define TILT_RAD 0.15f /* Pitch of the poi from which its tilt counts as deliberate. */
/* Number of dips without a catch after which a hint explains the technique. */
#define FRUITLESS_DIPS 2u
/* Horizontal distance from the ring within which a fish counts as above the ring. */
#define ABOVE_M 0.045f
/* Wetness from which a paper cell counts as wet. A cell reaches this wetness after a quarter of a
 * second under water. */
#define WET_CELL 0.2f
/* Shares of wet paper between which the paper counts as partly wet. */
#define WET_PART_MIN 0.15f
#define WET_PART_MAX 0.85f
/* Time for which the hint about fish poured into the bowl (FOUL_POURED) is shown. */
#define POURED_TICKS (4u * CORE_TICK_HZ)

#define BIT(hint) (1u << (hint))

struct view_of_fish {
    bool held;  /* True if a fish lies on the poi. */
    bool above; /* True if a fish swims above the poi. */
};

/* Counts paper cells torn while the ring moves too fast. Runs in every tick, because the speed may
 * change between two evaluations. */
static void watch_paper(struct hints *hints, const struct world *world)
{
    CORE_ASSERT(hints->pupil < POI_MAX);
    const struct poi *poi = &world->poi[hints->pupil];
    const uint32_t now = poi->sheet.paper_cells;
    if (now < hints->paper_cells && v3_length(poi->velocity_m_s) > HASTE_M_S) {
        hints->haste_cells += hints->paper_cells - now;
    }
    hints->paper_cells = now;
}

/* Selects the first player who has a poi in use as the player who receives hints. If the player
 * changes, the learned actions are reset. */
static void select_pupil(struct hints *hints, const struct world *world)
{
    uint8_t first = 0;
    while (first < POI_MAX && !player_has_poi(world, first)) {
        first++;
    }
    if (first < POI_MAX && first != hints->pupil) {
        *hints = (struct hints){ .pupil = first,
                                 .shown = hints->shown,
                                 .shown_tick = hints->shown_tick,
                                 .paper_cells = world->poi[first].sheet.paper_cells };
    }
}

/* Updates which actions the player has learned and whether the player moves the poi too fast.
 * Counts the poi's dips since the last catch, or since the poi was new. */
static void observe(struct hints *hints, const struct game *game, const struct world *world,
                    struct view_of_fish fish)
{
    CORE_ASSERT(hints->pupil < POI_MAX && hints->moved_m <= 1.0f);
    const struct poi *poi = &world->poi[hints->pupil];
    const uint32_t caught = game->player[hints->pupil].caught;
    const float speed_m_s = v3_length(poi->velocity_m_s);
    hints->moved_m = f_min(hints->moved_m + speed_m_s * CORE_TICK_S * (float)CHECK_TICKS, 1.0f);
    hints->learned |= hints->moved_m > MOVED_M ? BIT(HINT_MOVE) : 0u;
    hints->learned |= poi->immersed > 0.5f ? BIT(HINT_MOVE) | BIT(HINT_DIP) : 0u;
    hints->learned |= fish.held && poi->immersed <= 0.0f ? BIT(HINT_LIFT) : 0u;
    hints->learned |= caught > 0 ? BIT(HINT_LIFT) | BIT(HINT_BOWL) : 0u;
    hints->learned |= f_abs(game->control[hints->pupil].target_pose.angles.pitch_rad) > TILT_RAD
                          ? BIT(HINT_TILT)
                          : 0u;
    hints->haste_tick = hints->haste_cells >= HASTE_CELLS ? game->tick : hints->haste_tick;
    hints->haste_cells = 0;
    if (caught != hints->caught) {
        hints->dips_before = poi->dips;
    } else if (poi->dips < hints->dips_before) {
        hints->dips_before = 0;
    }
    hints->caught = caught;
}

/* Returns the first hint that the player has not followed yet and that fits the situation. The
 * hints are tested in the order in which a player should learn them. HINT_WET_ALL comes early,
 * because partly wet paper tears at the border between wet and dry areas. */
static uint8_t lesson(const struct hints *hints, const struct game *game, const struct world *world,
                      struct view_of_fish fish)
{
    const uint32_t missing = ~hints->learned;
    const struct poi *poi = &world->poi[hints->pupil];
    const struct sheet *sheet = &poi->sheet;
    if (hints->haste_tick != 0 && game->tick - hints->haste_tick < HASTE_TICKS) {
        return HINT_SLOWLY;
    }
    if (poi->immersed <= 0.0f && sheet->touched && !sheet->soaked) {
        uint32_t wet = 0;
        for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
            wet += sheet->state[i] == CELL_PAPER && sheet->wetness[i] > WET_CELL;
        }
        const float share = (float)wet / f_max((float)sheet->paper_cells, 1.0f);
        if (share > WET_PART_MIN && share < WET_PART_MAX) {
            return HINT_WET_ALL;
        }
    }
    if (fish.held && poi->immersed <= 0.0f && (missing & BIT(HINT_BOWL))) {
        return HINT_BOWL;
    }
    if (poi->immersed > 0.5f) {
        return fish.above && (missing & BIT(HINT_LIFT)) ? HINT_LIFT : HINT_NONE;
    }
    if (poi->dips >= hints->dips_before + FRUITLESS_DIPS && !fish.held) {
        return HINT_GLIDE;
    }
    if (missing & BIT(HINT_MOVE)) {
        return HINT_MOVE;
    }
    if (missing & BIT(HINT_DIP)) {
        return HINT_DIP;
    }
    const bool may_tilt = game->player[hints->pupil].caught > 0 && (missing & BIT(HINT_TILT));
    return may_tilt ? HINT_TILT : HINT_NONE;
}

/* Returns the hint to show in READY (the phase before a round) or in the round. In READY the hint
 * explains the rule about shadows in modes with an umpire, otherwise how to move the poi. */
static uint8_t wanted_in_game(const struct hints *hints, const struct game *game,
                              const struct world *world, struct view_of_fish fish)
{
    CORE_ASSERT(game->phase == PHASE_READY || game->phase == PHASE_ROUND);
    const struct player *player = &game->player[hints->pupil];
    const struct rules *rules = rules_of(game->mode);
    const bool is_bot = world->poi[hints->pupil].link == POI_SOURCE_BOT;
    const uint32_t poured_tick = player->offence_tick[FOUL_POURED];
    /* Report a lost poi if the game is paused, or if the player who receives the hints has no poi
     * in use. In the second case no other player has a poi in use either. */
    if (game->paused || (!player_has_poi(world, hints->pupil) && !player->out)) {
        return HINT_LOST_POI;
    }
    if (game->phase == PHASE_READY) {
        return rules->counts_fouls                           ? HINT_NO_SHADE
               : is_bot || (hints->learned & BIT(HINT_MOVE)) ? HINT_NONE
                                                             : HINT_MOVE;
    }
    if (player->torn_tick != 0) {
        return HINT_TORN;
    }
    if (player->out || is_bot) {
        return HINT_NONE;
    }
    if (poured_tick != 0 && game->tick - poured_tick < POURED_TICKS) {
        return HINT_CLEAR_RIM;
    }
    return rules->shows_hints ? lesson(hints, game, world, fish) : HINT_NONE;
}

static uint8_t choose_hint(const struct hints *hints, const struct game *game,
                           const struct world *world, const struct core_config *config,
                           struct view_of_fish fish)
{
    const uint8_t to_play =
        credit_can_play(&game->accounts.ledger, config) ? HINT_START : HINT_COIN;
    switch (game->phase) {
    case PHASE_ATTRACT:
    case PHASE_LEADERBOARD:
        return to_play;
    case PHASE_MODE_SELECT:
        return HINT_CHOOSE;
    case PHASE_LAB:
    case PHASE_ALBUM:
    case PHASE_NAME:
    case PHASE_MENU:
        /* Show no hint, because the screens of these phases contain their own instructions. */
        return HINT_NONE;
    case PHASE_RESULT:
        return game->accounts.credit.came_back                         ? HINT_PAID_BACK
               : game->tick - game->phase_tick >= GAME_AGAIN_DIP_TICKS ? to_play
                                                                       : HINT_NONE;
    default:
        return wanted_in_game(hints, game, world, fish);
    }
}

/* Returns whether a fish lies on the poi of the player who receives the hints, and whether a fish
 * swims above that poi. */
static struct view_of_fish view_at_poi(const struct hints *hints, const struct world *world)
{
    const struct poi *poi = &world->poi[hints->pupil];
    struct view_of_fish view = { 0 };
    for (uint32_t i = 0; i < world->tank.fish_count; i++) {
        const struct fish *fish = &world->tank.fish[i];
        const vec3 d = v3_sub(fish->position_m, poi->position_m);
        view.held |= fish->gait == GAIT_HELD && fish->holder == hints->pupil;
        const bool near = d.x * d.x + d.z * d.z < ABOVE_M * ABOVE_M;
        view.above |= near && d.y > 0.0f && fish->gait < GAIT_HELD;
    }
    return view;
}

bool hints_may_change(uint8_t shown, uint8_t next, uint32_t shown_ticks, const struct poi *poi)
{
    /* An urgent hint replaces the current hint immediately. Any other hint replaces the current
     * hint after the player has done the action of the current hint, or after HINT_TICKS_MIN. */
    const bool is_urgent = next == HINT_TORN || next == HINT_LOST_POI;
    const bool is_followed =
        (shown == HINT_LIFT && poi->immersed < 0.5f) || (shown == HINT_DIP && poi->immersed > 0.5f);
    return next != shown && (is_urgent || is_followed || shown_ticks >= HINT_TICKS_MIN);
}

void hints_tick(struct hints *hints, const struct game *game, const struct world *world,
                const struct core_config *config)
{
    /* True in the first tick of a new phase. The hint rules are always evaluated in this tick. */
    const bool edge = game->tick == game->phase_tick;
    select_pupil(hints, world);
    watch_paper(hints, world);
    if (!edge && game->tick % CHECK_TICKS != 0) {
        return;
    }
    const struct view_of_fish view = view_at_poi(hints, world);
    observe(hints, game, world, view);
    const uint8_t next = choose_hint(hints, game, world, config, view);
    if ((edge && next != hints->shown) ||
        hints_may_change(hints->shown, next, game->tick - hints->shown_tick,
                         &world->poi[hints->pupil])) {
        hints->shown = next;
        hints->shown_tick = game->tick;
    }
}

void hints_player_tick(struct hints *hints, const struct game *game, const struct world *world)
{
    watch_paper(hints, world);
    if (game->tick != game->phase_tick && game->tick % CHECK_TICKS != 0) {
        return;
    }
    const struct view_of_fish view = view_at_poi(hints, world);
    observe(hints, game, world, view);
    const uint8_t next = wanted_in_game(hints, game, world, view);
    if (next != hints->shown) {
        hints->shown = next;
        hints->shown_tick = game->tick;
    }
}
