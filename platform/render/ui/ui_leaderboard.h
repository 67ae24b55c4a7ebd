/* ui_leaderboard.h -- draws the leaderboard as a sheet of paper over the tank. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_LEADERBOARD_H
#define KINGYO_PLATFORM_RENDER_UI_UI_LEADERBOARD_H

#include "platform/render/ui/ui_widgets.h"

/* Returns the visible fraction of the leaderboard, which fades in and out, [0, 1]. 0 means
 * hidden. */
float ui_leaderboard_in(const struct scene_leaderboard *board);

/* Draws the leaderboard, vertically centred between `top` and `bottom` in pixels. Draws nothing
 * while the leaderboard is hidden. */
void ui_leaderboard(const struct ui_frame *frame, const struct scene_leaderboard *board, float top,
                    float bottom);

/* Draws the seal "Genuine", which means that the recording of a round is stored and can verify the
 * score. The seal is centred at (x, y) and is `size` pixels wide and high. */
void ui_genuine_seal(const struct ui_frame *frame, float x, float y, float size);

/* Returns the key of the text "Today's best" or of the corresponding text for another leaderboard
 * period (enum rank_period). */
enum text_key ui_leaderboard_key(uint8_t period);
/* Returns the key of the text "No. {} today" or of the corresponding text for another leaderboard
 * period (enum rank_period). */
enum text_key ui_place_key(uint8_t period);

#endif
