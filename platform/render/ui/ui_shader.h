/* ui_shader.h -- the user interface's shaders, one small program for each enum ui_kind.
 *
 * A single program with branches would be simpler. However, a software renderer executes every
 * branch for every pixel, and separate programs draw the same screens at a fraction of the cost. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_SHADER_H
#define KINGYO_PLATFORM_RENDER_UI_UI_SHADER_H

#include "platform/render/ui/ui_batch.h"

extern const char *const ui_vertex_source;

/* Source code at the start of every fragment shader in ui_fragment_sources: inputs and shared
 * functions. Macros FONT_EDGE and FONT_STEP must be defined before this code. */
extern const char *const ui_fragment_head;
extern const char *const ui_fragment_sources[UI_KIND_COUNT];

#endif
