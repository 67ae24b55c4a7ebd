/* ui_shader.h -- the user interface's shaders, one small program for each enum ui_kind.
 *
 * One program that branches would be simpler, but a software renderer runs every branch for every
 * pixel: split, the same screens cost a fraction. */
#ifndef KINGYO_PLATFORM_RENDER_UI_SHADER_H
#define KINGYO_PLATFORM_RENDER_UI_SHADER_H

#include "platform/render/ui_batch.h"

extern const char *const ui_vertex_source;

/* In front of each ui_fragment_sources[]: inputs, and what shapes have in common. It wants
 * FONT_EDGE and FONT_STEP defined. */
extern const char *const ui_fragment_head;
extern const char *const ui_fragment_sources[UI_KIND_COUNT];

#endif
