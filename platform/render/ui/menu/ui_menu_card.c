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

/* Draws a horizontal line at whole pixel positions. A line between two pixel rows would be two
 * pixels wide and half as bright. */
static void line_across(const struct ui_frame *frame, float y, float from, float to, float px,
                        uint32_t colour)
{
    ui_fill(frame, (struct ui_box){ floorf(from), floorf(y), floorf(to) - floorf(from), px },
            colour);
}

static void line_down(const struct ui_frame *frame, float x, float from, float to, float px,
                      uint32_t colour)
{
    ui_fill(frame, (struct ui_box){ floorf(x), floorf(from), px, floorf(to) - floorf(from) },
            colour);
}

/* Draws the outline of a box. The lines of the outline are inside the box. */
static void draw_card_outline(const struct ui_frame *frame, struct ui_box box, float px,
                              uint32_t colour)
{
    const float right = box.x + box.width, bottom = box.y + box.height;
    line_across(frame, box.y, box.x, right, px, colour);
    line_across(frame, bottom - px, box.x, right, px, colour);
    line_down(frame, box.x, box.y, bottom, px, colour);
    line_down(frame, right - px, box.y, bottom, px, colour);
}

/* Returns the number of grid lines from the middle of the picture to one edge, including the line
 * in the middle, at most GRID_LINES_MAX. `length` is the picture's width or height, and `side` is
 * the side of a grid square. */
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

/* Draws `count` neighbouring fields of equal width, which fill the box `band`. */
static void draw_fields(const struct ui_frame *frame, struct ui_box band, const uint32_t *colours,
                        uint32_t count)
{
    CORE_ASSERT(count > 0);
    const float width = band.width / (float)count;
    for (uint32_t i = 0; i < count; i++) {
        const float from = floorf(band.x + (float)i * width);
        const float to = floorf(band.x + (float)(i + 1u) * width);
        ui_fill(frame, (struct ui_box){ from, band.y, to - from, band.height }, colours[i]);
    }
}

/* Draws eleven greys from black to white. The black field contains two slightly lighter patches,
 * and the white field contains two slightly darker patches. */
static void greys(const struct ui_frame *frame, struct ui_box band)
{
    static const uint32_t subtle[SUBTLE_COUNT] = { 5, 10, 245, 250 };
    uint32_t colours[GREY_COUNT];
    for (uint32_t i = 0; i < GREY_COUNT; i++) {
        colours[i] = grey_of(255u * i / (GREY_COUNT - 1u));
    }
    draw_fields(frame, band, colours, GREY_COUNT);
    const float width = band.width / (float)GREY_COUNT, size = 0.25f * width;
    for (uint32_t i = 0; i < SUBTLE_COUNT; i++) {
        const float first = i < SUBTLE_COUNT / 2u ? band.x : band.x + band.width - width;
        const float x = first + (i % 2u ? 0.60f : 0.15f) * width;
        ui_fill(frame, (struct ui_box){ x, band.y + 0.5f * (band.height - size), size, size },
                grey_of(subtle[i]));
    }
}

/* Draws letters in three sizes. The sizes are in screen pixels instead of canvas units. */
static void draw_card_letters(const struct ui_frame *frame, float x, float y)
{
    static const float sizes_px[] = { 28.0f, 18.0f, 11.0f };
    for (uint32_t i = 0; i < sizeof sizes_px / sizeof sizes_px[0]; i++) {
        const struct ui_text style = { .font = FONT_BODY,
                                       .size_px = sizes_px[i],
                                       .fill = CARD_WHITE };
        ui_words_at(frame, x, y + ((float)i - 1.0f) * 28.0f, 200.0f, 0.5f, style,
                    "\xe9\x87\x91\xe9\xad\x9a 8BES");
    }
}

void menu_card(const struct ui_frame *frame)
{
    static const uint32_t bars[COLOUR_COUNT] = {
        0xc0c0c0ffu, 0xc0c000ffu, 0x00c0c0ffu, 0x00c000ffu,
        0xc000c0ffu, 0xc00000ffu, 0x0000c0ffu, 0x000000ffu
    };
    const float width = frame->width, height = frame->height;
    const float least = fminf(width, height), side = fmaxf(floorf(least / GRID_ROWS), 1.0f);
    const float x = 0.5f * width, y = 0.5f * height;
    const struct ui_box whole = { 0.0f, 0.0f, width, height };
    ui_fill(frame, whole, CARD_BLACK);
    /* The grid is drawn from the middle of the picture to the edges, so that the grid is symmetric.
     * grid_lines() limits the number of lines, because a square can be very small. */
    for (uint32_t i = 0; i < grid_lines(width, side); i++) {
        line_down(frame, x + (float)i * side, 0.0f, height, 1.0f, CARD_GREY);
        line_down(frame, x - (float)i * side, 0.0f, height, 1.0f, CARD_GREY);
    }
    for (uint32_t i = 0; i < grid_lines(height, side); i++) {
        line_across(frame, y + (float)i * side, 0.0f, width, 1.0f, CARD_GREY);
        line_across(frame, y - (float)i * side, 0.0f, width, 1.0f, CARD_GREY);
    }
    const float radius = 4.0f * side;
    ui_shape(frame->batch, &(struct ui_shape){ .box = ui_around(x, y, radius),
                                               .kind = UI_RING,
                                               .shape = { radius - 1.0f, 3.0f, 1.0f },
                                               .fill = CARD_WHITE });
    line_across(frame, y, x - radius, x + radius, 1.0f, CARD_WHITE);
    line_down(frame, x, y - radius, y + radius, 1.0f, CARD_WHITE);
    const float left = x - 3.0f * side;
    draw_fields(frame, (struct ui_box){ left, y - 2.5f * side, 6.0f * side, 1.5f * side }, bars,
                COLOUR_COUNT);
    greys(frame, (struct ui_box){ left, y + 1.0f * side, 6.0f * side, 1.5f * side });
    draw_card_letters(frame, x, y);
    for (uint32_t i = 0; i < 4u; i++) { /* The loop draws the letters in the four corners. */
        const float inset_x = SAFE * width + 90.0f, inset_y = SAFE * height + 60.0f;
        draw_card_letters(frame, i % 2u ? width - inset_x : inset_x,
                          i < 2u ? inset_y : height - inset_y);
    }
    draw_card_outline(frame,
                      (struct ui_box){ floorf(SAFE * width), floorf(SAFE * height),
                                       floorf((1.0f - 2.0f * SAFE) * width),
                                       floorf((1.0f - 2.0f * SAFE) * height) },
                      1.0f, CARD_AMBER);
    draw_card_outline(frame, whole, 2.0f, CARD_WHITE);
}
