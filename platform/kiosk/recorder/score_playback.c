/* score_playback.c -- loads, seeks, plays and verifies the replay of a score; see
 * score_playback.h. */
#include "platform/kiosk/recorder/score_playback.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/game/rules.h"

void score_playback_request(struct score_playback *playback, uint32_t round_id)
{
    CORE_ASSERT(round_id != 0);
    if (playback->is_requested) {
        /* No new replay can be requested, because the store is still writing the previously
         * requested replay to `bytes`. */
        return;
    }
    playback->state = PLAYBACK_SEEKS;
    playback->is_open = playback->has_play = false;
    playback->round_id = round_id;
    playback->end_ticks = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        /* The previous height of each poi starts at the threshold of a dip, so that a poi that is
         * already below the water does not count as a dip. */
        playback->hand_y_m[i] = RULES_DIP_Y_M;
    }
}

void score_playback_end(struct score_playback *playback)
{
    playback->state = PLAYBACK_OFF;
    playback->is_open = playback->has_play = false;
}

bool score_playback_handle_input(struct score_playback *playback, uint32_t pressed,
                                 const struct poi_input poi[POI_MAX])
{
    bool dips = false;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (poi[i].link == POI_SOURCE_LIVE) {
            const float y_m = poi[i].target.position_m.y;
            dips |= y_m < RULES_DIP_Y_M && playback->hand_y_m[i] > RULES_DIP_Y_M;
            playback->hand_y_m[i] = y_m;
        }
    }
    if (pressed != 0 || dips) {
        score_playback_end(playback);
        return true;
    }
    return false;
}

static void set_result(struct score_playback *playback, const struct ranking *ranking)
{
    const enum replay_verdict verdict =
        replay_verifier_result(&playback->verifier, ranking, playback->round_id, &playback->kept);
    playback->state = verdict == REPLAY_VERDICT_GENUINE     ? PLAYBACK_GENUINE
                      : verdict == REPLAY_VERDICT_UNCHECKED ? PLAYBACK_NONE
                                                            : PLAYBACK_OTHER;
}

/* Requests the replay from the store. After the store has loaded the replay, opens the replay in
 * the verifier. */
static void fetch_score_replay(struct score_playback *playback, const struct hal_storage *storage,
                               const struct ranking *ranking)
{
    if (!playback->is_requested) {
        const int result =
            storage->replays.ops->fetch(storage->replays.self, playback->round_id, playback->bytes,
                                        sizeof playback->bytes, &playback->kept);
        playback->is_requested = result == HAL_OK;
        playback->state =
            result == HAL_OK || result == HAL_ERR_BUSY ? PLAYBACK_SEEKS : PLAYBACK_NONE;
        return;
    }
    const int size = storage->replays.ops->fetched(storage->replays.self);
    if (size == HAL_ERR_BUSY) {
        return;
    }
    playback->is_requested = false;
    if (playback->state == PLAYBACK_OFF) {
        /* The playback was ended while the store loaded the replay, so the replay is not opened. */
        return;
    }
    if (size <= 0) {
        playback->state = PLAYBACK_NONE;
    } else if (replay_verifier_open(&playback->verifier, playback->bytes, (size_t)size)) {
        set_result(playback, ranking);
    } else {
        playback->is_open = true;
    }
}

/* Seeks to the start of the round: first parses the seconds of the replay, and then simulates its
 * ticks. The work per frame is limited so that the kiosk's own ticks are not delayed. */
static void seek(struct score_playback *playback, const struct hal_clock *stopwatch,
                 const struct ranking *ranking)
{
    const uint64_t begin_ns = hal_now_ns(*stopwatch);
    uint64_t spent_ns = 0;
    for (uint32_t i = 0; i < SCORE_PLAYBACK_SEEK_TICKS && spent_ns < SCORE_PLAYBACK_SEEK_NS &&
                         playback->state == PLAYBACK_SEEKS;
         i++) {
        bool is_over = false;
        if (!playback->has_play) {
            /* Parses one recorded second. */
            const int more = replay_verifier_read(&playback->verifier);
            playback->has_play = more == 0;
            is_over = more < 0;
        } else if (replay_verifier_is_at_round(&playback->verifier)) {
            playback->state = PLAYBACK_PLAYS;
        } else {
            is_over = !replay_verifier_tick(&playback->verifier);
        }
        if (is_over) {
            set_result(playback, ranking);
        }
        spent_ns = hal_now_ns(*stopwatch) - begin_ns;
    }
}

void score_playback_frame(struct score_playback *playback, const struct hal *hal,
                          const struct hal_clock *stopwatch, const struct ranking *ranking,
                          uint32_t tick_count)
{
    const bool waits = playback->state == PLAYBACK_SEEKS && !playback->is_open;
    if (waits || playback->is_requested) {
        fetch_score_replay(playback, &hal->storage, ranking);
    } else if (playback->state == PLAYBACK_SEEKS) {
        seek(playback, stopwatch, ranking);
    } else if (playback->state == PLAYBACK_PLAYS) {
        for (uint32_t i = 0; i < tick_count && playback->state == PLAYBACK_PLAYS; i++) {
            if (!replay_verifier_tick(&playback->verifier)) {
                set_result(playback, ranking);
            }
        }
    } else if (playback->state != PLAYBACK_OFF) {
        playback->end_ticks += tick_count;
        if (playback->end_ticks >= SCORE_PLAYBACK_END_TICKS) {
            score_playback_end(playback);
        }
    }
}

void score_playback_show(const struct score_playback *playback, struct scene *scene,
                         struct output *output)
{
    const struct replay_verifier *verifier = &playback->verifier;
    scene->playback = playback->state;
    scene->playback_progress = 0.0f;
    if (playback->state == PLAYBACK_OFF) {
        return;
    }
    output->sound_count = 0; /* The sounds of the kiosk's own game are dropped during a playback. */
    if (playback->state == PLAYBACK_SEEKS && playback->has_play) {
        scene->playback_progress =
            (float)verifier->replayer.totals.ticks / (float)(verifier->round_tick + 1u);
    }
    if (playback->state != PLAYBACK_SEEKS && playback->has_play) {
        const uint8_t language = scene->language;
        core_scene(&verifier->core, scene);
        scene->language = language; /* The playback is shown in the language of the operator's menu,
                                       because the operator watches the playback. */
    }
    if (playback->state == PLAYBACK_PLAYS) {
        output->sound_count = verifier->output.sound_count;
        memcpy(output->sounds, verifier->output.sounds, sizeof output->sounds);
    }
}
