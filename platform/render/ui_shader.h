/* ui_shader.h -- the user interface's one shader; `kind` and `shape` are told in ui_batch.h. */
#ifndef KINGYO_PLATFORM_RENDER_UI_SHADER_H
#define KINGYO_PLATFORM_RENDER_UI_SHADER_H

extern const char *const ui_vertex_source;
extern const char *const ui_fragment_source;

#endif
