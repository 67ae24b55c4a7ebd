/* ui_menu.h -- what the files of the operator's menu share.
 *
 * All coordinates are on the core's canvas (core/game/pointer_mapping.h), which the pointer uses as
 * well. */
#ifndef KINGYO_PLATFORM_RENDER_UI_MENU_UI_MENU_H
#define KINGYO_PLATFORM_RENDER_UI_MENU_UI_MENU_H

#include "core/game/menu/menu_pages.h"
#include "platform/render/ui/ui_primitives.h"
#include "platform/render/ui/ui_widgets.h"

#define MENU_INK 0x2a160cffu
#define MENU_INK_SOFT 0x4a2f1cffu
#define MENU_CREAM 0xfff6e2ffu

struct menu_view {
    struct ui_frame frame; /* Frame whose `unit` is one canvas unit. */
    const struct scene *scene;
    const struct scene_menu *menu; /* Menu of `scene`. */
    const struct scene_devices *devices;
    float x, y; /* Position of the canvas' corner on the screen. */
};

/* The texts of a page and of its tags, and its drawing function. */
struct menu_words {
    enum text_key title, about;        /* Texts of the page's tag in its parent: a name and a
                                          line. */
    enum text_key foot[MENU_FOOT_MAX]; /* Texts of the tags at its foot, in their order. */
    enum text_key names[8], lines[8];  /* Texts of hanging tags that lead to no page. */
    void (*draw)(const struct menu_view *view); /* Null: the page draws only its tags. */
    uint8_t is_whole; /* The page's drawing covers the whole picture, with only tags over it. */
};
const struct menu_words *menu_words_of(uint8_t page);

#define SETTING_CHOICES_MAX 4u

/* The texts of a setting and of its values. A key of 0 means none, because key 0 is the title,
 * which is not used here. */
struct setting_words {
    enum text_key name, help;
    enum text_key unit, zero, one; /* Pattern such as "{} min", and the words for the values 0 and
                                      1, if any. */
    enum text_key choices[SETTING_CHOICES_MAX];
};
const struct setting_words *menu_setting_words_of(uint32_t id);

/* Writes a setting's value, such as "5 min", "never" or "18:30". */
void menu_value_words(const struct menu_view *view, uint32_t id, int32_t value, char *out,
                      size_t out_size);

/* Writes a setting's range and default, such as "free / paid / event    standard free". */
void menu_range_words(const struct menu_view *view, uint32_t id, char *out, size_t out_size);

/* Returns the screen position of a canvas box. */
struct ui_box menu_place(const struct menu_view *view, struct layout_box box);

/* Returns a tag's own box; empty when the tag is not available. */
struct ui_box menu_tag_place(const struct menu_view *view, uint32_t tag);

/* Draws a tag's blank board and returns its box, slightly lower while the tag is pressed. */
struct ui_box menu_tag_board(const struct menu_view *view, uint32_t tag);

/* Returns the text of a key in the screen's language. */
const char *menu_text(const struct menu_view *view, enum text_key key);

/* Returns a text style of `size` canvas units in the common font. Size 22 is the smallest that is
 * readable from a metre. */
struct ui_text menu_style(const struct menu_view *view, float size, uint32_t fill);

/* Same as menu_style(), in a brush font for Japanese and in the stall's font otherwise. */
struct ui_text menu_brush(const struct menu_view *view, float size, uint32_t fill);

/* Draws text that begins (align 0), is centred (0.5) or ends (1) at `x`, vertically centred on `y`,
 * and shrinks to `room`; all in pixels. */
void menu_words_at(const struct menu_view *view, float x, float y, float room, float align,
                   const struct ui_text *style, const char *words);

/* Draws the operator's seal in vermilion, which marks a value that differs from its default. */
void menu_seal(const struct menu_view *view, float x, float y);

/* Returns how many bytes of `words` fill a line of `room_px`: up to the last space that fits, or up
 * to the last whole character if there is no space. At least one character. */
size_t menu_fill_line(const struct ui_text *style, const char *words, float room_px);

/* Draw the content of each page beside its tags. */
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
void menu_confirm(const struct menu_view *view);
void menu_about(const struct menu_view *view);
void menu_card(const struct menu_view *view);
void menu_pin(const struct menu_view *view);
void menu_ranking(const struct menu_view *view);
void menu_score(const struct menu_view *view);

#endif
