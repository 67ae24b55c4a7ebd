/* ui_menu_card.c -- draws the test card, a picture that makes faults of the screen visible.
 *
 * A white line runs along the edge of the picture. If the line is not visible at all four sides,
 * the operator must correct the overscan setting. The grid's squares and the circle look
 * undistorted if the screen's pixels are square. The card shows eight colours, eleven greys, and
 * four further greys that a badly adjusted screen shows as black or white. Letters are in the
 * middle and in the corners. The smallest letters are sharp only if the screen shows every pixel
 * separately. Four amber lines enclose the safe area for text. The distance of each amber line from
 * the picture's edge is 5 % of the picture's size. */
#include "core/base/panic.h"
#include "platform/render/ui/menu/ui_menu.h"

#include <math.h>

#define CARD_BLACK 0x000000ffu
#define CARD_GREY 0x404040ffu
#define CARD_WHITE 0xffffffffu
#define CARD_AMBER 0xffa800ffu
/* Number of grid squares from top to bottom on a landscape screen, or from left to right on an
 * upright screen. */
#define GRID_ROWS 9.0f
/* Maximum number of grid lines on each side of the middle. The number is enough for an aspect ratio
 * of 14 to 1. */
#define GRID_LINES_MAX 64u
/* Distance of the safe area from each edge, as a fraction of the picture's width or height. */
#define SAFE 0.05f
#define COLOUR_COUNT 8u
#define GREY_COUNT 11u
#define SUBTLE_COUNT 4u

static void ui_menu_card_fill_box(const struct menu_view *view, struct ui_box box, uint32_t colour)
{
    CORE_ASSERT(box.width >= 0.0f && box.height >= 0.0f);
    ui_panel(&view->frame, UI_PANEL, box, 0.0f, 0.0f, colour, 0);
}

/* Draws a horizontal line at whole pixel positions. A line between two pixel rows would be two
 * pixels wide and half as bright. */
static void line_across(const struct menu_view *view, float y, float from, float to, float px,
                        uint32_t colour)
{
    ui_menu_card_fill_box(
        view, (struct ui_box){ floorf(from), floorf(y), floorf(to) - floorf(from), px }, colour);
}

static void line_down(const struct menu_view *view, float x, float from, float to, float px,
                      uint32_t colour)
{
    ui_menu_card_fill_box(
        view, (struct ui_box){ floorf(x), floorf(from), px, floorf(to) - floorf(from) }, colour);
}

/* Draws the outline of a box. The lines of the outline are inside the box. */
static void draw_card_outline(const struct menu_view *view, struct ui_box box, float px,
                              uint32_t colour)
{
    const float right = box.x + box.width, bottom = box.y + box.height;
    line_across(view, box.y, box.x, right, px, colour);
    line_across(view, bottom - px, box.x, right, px, colour);
    line_down(view, box.x, box.y, bottom, px, colour);
    line_down(view, right - px, box.y, bottom, px, colour);
}

/* Returns the number of grid lines from the middle of the picture to one edge, including the line
 * in the middle. `length` is the picture's width or height, and `side` is the side of a grid
 * square. The maximum is GRID_LINES_MAX. */
static uint32_t grid_lines(float length, float side)
{
    CORE_ASSERT(side > 0.0f);
    const float lines = ceilf(0.5f * length / side);
    return lines < (float)GRID_LINES_MAX ? (uint32_t)lines : GRID_LINES_MAX;
}

static uint32_t grey_of(uint32_t level)
{
    return level << 24 | level << 16 | level << 8 | 0xffu;
}

/* Draws eleven greys from black to white. The black field contains two slightly lighter patches,
 * and the white field contains two slightly darker patches. */
static void greys(const struct menu_view *view, struct ui_box band)
{
    static const uint32_t subtle[SUBTLE_COUNT] = { 5, 10, 245, 250 };
    const float width = band.width / (float)GREY_COUNT;
    for (uint32_t i = 0; i < GREY_COUNT; i++) {
        const float from = floorf(band.x + (float)i * width);
        const float to = floorf(band.x + (float)(i + 1u) * width);
        ui_menu_card_fill_box(view, (struct ui_box){ from, band.y, to - from, band.height },
                              grey_of(255u * i / (GREY_COUNT - 1u)));
    }
    const float size = 0.25f * width;
    for (uint32_t i = 0; i < SUBTLE_COUNT; i++) {
        const float first = i < SUBTLE_COUNT / 2u ? band.x : band.x + band.width - width;
        const float x = first + (i % 2u ? 0.60f : 0.15f) * width;
        ui_menu_card_fill_box(
            view, (struct ui_box){ x, band.y + 0.5f * (band.height - size), size, size },
            grey_of(subtle[i]));
    }
}

/* Draws letters in three sizes. The sizes are in screen pixels instead of canvas units. */
static void draw_card_letters(const struct menu_view *view, float x, float y)
{
    static const float sizes_px[] = { 28.0f, 18.0f, 11.0f };
    for (uint32_t i = 0; i < sizeof sizes_px / sizeof sizes_px[0]; i++) {
        const struct ui_text style = { .font = FONT_BODY,
                                       .size_px = sizes_px[i],
                                       .fill = CARD_WHITE };
        menu_words_at(view, x, y + ((float)i - 1.0f) * 28.0f, 200.0f, 0.5f, &style,
                      "\xe9\x87\x91\xe9\xad\x9a 8BES");
    }
}

static void all_letters(const struct menu_view *view)
{
    const float width = view->frame.width, height = view->frame.height;
    const float x = SAFE * width + 90.0f, y = SAFE * height + 60.0f;
    draw_card_letters(view, x, y);
    draw_card_letters(view, width - x, y);
    draw_card_letters(view, x, height - y);
    draw_card_letters(view, width - x, height - y);
}

void menu_card(const struct menu_view *view)
{
    const float width = view->frame.width, height = view->frame.height;
    const float least = fminf(width, height), side = fmaxf(floorf(least / GRID_ROWS), 1.0f);
    const float left = 0.5f * width - 3.0f * side, middle = 0.5f * height;
    const struct ui_box whole = { 0.0f, 0.0f, width, height };
    ui_menu_card_fill_box(view, whole, CARD_BLACK);
    /* The grid is drawn from the middle of the picture to the edges, so that the grid is symmetric.
     * The maximum GRID_LINES_MAX of grid_lines() ends the loops even if a square is smaller than a
     * pixel. */
    const float across = view->frame.width, down = view->frame.height;
    for (uint32_t i = 0; i < grid_lines(across, side); i++) {
        line_down(view, 0.5f * across + (float)i * side, 0.0f, down, 1.0f, CARD_GREY);
        line_down(view, 0.5f * across - (float)i * side, 0.0f, down, 1.0f, CARD_GREY);
    }
    for (uint32_t i = 0; i < grid_lines(down, side); i++) {
        line_across(view, 0.5f * down + (float)i * side, 0.0f, across, 1.0f, CARD_GREY);
        line_across(view, 0.5f * down - (float)i * side, 0.0f, across, 1.0f, CARD_GREY);
    }
    const float radius = 4.0f * side;
    const float x = 0.5f * view->frame.width, y = 0.5f * view->frame.height;
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = { x - radius, y - radius, 2.0f * radius, 2.0f * radius },
                                 .kind = UI_RING,
                                 .shape = { radius - 1.0f, 3.0f, 1.0f },
                                 .fill = CARD_WHITE });
    line_across(view, y, x - radius, x + radius, 1.0f, CARD_WHITE);
    line_down(view, x, y - radius, y + radius, 1.0f, CARD_WHITE);
    const struct ui_box band =
        (struct ui_box){ left, middle - 2.5f * side, 6.0f * side, 1.5f * side };
    static const uint32_t bars[COLOUR_COUNT] = {
        0xc0c0c0ffu, 0xc0c000ffu, 0x00c0c0ffu, 0x00c000ffu,
        0xc000c0ffu, 0xc00000ffu, 0x0000c0ffu, 0x000000ffu
    };
    const float bar_width = band.width / (float)COLOUR_COUNT;
    for (uint32_t i = 0; i < COLOUR_COUNT; i++) {
        const float from = floorf(band.x + (float)i * bar_width);
        const float to = floorf(band.x + (float)(i + 1u) * bar_width);
        ui_menu_card_fill_box(view, (struct ui_box){ from, band.y, to - from, band.height },
                              bars[i]);
    }
    greys(view, (struct ui_box){ left, middle + 1.0f * side, 6.0f * side, 1.5f * side });
    draw_card_letters(view, 0.5f * width, middle);
    all_letters(view);
    draw_card_outline(view,
                      (struct ui_box){ floorf(SAFE * width), floorf(SAFE * height),
                                       floorf((1.0f - 2.0f * SAFE) * width),
                                       floorf((1.0f - 2.0f * SAFE) * height) },
                      1.0f, CARD_AMBER);
    draw_card_outline(view, whole, 2.0f, CARD_WHITE);
}
