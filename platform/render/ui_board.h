/* ui_board.h -- the ranking as a sheet of paper, over the tank. */
#ifndef KINGYO_PLATFORM_RENDER_UI_BOARD_H
#define KINGYO_PLATFORM_RENDER_UI_BOARD_H

#include "platform/render/ui_signs.h"

/* [0, 1]: how far it has come; 0: there is none. */
float ui_board_in(const struct scene_board *board);

/* Centred between the heights `top` and `bottom`, in pixels; nothing where none is shown. */
void ui_board(const struct ui_frame *frame, const struct scene_board *board, float top,
              float bottom);

/* "Genuine": the replay of a score is kept. Centred at (x, y), `size` px wide and high. */
void ui_genuine_seal(const struct ui_frame *frame, float x, float y, float size);

/* "Today's best", and "No. {} today", for a period of the ranking (enum rank_period). */
enum text_key ui_board_key(uint8_t period);
enum text_key ui_place_key(uint8_t period);

#endif
