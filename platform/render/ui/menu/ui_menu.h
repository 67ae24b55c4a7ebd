/* ui_menu.h -- functions and types that the source files of the operator's menu share.
 *
 * All coordinates are on the core's canvas (core/game/pointer_mapping.h), which is the layout area
 * in which the pointer also moves. The drawing context of each function is the canvas
 * (ui_canvas()). */
#pragma once

#include "core/game/menu/menu_pages.h"
#include "platform/render/ui/ui_primitives.h"
#include "platform/render/ui/ui_widgets.h"

#define MENU_INK 0x2a160cffu
#define MENU_INK_SOFT 0x40260fffu
#define MENU_NOTE 0xc9d2eeffu /* Colour of a note on the darkened tank. */
#define MENU_GOOD 0x17754effu
#define MENU_BAD 0xb3261effu
/* Inks of words on the wood of a board, which have the contrast of small text: a value that was
 * changed or a count of faults, and a function that is switched on. */
#define MENU_INK_CHANGED 0x6c0b06ffu
#define MENU_INK_ON 0x0b3d26ffu

/* Texts of a page and of its tags, and the function that draws the page. */
struct menu_words {
    /* Name of the page (`title`) and description of the page (`about`). The tag that leads to the
     * page shows both texts. */
    enum text_key title, about;
    enum text_key foot[MENU_FOOT_MAX]; /* Texts of the tags at the bottom of the page, in order. */
    /* Names (`names`) and descriptions (`lines`) of the page's large tags that lead to no other
     * page. */
    enum text_key names[8], lines[8];
    /* Function that draws the page. Null means that the page consists only of tags. */
    void (*draw)(const struct ui_frame *frame);
    /* True if the page covers the whole picture and only its tags are drawn over it. */
    bool is_whole;
};
const struct menu_words *menu_words_of(uint8_t page);

#define SETTING_CHOICES_MAX 5u

/* Texts of a setting and of its values. Key 0 means no text, because key 0 is the game's title,
 * which no setting uses. */
struct setting_words {
    enum text_key name, help;
    /* `unit` is the text pattern of the value, such as "{} min". `zero` is the text that replaces
     * the value 0, and `one` is the text that replaces the value 1. */
    enum text_key unit, zero, one;
    enum text_key choices[SETTING_CHOICES_MAX];
};
const struct setting_words *menu_setting_words_of(uint32_t id);

/* Writes the range and the default of a setting as a text. For example, the text is "free / paid /
 * event standard free" if "free" is the default. */
void menu_range_words(const struct ui_frame *frame, uint32_t id, char *out, size_t out_size);

/* Returns the box of a tag on the screen. The box is empty if the tag cannot be selected now. */
struct ui_box menu_tag_place(const struct ui_frame *frame, uint32_t tag);

/* Draws a tag without text and returns its box. The box is slightly lower while the tag is
 * pressed. */
struct ui_box menu_tag_board(const struct ui_frame *frame, uint32_t tag);

/* Draws a sheet of paper as the background of texts. */
void menu_paper(const struct ui_frame *frame, struct ui_box box);

/* Draws a line of text at the centre of a box on the canvas: `upright` on the canvas for portrait
 * screens, otherwise `wide`. The text is shrunk to the width of the box. */
void menu_note(const struct ui_frame *frame, struct layout_box wide, struct layout_box upright,
               struct ui_text style, const char *words);

/* Returns the style of a large word (ui_brush()). `size` is the size in canvas units of a Japanese
 * word. */
struct ui_text menu_brush(const struct ui_frame *frame, float size, uint32_t fill);

/* Draws the operator's vermilion seal, which marks a setting whose value differs from its
 * default. */
void menu_seal(const struct ui_frame *frame, float x, float y);

/* Returns how many bytes of `words` fit on one line of `room_px` pixels. The line ends at the last
 * space that fits, or after the last whole character if no space fits. The line has at least one
 * character. */
size_t menu_fill_line(struct ui_text style, const char *words, float room_px);

/* Copies the bytes of `*words` that fit on one line of `room_px` pixels to `out`, and advances
 * `*words` past these bytes. If `is_last` is true, copies the complete remaining text, which the
 * caller shrinks to fit. A line that is too long for `out` is cut. */
void menu_take_line(struct ui_text style, const char **words, float room_px, bool is_last,
                    char *out, size_t out_size);

/* Declarations of functions that each draw the content of one page beside the page's tags. */
void menu_settings(const struct ui_frame *frame);
void menu_bits(const struct ui_frame *frame);
void menu_rows(const struct ui_frame *frame);
void menu_one_controller(const struct ui_frame *frame);
void menu_learning(const struct ui_frame *frame);
void menu_lines(const struct ui_frame *frame);
void menu_update(const struct ui_frame *frame);
void menu_files(const struct ui_frame *frame);
void menu_axes(const struct ui_frame *frame);
void menu_self_test(const struct ui_frame *frame);
void menu_calibration(const struct ui_frame *frame);
void menu_earnings(const struct ui_frame *frame);
void menu_plays(const struct ui_frame *frame);
void menu_hours(const struct ui_frame *frame);
void menu_machine(const struct ui_frame *frame);
void menu_confirm(const struct ui_frame *frame);
void menu_about(const struct ui_frame *frame);
void menu_card(const struct ui_frame *frame);
void menu_pin(const struct ui_frame *frame);
void menu_ranking(const struct ui_frame *frame);
void menu_score(const struct ui_frame *frame);
