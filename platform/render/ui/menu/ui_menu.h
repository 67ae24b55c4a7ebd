/* ui_menu.h -- functions and types that the source files of the operator's menu share.
 *
 * All coordinates are on the core's canvas (core/game/pointer_mapping.h), which is the layout area
 * in which the pointer also moves. */
#ifndef KINGYO_PLATFORM_RENDER_UI_MENU_UI_MENU_H
#define KINGYO_PLATFORM_RENDER_UI_MENU_UI_MENU_H

#include "core/game/menu/menu_pages.h"
#include "platform/render/ui/ui_primitives.h"
#include "platform/render/ui/ui_widgets.h"

#define MENU_INK 0x2a160cffu
#define MENU_INK_SOFT 0x4a2f1cffu
#define MENU_CREAM 0xfff6e2ffu

struct menu_view {
    struct ui_frame frame; /* Drawing context of the menu. Its `unit` is the size of one canvas unit
                              in pixels. */
    const struct scene *scene;
    const struct scene_menu *menu; /* The menu of `scene`. */
    const struct scene_devices *devices;
    float x, y; /* Position of the upper left corner of the canvas on the screen, in pixels. */
};

/* Texts of a page and of its tags, and the function that draws the page. */
struct menu_words {
    enum text_key title, about;        /* Name of the page (`title`) and description of the page
                                          (`about`). The tag that leads to the page shows both
                                          texts. */
    enum text_key foot[MENU_FOOT_MAX]; /* Texts of the tags at the bottom of the page, in order. */
    enum text_key names[8], lines[8];  /* Names and descriptions of the hanging tags that lead to no
                                          page. */
    void (*draw)(const struct menu_view *view); /* Function that draws the page. Null means that the
                                                   page consists only of tags. */
    uint8_t is_whole; /* 1 if the page covers the whole picture and only its tags are drawn over it,
                         otherwise 0. */
};
const struct menu_words *menu_words_of(uint8_t page);

#define SETTING_CHOICES_MAX 4u

/* Texts of a setting and of its values. Key 0 means no text, because key 0 is the game's title,
 * which no setting uses. */
struct setting_words {
    enum text_key name, help;
    enum text_key unit, zero, one; /* `unit` is the text pattern of the value, such as "{} min".
                                      `zero` is the text that replaces the value 0, and `one` is the
                                      text that replaces the value 1. */
    enum text_key choices[SETTING_CHOICES_MAX];
};
const struct setting_words *menu_setting_words_of(uint32_t id);

/* Writes the value of a setting as a text, such as "5 min", "never" or "18:30". */
void menu_value_words(const struct menu_view *view, uint32_t id, int32_t value, char *out,
                      size_t out_size);

/* Writes the range and the default of a setting as a text, such as "free / paid / event standard
 * free". */
void menu_range_words(const struct menu_view *view, uint32_t id, char *out, size_t out_size);

/* Converts a box on the canvas to a box on the screen. */
struct ui_box menu_place(const struct menu_view *view, struct layout_box box);

/* Returns the box of a tag on the screen. The box is empty if the tag is not available. */
struct ui_box menu_tag_place(const struct menu_view *view, uint32_t tag);

/* Draws a tag without text and returns its box. The box is slightly lower while the tag is
 * pressed. */
struct ui_box menu_tag_board(const struct menu_view *view, uint32_t tag);

/* Returns the text with the key `key` in the screen's language. */
const char *menu_text(const struct menu_view *view, enum text_key key);

/* Returns a text style of `size` canvas units in the common font. Text is readable from a distance
 * of one metre if `size` is at least 22. */
struct ui_text menu_style(const struct menu_view *view, float size, uint32_t fill);

/* Returns the style of menu_style() with a decorative font: a brush font for Japanese, and the
 * festival stall's font for other languages. */
struct ui_text menu_brush(const struct menu_view *view, float size, uint32_t fill);

/* Draws text whose start (align 0), centre (0.5) or end (1) is at `x`. The text is vertically
 * centred on `y` and shrunk to the width `room`. All lengths are in pixels. */
void menu_words_at(const struct menu_view *view, float x, float y, float room, float align,
                   const struct ui_text *style, const char *words);

/* Draws the operator's vermilion seal, which marks a setting whose value differs from its
 * default. */
void menu_seal(const struct menu_view *view, float x, float y);

/* Returns how many bytes of `words` fit on one line of `room_px` pixels. The line ends at the last
 * space that fits, or after the last whole character if no space fits. The line has at least one
 * character. */
size_t menu_fill_line(const struct ui_text *style, const char *words, float room_px);

/* Copies the bytes of `*words` that fit on one line of `room_px` pixels to `out`, and advances
 * `*words` past these bytes. If `is_last` is 1, copies the complete remaining text, which the
 * caller shrinks to fit. A line that is too long for `out` is cut. */
void menu_take_line(const struct ui_text *style, const char **words, float room_px, int is_last,
                    char *out, size_t out_size);

/* Declarations of functions that each draw the content of one page beside the page's tags. */
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
