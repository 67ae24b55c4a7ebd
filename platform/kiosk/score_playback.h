/* score_playback.h -- plays back a score on the screen.
 *
 * Loads the score's replay from the store, seeks to its round and shows the round. At the end the
 * replay verifier's result is shown. The kiosk itself continues in the background. Any button or a
 * dip ends the playback. The caller owns `struct score_playback` (4.5 MB: static storage) and
 * clears it. */
#ifndef KINGYO_PLATFORM_KIOSK_SCORE_PLAYBACK_H
#define KINGYO_PLATFORM_KIOSK_SCORE_PLAYBACK_H

#include "core/scene.h"
#include "platform/hal.h"
#include "platform/kiosk/replay_verifier.h"
#include "platform/kiosk/session_recorder.h"

#define SCORE_PLAYBACK_END_TICKS (10u * CORE_TICK_HZ) /* Time for which the result is shown. */
/* Time of a frame spent on seeking: at least 40 ticks on a desktop computer. */
#define SCORE_PLAYBACK_SEEK_NS 10000000ull
/* Limit of ticks or seconds read per frame, for the case that the clock stops. */
#define SCORE_PLAYBACK_SEEK_TICKS 240u

struct score_playback {
    uint8_t state;    /* enum scene_encore */
    uint8_t is_asked; /* 1: the store is loading the replay. */
    uint8_t is_open;  /* 1: the verifier has opened the replay. */
    uint8_t has_play; /* 1: the verifier has parsed the replay, and there is a picture to show. */
    uint32_t round_id;
    uint32_t end_ticks;       /* Ticks since the result. */
    float hand_y_m[POI_MAX];  /* Previous height of each poi, to detect a dip. */
    struct ledger_entry kept; /* The round's entry on disk. */
    struct replay_verifier judge;
    uint8_t bytes[SESSION_RECORDER_SIZE];
};

/* Starts a playback in place of the current one. If the store is busy, the request is repeated each
 * frame. */
void score_playback_request(struct score_playback *playback, uint32_t round_id);

/* Handles input during a playback. `pressed`: buttons. Returns 1 if the input ends the playback. */
int score_playback_handle_input(struct score_playback *playback, uint32_t pressed,
                                const struct poi_input poi[POI_MAX]);

/* Advances the playback by `tick_count` ticks. Call once a frame. score_playback_show() replaces
 * the sounds of `output`, and once the round runs also the picture of `scene`. */
void score_playback_frame(struct score_playback *playback, const struct hal *hal,
                          const struct hal_clock *stopwatch, const struct ranking *ranking,
                          uint32_t tick_count);
void score_playback_show(const struct score_playback *playback, struct scene *scene,
                         struct output *output);

/* Ends the playback at once. */
void score_playback_end(struct score_playback *playback);

#endif
