/* encore.c -- loads, seeks, plays and verifies the replay of a score. */
#include "platform/kiosk/encore.h"

#include <string.h>

#include "core/game/game.h"

void encore_ask(struct encore *encore, uint32_t round_id)
{
    if (encore->is_asked) {
        return; /* The store still fills `bytes`. */
    }
    encore->state = ENCORE_SEEKS;
    encore->is_open = encore->has_play = 0;
    encore->round_id = round_id;
    encore->end_ticks = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        encore->hand_y_m[i] = GAME_DIP_Y_M; /* A poi that is already down does not count as a
                                               dip. */
    }
}

void encore_end(struct encore *encore)
{
    encore->state = ENCORE_OFF;
    encore->is_open = encore->has_play = 0;
}

int encore_heeds(struct encore *encore, uint32_t pressed, const struct poi_input poi[POI_MAX])
{
    int dips = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (poi[i].link == POI_LINK_LIVE) {
            const float y_m = poi[i].target.position_m.y;
            dips |= y_m < GAME_DIP_Y_M && encore->hand_y_m[i] > GAME_DIP_Y_M;
            encore->hand_y_m[i] = y_m;
        }
    }
    if (pressed != 0 || dips) {
        encore_end(encore);
        return 1;
    }
    return 0;
}

static void conclude(struct encore *encore, const struct ranking *ranking)
{
    const enum verdict verdict = judge_say(&encore->judge, ranking, encore->round_id,
                                           &encore->kept);
    encore->state = verdict == VERDICT_GENUINE     ? ENCORE_GENUINE
                    : verdict == VERDICT_UNCHECKED ? ENCORE_NONE
                                                   : ENCORE_OTHER;
}

/* Requests the replay from the store, and starts the playback when the replay is loaded. */
static void fetch(struct encore *encore, const struct hal_storage *storage,
                  const struct ranking *ranking)
{
    if (!encore->is_asked) {
        const int result = storage->ops->fetch_replay(storage->self, encore->round_id,
                                                      encore->bytes, sizeof encore->bytes,
                                                      &encore->kept);
        encore->is_asked = result == HAL_OK;
        encore->state = result == HAL_OK || result == HAL_ERR_BUSY ? ENCORE_SEEKS : ENCORE_NONE;
        return;
    }
    const int size = storage->ops->replay_fetched(storage->self);
    if (size == HAL_ERR_BUSY) {
        return;
    }
    encore->is_asked = 0;
    if (encore->state == ENCORE_OFF) {
        return; /* The playback was ended meanwhile. */
    }
    if (size <= 0) {
        encore->state = ENCORE_NONE;
    } else if (judge_open(&encore->judge, encore->bytes, (size_t)size)) {
        conclude(encore, ranking);
    } else {
        encore->is_open = 1;
    }
}

/* Parses one second of the replay. */
static void read_on(struct encore *encore, const struct ranking *ranking)
{
    const int more = judge_read(&encore->judge);
    encore->has_play = more == 0;
    if (more < 0) {
        conclude(encore, ranking);
    }
}

static void seek_on(struct encore *encore, const struct ranking *ranking)
{
    if (judge_is_at_round(&encore->judge)) {
        encore->state = ENCORE_PLAYS;
    } else if (!judge_tick(&encore->judge)) {
        conclude(encore, ranking);
    }
}

/* Parses seconds and then runs ticks, as many as fit into the frame without delaying the kiosk's
 * own ticks. */
static void seek(struct encore *encore, const struct hal_clock *stopwatch,
                 const struct ranking *ranking)
{
    const uint64_t begin_ns = hal_now_ns(*stopwatch);
    uint64_t spent_ns = 0;
    for (uint32_t i = 0; i < ENCORE_SEEK_TICKS && spent_ns < ENCORE_SEEK_NS &&
                         encore->state == ENCORE_SEEKS; i++) {
        (encore->has_play ? seek_on : read_on)(encore, ranking);
        spent_ns = hal_now_ns(*stopwatch) - begin_ns;
    }
}

static void play(struct encore *encore, const struct ranking *ranking, uint32_t tick_count)
{
    for (uint32_t i = 0; i < tick_count && encore->state == ENCORE_PLAYS; i++) {
        if (!judge_tick(&encore->judge)) {
            conclude(encore, ranking);
        }
    }
}

void encore_frame(struct encore *encore, const struct hal *hal, const struct hal_clock *stopwatch,
                  const struct ranking *ranking, uint32_t tick_count)
{
    const int waits = encore->state == ENCORE_SEEKS && !encore->is_open;
    if (waits || encore->is_asked) {
        fetch(encore, &hal->storage, ranking);
    } else if (encore->state == ENCORE_SEEKS) {
        seek(encore, stopwatch, ranking);
    } else if (encore->state == ENCORE_PLAYS) {
        play(encore, ranking, tick_count);
    } else if (encore->state != ENCORE_OFF) {
        encore->end_ticks += tick_count;
        if (encore->end_ticks >= ENCORE_END_TICKS) {
            encore_end(encore);
        }
    }
}

void encore_show(const struct encore *encore, struct scene *scene, struct output *output)
{
    const struct judge *judge = &encore->judge;
    scene->encore = encore->state;
    scene->encore_progress = 0.0f;
    if (encore->state == ENCORE_OFF) {
        return;
    }
    output->sound_count = 0; /* The kiosk's own sounds are dropped because no game runs. */
    if (encore->state == ENCORE_SEEKS && encore->has_play) {
        scene->encore_progress =
            (float)judge->replayer.totals.ticks / (float)(judge->round_tick + 1u);
    }
    if (encore->state != ENCORE_SEEKS && encore->has_play) {
        const uint8_t language = scene->language;
        core_scene(&judge->core, scene);
        scene->language = language; /* The operator's language, because the operator watches the
                                       playback. */
    }
    if (encore->state == ENCORE_PLAYS) {
        output->sound_count = judge->output.sound_count;
        memcpy(output->sounds, judge->output.sounds, sizeof output->sounds);
    }
}
