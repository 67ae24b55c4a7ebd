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
    const struct scene *scene;
    const struct scene_menu *menu; /* The scene's. */
    const struct scene_devices *devices;
    float x, y;            /* The canvas' corner on the screen. */
};

/* What a page is called, what its tags are called, and what else it shows. */
struct menu_words {
    enum text_key title, about;             /* On its tag at its parent: its name, and a line. */
    enum text_key foot[MENU_FOOT_MAX];      /* Of the tags at its foot, in their order. */
    enum text_key names[8], lines[8];       /* Of those that hang and lead to no page. */
    void (*draw)(const struct menu_view *view); /* Null: nothing but its body. */
    uint8_t is_whole; /* What it draws is all of the picture, with nothing but tags over it. */
};
const struct menu_words *menu_words_of(uint8_t page);

#define SETTING_CHOICES_MAX 4u

/* What a setting is called, and its values. A key of 0 is none: nothing here is the title. */
struct setting_words {
    enum text_key name, help;
    enum text_key unit, zero, one; /* "{} min"; and what 0 and 1 mean where that has a word. */
    enum text_key choices[SETTING_CHOICES_MAX];
};
const struct setting_words *menu_setting_words_of(uint32_t id);

/* "5 min", "never", "18:30": what a value of a setting is. */
void menu_value_words(const struct menu_view *view, uint32_t id, int32_t value, char *out,
                      size_t out_size);

/* "free / paid / event    standard free": what a value may be, and what it was. */
void menu_range_words(const struct menu_view *view, uint32_t id, char *out, size_t out_size);

/* A box of the canvas on the screen. */
struct ui_box menu_place(const struct menu_view *view, struct overlay_box box);

/* A tag's own place; empty when it is not offered. */
struct ui_box menu_tag_place(const struct menu_view *view, uint32_t tag);

/* Draws a tag's bare board, and says where: it sinks a little under the hand that presses it. */
struct ui_box menu_tag_board(const struct menu_view *view, uint32_t tag);

/* The words of a key in the screen's language. */
const char *menu_text(const struct menu_view *view, enum text_key key);

/* Letters of so many canvas units in the common font; 22 is the smallest that is read from a
 * metre. */
struct ui_text menu_style(const struct menu_view *view, float size, uint32_t fill);

/* The same with a brush in Japanese, and as on a stall's board else. */
struct ui_text menu_brush(const struct menu_view *view, float size, uint32_t fill);

/* Words that begin (align 0), are in the middle (0.5) or end (1) at `x`, in the middle of `y`, and
 * shrink to `room`; all in pixels. */
void menu_words_at(const struct menu_view *view, float x, float y, float room, float align,
                   const struct ui_text *style, const char *words);

/* The keeper's seal, in vermilion: what stands beside it is not as it came. */
void menu_seal(const struct menu_view *view, float x, float y);

/* How many bytes of `words` fill a line of `room_px`: up to its last gap, or to its last whole
 * character where there is none. At least one character. */
size_t menu_fill_line(const struct ui_text *style, const char *words, float room_px);

/* What each page shows beside its tags' names. */
void menu_settings(const struct menu_view *view);
void menu_bits(const struct menu_view *view);
void menu_rows(const struct menu_view *view);
void menu_one_controller(const struct menu_view *view);
void menu_learning(const struct menu_view *view);
void menu_lines(const struct menu_view *view);
void menu_files(const struct menu_view *view);
void menu_axes(const struct menu_view *view);
void menu_self_test(const struct menu_view *view);
void menu_calibration(const struct menu_view *view);
void menu_earnings(const struct menu_view *view);
void menu_plays(const struct menu_view *view);
void menu_hours(const struct menu_view *view);
void menu_machine(const struct menu_view *view);
void menu_sure(const struct menu_view *view);
void menu_about(const struct menu_view *view);
void menu_card(const struct menu_view *view);
void menu_pin(const struct menu_view *view);
void menu_ranking(const struct menu_view *view);
void menu_score(const struct menu_view *view);

#endif
