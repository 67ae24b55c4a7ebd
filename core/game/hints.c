/* hints.c -- the rules that select a hint from the player's actions. */
#include "core/game/hints.h"

#include "core/base/hash.h"
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/pause.h"

/* Ticks between two evaluations of the rules: ten evaluations per second. */
#define LOOK_TICKS 12u
#define MOVED_M 0.15f   /* Distance that counts as a deliberate motion. */
#define HASTE_M_S 0.35f /* Speed through water that counts as too fast. */
/* Number of cells torn between two evaluations that triggers the hint about fast motion. */
#define HASTE_CELLS 3u
#define HASTE_TICKS (3u * CORE_TICK_HZ)
#define TILT_RAD 0.15f /* Pitch that counts as a deliberate tilt. */
/* Number of dips without a catch after which a hint explains the technique. */
#define FRUITLESS_DIPS 2u
/* Horizontal distance at which a fish counts as above the ring. */
#define ABOVE_M 0.045f
#define WET_CELL 0.2f /* Wetness that a cell reaches after a quarter of a second under water. */
/* Shares of wet paper between which the paper counts as partly wet. */
#define WET_PART_MIN 0.15f
#define WET_PART_MAX 0.85f
#define POURED_TICKS (4u * CORE_TICK_HZ) /* Time for which the hint about pouring is shown. */

#define BIT(hint) (1u << (hint))

/* Returns 1 if the hint is urgent, otherwise 0. An urgent hint replaces the current hint
 * immediately. */
static int is_urgent(uint8_t hint)
{
    return hint == HINT_TORN || hint == HINT_LOST_POI;
}

/* Returns 1 if the player is doing the action that `hint` describes, otherwise 0. */
static int is_followed(uint8_t hint, const struct poi *poi)
{
    return hint == HINT_LIFT ? poi->immersed < 0.5f : hint == HINT_DIP && poi->immersed > 0.5f;
}

static const struct poi *poi_of(const struct hints *hints, const struct world *world)
{
    return &world->poi[hints->pupil];
}

static const struct player *player_of(const struct hints *hints, const struct game *game)
{
    return &game->player[hints->pupil];
}

/* Selects the first player who has a poi in use. If the player changes, the learned actions are
 * reset. */
static void turn_to_pupil(struct hints *hints, const struct world *world)
{
    for (uint8_t i = 0; i < POI_MAX; i++) {
        if (pause_holds(world, i)) {
            if (i != hints->pupil) {
                *hints = (struct hints){ .pupil = i,
                                         .shown = hints->shown,
                                         .shown_tick = hints->shown_tick,
                                         .paper_cells = world->poi[i].sheet.paper_cells };
            }
            return;
        }
    }
}

struct view_of_fish {
    int held;  /* 1 if a fish lies on the poi, otherwise 0. */
    int above; /* 1 if a fish swims above the poi, otherwise 0. */
};

static struct view_of_fish look_at_fish(const struct hints *hints, const struct world *world)
{
    struct view_of_fish view = { 0 };
    const vec3 centre = poi_of(hints, world)->position_m;
    for (uint32_t i = 0; i < world->tank.fish_count; i++) {
        const struct fish *fish = &world->tank.fish[i];
        const vec3 d = v3_sub(fish->position_m, centre);
        view.held |= fish->gait == GAIT_HELD && fish->holder == hints->pupil;
        const int near = d.x * d.x + d.z * d.z < ABOVE_M * ABOVE_M;
        view.above |= near && d.y > 0.0f && fish->gait < GAIT_HELD;
    }
    return view;
}

/* Counts the poi's dips since the last catch, or since the poi was new. */
static void count_dips(struct hints *hints, const struct game *game, const struct world *world)
{
    const uint32_t caught = player_of(hints, game)->caught;
    const uint32_t dips = poi_of(hints, world)->dips;
    if (caught != hints->caught || dips < hints->dips_before) {
        hints->dips_before = caught != hints->caught ? dips : 0;
    }
    hints->caught = caught;
}

/* Updates the learned actions and the fast-motion flag. */
static void observe(struct hints *hints, const struct game *game, const struct world *world,
                    struct view_of_fish fish)
{
    const struct poi *poi = poi_of(hints, world);
    const float speed_m_s = v3_length(poi->velocity_m_s);
    hints->moved_m = f_min(hints->moved_m + speed_m_s * CORE_TICK_S * (float)LOOK_TICKS, 1.0f);
    hints->learned |= hints->moved_m > MOVED_M ? BIT(HINT_MOVE) : 0u;
    hints->learned |= poi->immersed > 0.5f ? BIT(HINT_MOVE) | BIT(HINT_DIP) : 0u;
    hints->learned |= fish.held && poi->immersed <= 0.0f ? BIT(HINT_LIFT) : 0u;
    hints->learned |= player_of(hints, game)->caught > 0 ? BIT(HINT_LIFT) | BIT(HINT_BOWL) : 0u;
    hints->learned |=
        f_abs(game->hand_pose[hints->pupil].angles.pitch_rad) > TILT_RAD ? BIT(HINT_TILT) : 0u;
    if (hints->haste_cells >= HASTE_CELLS) {
        hints->haste_tick = game->tick;
    }
    hints->haste_cells = 0;
    count_dips(hints, game, world);
}

/* Counts cells torn while the ring moves too fast. Runs in every tick, because the speed may change
 * between two evaluations. */
static void watch_haste(struct hints *hints, const struct poi *poi)
{
    const uint32_t now = poi->sheet.paper_cells;
    if (now < hints->paper_cells && v3_length(poi->velocity_m_s) > HASTE_M_S) {
        hints->haste_cells += hints->paper_cells - now;
    }
    hints->paper_cells = now;
}

/* Returns 1 if the paper is partly wet, otherwise 0. Partly wet paper tears at the border between
 * wet and dry areas. */
static int is_wet_in_part(const struct poi *poi)
{
    uint32_t wet = 0;
    if (poi->immersed > 0.0f || !poi->sheet.touched || poi->sheet.soaked) {
        return 0;
    }
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        wet += poi->sheet.state[i] == CELL_PAPER && poi->sheet.wetness[i] > WET_CELL;
    }
    const float share = (float)wet / f_max((float)poi->sheet.paper_cells, 1.0f);
    return share > WET_PART_MIN && share < WET_PART_MAX;
}

static int has_poured(const struct hints *hints, const struct game *game)
{
    const uint32_t poured_tick = player_of(hints, game)->offence_tick[FOUL_POURED];
    return poured_tick != 0 && game->tick - poured_tick < POURED_TICKS;
}

/* Returns the first hint that the player has not followed yet and that fits the situation. The
 * hints are tested in the order in which a player should learn them. */
static uint8_t lesson(const struct hints *hints, const struct game *game, const struct world *world,
                      struct view_of_fish fish)
{
    const uint32_t missing = ~hints->learned;
    if (hints->haste_tick != 0 && game->tick - hints->haste_tick < HASTE_TICKS) {
        return HINT_SLOWLY;
    }
    if (is_wet_in_part(poi_of(hints, world))) {
        return HINT_WET_ALL;
    }
    if (fish.held && poi_of(hints, world)->immersed <= 0.0f && (missing & BIT(HINT_BOWL))) {
        return HINT_BOWL;
    }
    if (poi_of(hints, world)->immersed > 0.5f) {
        return fish.above && (missing & BIT(HINT_LIFT)) ? HINT_LIFT : HINT_NONE;
    }
    if (poi_of(hints, world)->dips >= hints->dips_before + FRUITLESS_DIPS && !fish.held) {
        return HINT_GLIDE;
    }
    if (missing & BIT(HINT_MOVE)) {
        return HINT_MOVE;
    }
    if (missing & BIT(HINT_DIP)) {
        return HINT_DIP;
    }
    const int may_tilt = player_of(hints, game)->caught > 0 && (missing & BIT(HINT_TILT));
    return may_tilt ? HINT_TILT : HINT_NONE;
}

static uint8_t wanted_in_round(const struct hints *hints, const struct game *game,
                               const struct world *world, struct view_of_fish fish)
{
    const struct player *player = player_of(hints, game);
    if (player->torn_tick != 0) {
        return HINT_TORN;
    }
    if (player->out || poi_of(hints, world)->link == POI_SOURCE_BOT) {
        return HINT_NONE;
    }
    if (has_poured(hints, game)) {
        return HINT_CLEAR_RIM;
    }
    return rules_of(game->mode)->coaches ? lesson(hints, game, world, fish) : HINT_NONE;
}

/* Returns the hint for READY. With an umpire the hint explains the rule about shadows, otherwise
 * how to move the poi. */
static uint8_t wanted_in_ready(const struct hints *hints, const struct game *game,
                               const struct world *world)
{
    if (rules_of(game->mode)->judges) {
        return HINT_NO_SHADE;
    }
    const int is_bot = poi_of(hints, world)->link == POI_SOURCE_BOT;
    return is_bot || (hints->learned & BIT(HINT_MOVE)) ? HINT_NONE : HINT_MOVE;
}

static uint8_t want_to_play(const struct ledger *ledger, const struct core_config *config)
{
    return credit_can_play(ledger, config) ? HINT_START : HINT_COIN;
}

static uint8_t wanted(const struct hints *hints, const struct game *game, const struct world *world,
                      const struct core_config *config, struct view_of_fish fish)
{
    switch (game->phase) {
    case PHASE_ATTRACT:
        return want_to_play(&game->accounts.ledger, config);
    case PHASE_MODE_SELECT:
        return HINT_CHOOSE;
    case PHASE_LAB:
    case PHASE_ALBUM:
    case PHASE_NAME:
        return HINT_NONE; /* These pages contain their own instructions. */
    case PHASE_LEADERBOARD:
        return want_to_play(&game->accounts.ledger, config);
    case PHASE_MENU:
        return HINT_NONE;
    case PHASE_RESULT:
        return game->accounts.credit.came_back ? HINT_PAID_BACK
               : game->tick - game->phase_tick >= GAME_AGAIN_DIP_TICKS
                   ? want_to_play(&game->accounts.ledger, config)
                   : HINT_NONE;
    default:
        break;
    }
    const int nobody_leads =
        !pause_holds(world, hints->pupil); /* The player of the hints has no poi in use only if no
                                              player has one. */
    if (game->paused || (nobody_leads && !player_of(hints, game)->out)) {
        return HINT_LOST_POI;
    }
    return game->phase == PHASE_READY ? wanted_in_ready(hints, game, world)
                                      : wanted_in_round(hints, game, world, fish);
}

void hints_init(struct hints *hints)
{
    *hints = (struct hints){ 0 };
}

void hints_tick(struct hints *hints, const struct game *game, const struct world *world,
                const struct core_config *config)
{
    turn_to_pupil(hints, world);
    watch_haste(hints, poi_of(hints, world));
    const int edge = game->tick == game->phase_tick; /* The hint is evaluated in the first tick of a
                                                        new phase. */
    if (!edge && game->tick % LOOK_TICKS != 0) {
        return;
    }
    const struct view_of_fish fish = look_at_fish(hints, world);
    observe(hints, game, world, fish);
    const uint8_t next = wanted(hints, game, world, config, fish);
    if (next != hints->shown &&
        (edge || is_urgent(next) || is_followed(hints->shown, poi_of(hints, world)) ||
         game->tick - hints->shown_tick >= HINT_TICKS_MIN)) {
        hints->shown = next;
        hints->shown_tick = game->tick;
    }
}

uint64_t hints_hash(uint64_t hash, const struct hints *hints)
{
    hash = hash_u32(hash, hints->pupil);
    hash = hash_u32(hash, hints->shown);
    hash = hash_u32(hash, hints->shown_tick);
    hash = hash_u32(hash, hints->learned);
    hash = hash_u32(hash, hints->haste_tick);
    hash = hash_u32(hash, hints->haste_cells);
    hash = hash_u32(hash, hints->paper_cells);
    hash = hash_u32(hash, hints->dips_before);
    hash = hash_u32(hash, hints->caught);
    return hash_float(hash, hints->moved_m);
}
