/* game.c -- the phases of the stall, fresh paper, the score. */
#include "core/game/game.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/rng.h"
#include "core/core.h"
#include "core/game/hand.h"
#include "core/game/let_go.h"
#include "core/game/paper.h"

#define ROUND_S_DEFAULT 60u
#define LAST_SECONDS 5u                /* Each with its tick. */
#define SWAP_TICKS (2u * CORE_TICK_HZ) /* The attract bot keeps a torn poi for so long. */
#define ATTRACT_BOWL_MAX 10u           /* Then it begins anew, or a night would empty the tank. */

static int held_by_someone(const struct core *core, uint32_t index)
{
    return hand_plays(core, index) && core->poi[index].link != POI_LINK_LOST;
}

static void enter(struct core *core, uint8_t phase)
{
    core->game.phase = phase;
    core->game.phase_tick = core->tick;
}

/* ---- Paper ---------------------------------------------------------------------------------- */

/* A new poi in the same place; fish that lay on the old one fall through where it was. */
static void hand_out(struct core *core, uint32_t index, uint32_t number, enum game_series series)
{
    struct poi *poi = &core->poi[index];
    const uint8_t link = poi->link;
    const struct angles angles = poi->angles;
    const uint32_t rider_count = poi->rider_count;
    struct rider riders[POI_RIDER_MAX];
    let_go_all(poi, &core->tank);
    memcpy(riders, poi->riders, sizeof riders);
    poi_init(poi, GAME_POI_GRADE, poi->position_m,
             game_poi_seed(core->config.seed, index, number, series));
    poi->link = link;
    poi->angles = angles;
    poi->rider_count = rider_count;
    memcpy(poi->riders, riders, sizeof riders);
    core->game.handed[index] = 1;
}

static void pour_all_back(struct core *core)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        bowl_pour_back(&core->bowl[i], i, &core->tank);
    }
}

static void start_round(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    if (game->phase == PHASE_ATTRACT) {
        hints_init(&game->hints); /* From the result it is the same player, who knows. */
    }
    enter(core, PHASE_READY);
    game->round_count++;
    game->bot_played = 0;
    game->played = 0;
    game->gone_tick = 0;
    game->lost_ticks = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->caught[i] = 0;
        game->handed[i] = 0;
    }
    pour_all_back(core);
    output_sound(output, SOUND_START, 1.0f, 0.0f);
}

/* ---- Phases --------------------------------------------------------------------------------- */

static int any_dipped(const struct core *core, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (core->bowl[i].present && hand_dips(core, input, i)) {
            return 1;
        }
    }
    return 0;
}

static void tick_attract(struct core *core, const struct input *input, struct output *output)
{
    struct game *game = &core->game;
    if ((input->pressed & INPUT_START) || any_dipped(core, input)) {
        start_round(core, output);
        return;
    }
    const int is_full = core->bowl[0].fish_count >= ATTRACT_BOWL_MAX;
    const int is_free = core->poi[0].immersed <= 0.0f && core->poi[0].rider_count == 0;
    if (game->gone_tick == 0 && (is_full || !paper_can_hold(&core->poi[0].sheet))) {
        game->gone_tick = core->tick;
    }
    if (game->gone_tick != 0 && core->tick - game->gone_tick >= SWAP_TICKS && is_free) {
        hand_out(core, 0, core->tick, GAME_SERIES_ATTRACT);
        bowl_pour_back(&core->bowl[0], 0, &core->tank);
        game->gone_tick = 0;
    }
}

/* Each poi gets its paper as soon as it is clear of the water, so that nothing jumps. */
static void tick_ready(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    const uint32_t elapsed = core->tick - game->phase_tick;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const int clear = core->poi[i].immersed <= 0.0f || elapsed >= GAME_READY_TICKS / 2u;
        if (!game->handed[i] && clear) {
            hand_out(core, i, game->round_count, GAME_SERIES_ROUND);
        }
    }
    if (elapsed >= GAME_READY_TICKS) {
        pour_all_back(core); /* What fell off an old poi meanwhile would lie there uncounted. */
        enter(core, PHASE_ROUND);
        game->round_tick = core->tick;
        output_sound(output, SOUND_START, 0.8f, 0.0f);
    }
}

static void leave_record(struct core *core, struct output *output, uint32_t total)
{
    struct game *game = &core->game;
    game->record_id++;
    output->record = (struct round_record){
        .id = game->record_id,
        .seed = core->config.seed,
        .start_tick = game->round_tick,
        .end_tick = core->tick,
        .caught = total,
        .by_bot = game->bot_played,
    };
}

/* A round that nobody played leaves no record. */
static void finish_round(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    uint32_t total = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        core->poi[i].rider_count = 0; /* Too late: they go back to the water. */
        total += game->caught[i];
        if (!game->bot_played && game->caught[i] > game->best_today[game->mode]) {
            game->best_today[game->mode] = game->caught[i];
        }
    }
    if (game->played) {
        leave_record(core, output, total);
    }
    enter(core, PHASE_RESULT);
    output_sound(output, SOUND_RESULT, 1.0f, 0.0f);
}

/* When time is called nothing more may be scooped, but what lies on paper may be brought home. */
static int any_carries(const struct core *core)
{
    uint32_t riders = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        riders += hand_plays(core, i) ? core->poi[i].rider_count : 0;
    }
    return riders > 0;
}

static int round_is_over(const struct core *core, uint32_t elapsed, uint32_t total)
{
    const uint32_t gone_tick = core->game.gone_tick;
    if (gone_tick != 0 && core->tick - gone_tick >= GAME_GONE_TICKS) {
        return 1;
    }
    return elapsed >= total && (!any_carries(core) || elapsed >= total + GAME_CARRY_TICKS);
}

static int anyone_plays(const struct core *core)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (held_by_someone(core, i)) {
            return 1;
        }
    }
    return 0;
}

/* Nobody has a poi in hand: the round's clock stands still, but not for ever. */
static void wait_for_hands(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    game->lost_ticks++;
    game->phase_tick++;
    game->gone_tick += game->gone_tick != 0 ? 1u : 0u;
    if (game->lost_ticks > GAME_LOST_TICKS_MAX) {
        finish_round(core, output);
    }
}

static int all_paper_gone(const struct core *core)
{
    int papers = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (hand_plays(core, i)) {
            papers++;
            if (paper_can_hold(&core->poi[i].sheet)) {
                return 0;
            }
        }
    }
    return papers > 0;
}

static void tick_round(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->bot_played |= (uint8_t)(hand_plays(core, i) && core->poi[i].link == POI_LINK_BOT);
    }
    if (!anyone_plays(core)) {
        wait_for_hands(core, output);
        return;
    }
    game->played = 1;
    game->lost_ticks = 0;
    const uint32_t total = game->round_s * CORE_TICK_HZ;
    const uint32_t elapsed = core->tick - game->phase_tick;
    if (game->gone_tick == 0 && all_paper_gone(core)) {
        game->gone_tick = core->tick;
        output_sound(output, SOUND_GONE, 1.0f, 0.0f);
    }
    if (round_is_over(core, elapsed, total)) {
        finish_round(core, output);
    } else if (elapsed < total && elapsed + LAST_SECONDS * CORE_TICK_HZ >= total &&
               (total - elapsed) % CORE_TICK_HZ == 0) {
        output_sound(output, SOUND_TICK, 1.0f, 0.0f);
    }
}

static void tick_result(struct core *core, const struct input *input, struct output *output)
{
    struct game *game = &core->game;
    const uint32_t elapsed = core->tick - game->phase_tick;
    if (((input->pressed & INPUT_START) && elapsed >= GAME_AGAIN_TICKS) ||
        (any_dipped(core, input) && elapsed >= GAME_AGAIN_DIP_TICKS)) {
        start_round(core, output);
    } else if (elapsed >= GAME_RESULT_TICKS) {
        enter(core, PHASE_ATTRACT);
        game->gone_tick = 0;
        bowl_pour_back(&core->bowl[0], 0, &core->tank);
    }
}

static void tick_phase(struct core *core, const struct input *input, struct output *output)
{
    switch (core->game.phase) {
    case PHASE_ATTRACT:
        tick_attract(core, input, output);
        break;
    case PHASE_READY:
        tick_ready(core, output);
        break;
    case PHASE_ROUND:
        tick_round(core, output);
        break;
    default:
        tick_result(core, input, output);
        break;
    }
}

/* ---- Public --------------------------------------------------------------------------------- */

void game_init(struct game *game, const struct core_config *config)
{
    memset(game, 0, sizeof *game);
    game->phase = PHASE_ATTRACT;
    game->language = config->language;
    game->round_s = config->round_s ? config->round_s : ROUND_S_DEFAULT;
    memcpy(game->best_today, config->best_today, sizeof game->best_today);
    hints_init(&game->hints);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->hand[i].position_m = v3(0.0f, 0.10f, 0.0f);
        game->live_y_m[i] = -1.0f;
        bot_init(&game->bot[i], &technique_expert, config->seed + i);
        game->bot[i].hand = game->hand[i];
    }
}

void game_tick(struct core *core, const struct input *input, struct output *output,
               struct poi_target targets[POI_MAX], uint8_t live[POI_MAX])
{
    struct game *game = &core->game;
    if (input->pressed & INPUT_LANGUAGE) {
        game->language = (uint8_t)((game->language + 1u) % LANGUAGE_COUNT);
    }
    if (input->record_saved_id > game->record_id) {
        game->record_id = input->record_saved_id; /* The store remembers earlier days. */
    }
    hand_read(core, input);
    hand_links(core, input);
    tick_phase(core, input, output);
    hand_links(core, input); /* A new phase may hand the poi to someone else in this very tick. */
    hand_tick_all(core, input, targets, live);
    hints_tick(&game->hints, core);
    output->start_lamp =
        game->phase == PHASE_ATTRACT && core->tick % CORE_TICK_HZ < CORE_TICK_HZ / 2u;
}

void game_score(struct core *core, const struct catch_result caught[POI_MAX])
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (core->game.phase == PHASE_ROUND) {
            core->game.caught[i] += caught[i].landed + caught[i].poured + caught[i].walled;
        }
    }
}

uint32_t game_poi_seed(uint32_t seed, uint32_t index, uint32_t number, enum game_series series)
{
    return rng_u32(
        (struct rng_key){ seed, number, index + POI_MAX * (uint32_t)series, RNG_ROUND_SEED });
}

int game_pumps(const struct game *game, uint32_t tick)
{
    const uint32_t elapsed = (tick - game->phase_tick) % (GAME_STALE_TICKS + GAME_AIR_TICKS);
    return game->phase == PHASE_ATTRACT ? elapsed >= GAME_STALE_TICKS
                                        : game->phase != PHASE_ROUND;
}

float game_seconds_left(const struct game *game, uint32_t tick)
{
    const uint32_t elapsed = tick - game->phase_tick;
    uint32_t total = 0;
    if (game->phase == PHASE_READY) {
        total = GAME_READY_TICKS;
    } else if (game->phase == PHASE_ROUND) {
        total = game->round_s * CORE_TICK_HZ;
    }
    return elapsed < total ? (float)(total - elapsed) * CORE_TICK_S : 0.0f;
}

static uint64_t hash_target(uint64_t hash, const struct poi_target *target)
{
    hash = hash_vec3(hash, target->position_m);
    hash = hash_float(hash, target->angles.yaw_rad);
    hash = hash_float(hash, target->angles.pitch_rad);
    return hash_float(hash, target->angles.roll_rad);
}

uint64_t game_hash(uint64_t hash, const struct game *game)
{
    const uint32_t words[] = { game->phase,      game->language,    game->bot_played,
                               game->played,     game->phase_tick,  game->round_tick,
                               game->lost_ticks, game->gone_tick,   game->round_s,
                               game->round_count, game->record_id, game->mode };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t i = 0; i < MODE_COUNT; i++) {
        hash = hash_u32(hash, game->best_today[i]);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = hash_u32(hash, game->caught[i]);
        hash = hash_u32(hash, game->handed[i]);
        hash = hash_u32(hash, game->holder[i]);
        hash = hash_u32(hash, game->grip_tick[i]);
        hash = hash_target(hash, &game->hand[i]);
        hash = hash_float(hash, game->live_y_m[i]);
        hash = trust_hash(hash, &game->trust[i]);
        hash = hash_u32(hash, game->back_ticks[i]);
        hash = bot_hash(hash, &game->bot[i]);
    }
    return hints_hash(hash, &game->hints);
}
