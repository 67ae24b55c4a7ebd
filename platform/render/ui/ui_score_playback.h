/* ui_score_playback.h -- draws the fade between two sessions, and the ribbon of a score playback. A
 * score playback shows the recording of a round. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_SCORE_PLAYBACK_H
#define KINGYO_PLATFORM_RENDER_UI_UI_SCORE_PLAYBACK_H

#include "core/scene.h"
#include "platform/render/ui/ui_primitives.h"

/* Darkens the tank during the fade. Call before drawing text. Draws nothing while the tank has full
 * brightness. */
void ui_score_playback_fade(const struct ui_frame *frame, const struct scene *scene);

/* Draws the ribbon of a score playback over all other drawings. Draws nothing if no score playback
 * runs. */
void ui_score_playback(const struct ui_frame *frame, const struct scene *scene);

#endif
