/* ui_menu.h -- the operator's menu's screen, in parts: what its files share.
 *
 * Everything lies on the core's canvas (core/game/overlay.h), where the hand finds it. */
#ifndef KINGYO_PLATFORM_RENDER_UI_MENU_H
#define KINGYO_PLATFORM_RENDER_UI_MENU_H

#include "core/game/menu_pages.h"
#include "platform/render/ui_parts.h"
#include "platform/render/ui_signs.h"

#define MENU_INK 0x2a160cffu
#define MENU_INK_SOFT 0x4a2f1cffu
#define MENU_CREAM 0xfff6e2ffu

struct menu_view {
    struct ui_frame frame; /* `unit` is one of the canvas. */
    const struct scene_menu *menu;
    const struct scene_devices *devices;
    float x, y;            /* The canvas' corner on the screen. */
};

/* A box of the canvas on the screen. */
struct ui_box menu_place(const struct menu_view *view, struct overlay_box box);

/* A tag's own place; empty when it is not offered. */
struct ui_box menu_tag_place(const struct menu_view *view, uint32_t tag);

/* The words of a key in the screen's language. */
const char *menu_text(const struct menu_view *view, enum text_key key);

/* Letters of so many canvas units in the common font; 22 is the smallest that is read from a
 * metre. */
struct ui_text menu_style(const struct menu_view *view, float size, uint32_t fill);

/* The same with a brush in Japanese, and as on a stall's board else. */
struct ui_text menu_brush(const struct menu_view *view, float size, uint32_t fill);

/* How many bytes of `words` fill a line of `room_px`: up to its last gap, or to its last whole
 * character where there is none. At least one character. */
size_t menu_fill_line(const struct ui_text *style, const char *words, float room_px);

/* What each page shows beside its tags' names. */
void menu_rows(const struct menu_view *view);
void menu_one_controller(const struct menu_view *view);
void menu_learning(const struct menu_view *view);
void menu_lines(const struct menu_view *view);
void menu_files(const struct menu_view *view);

#endif
