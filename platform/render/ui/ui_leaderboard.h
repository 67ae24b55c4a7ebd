/* ui_leaderboard.h -- the leaderboard as a sheet of paper over the tank. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_LEADERBOARD_H
#define KINGYO_PLATFORM_RENDER_UI_UI_LEADERBOARD_H

#include "platform/render/ui/ui_widgets.h"

/* Returns how far the leaderboard has appeared, [0, 1]; 0: not shown. */
float ui_leaderboard_in(const struct scene_leaderboard *board);

/* Draws the leaderboard centred between the heights `top` and `bottom`, in pixels. Draws nothing
 * while it is not shown. */
void ui_leaderboard(const struct ui_frame *frame, const struct scene_leaderboard *board, float top,
                    float bottom);

/* Draws the seal "Genuine", which shows that the replay of a score is stored. Centred at (x, y),
 * `size` px wide and high. */
void ui_genuine_seal(const struct ui_frame *frame, float x, float y, float size);

/* Return the keys of "Today's best" and of "No. {} today" for a leaderboard period (enum
 * rank_period). */
enum text_key ui_leaderboard_key(uint8_t period);
enum text_key ui_place_key(uint8_t period);

#endif
