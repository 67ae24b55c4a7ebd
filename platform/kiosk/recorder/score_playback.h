/* score_playback.h -- plays back the replay of a score on the screen.
 *
 * Loads the score's replay from the store, seeks to the score's round and shows the round. At the
 * end, shows the result of the replay verifier. The kiosk itself continues in the background. Any
 * button, or a dip of a poi, ends the playback. The caller owns `struct score_playback` (4.5 MB:
 * static storage) and initializes it to zero. */
#pragma once

#include "core/scene.h"
#include "platform/hal.h"
#include "platform/kiosk/recorder/replay_verifier.h"
#include "platform/kiosk/recorder/session_recorder.h"

/* Ticks for which the result of the verification is shown. */
#define SCORE_PLAYBACK_END_TICKS (10u * CORE_TICK_HZ)
/* Maximum time per frame for seeking. A desktop computer runs at least 40 ticks in this time. */
#define SCORE_PLAYBACK_SEEK_NS 10000000ull
/* Maximum number of parsed seconds or simulated ticks per frame. The limit ends the seek loop if
 * the clock stops. */
#define SCORE_PLAYBACK_SEEK_TICKS 240u

struct score_playback {
    uint8_t state;     /* State of the playback (enum scene_playback). */
    bool is_requested; /* True while the store loads the replay. */
    bool is_open;      /* True if the verifier has opened the replay. */
    /* True if the verifier has parsed the whole replay, so that the scene can be drawn. */
    bool has_play;
    uint32_t round_id;
    /* Ticks since the end of the playback, during which the result is shown. */
    uint32_t end_ticks;
    float hand_y_m[POI_MAX];  /* Previous height of each poi in metres, to detect a dip. */
    struct ledger_entry kept; /* Stored ledger entry of the round. */
    struct replay_verifier verifier;
    uint8_t bytes[SESSION_RECORDER_SIZE];
};

/* Starts the playback of a round and ends the current playback. If the store is busy, the replay is
 * requested again in each frame. The function has no effect while the store loads a replay. */
void score_playback_request(struct score_playback *playback, uint32_t round_id);

/* Handles input during a playback. `pressed` is the bit set of the pressed buttons. Returns true
 * if the input ends the playback. */
bool score_playback_handle_input(struct score_playback *playback, uint32_t pressed,
                                 const struct poi_input poi[POI_MAX]);

/* score_playback_frame() advances the playback by `tick_count` ticks; call it once per frame.
 * score_playback_show() replaces the sounds of `output`. After the playback has reached the start
 * of the round, score_playback_show() also replaces `scene`. */
void score_playback_frame(struct score_playback *playback, const struct hal *hal,
                          const struct hal_clock *stopwatch, const struct ranking *ranking,
                          uint32_t tick_count);
void score_playback_show(const struct score_playback *playback, struct scene *scene,
                         struct output *output);

/* Ends the playback immediately. */
void score_playback_end(struct score_playback *playback);
