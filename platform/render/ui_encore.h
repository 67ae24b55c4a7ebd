/* ui_encore.h -- the dark between two chapters, and what is said of a score that is shown again. */
#ifndef KINGYO_PLATFORM_RENDER_UI_ENCORE_H
#define KINGYO_PLATFORM_RENDER_UI_ENCORE_H

#include "core/scene.h"
#include "platform/render/ui_parts.h"

/* Over the tank and under all words; nothing while the tank is in the light. */
void ui_chapter_veil(const struct ui_frame *frame, const struct scene *scene);

/* Over everything; nothing while none is shown. */
void ui_encore(const struct ui_frame *frame, const struct scene *scene);

#endif
