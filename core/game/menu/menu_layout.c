/* menu_layout.c -- computes the positions of the items of a page. The pointer code and the renderer
 * share the positions. */
#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "core/game/menu/menu_pages.h"

/* Sizes and distances that differ between the wide and the portrait canvas. */
struct measures {
    struct layout_box body;
    uint32_t hung_max;                                  /* Largest number of large items side by
                                                           side. */
    float hung_width, hung_height, hung_gap, hung_drop; /* Size and distance of large items.
                                                           `hung_drop` is the space above the
                                                           next row for the pole on which its
                                                           tags hang. */
    float row_height, row_pitch;
    float settings_height; /* Height of the settings in the body. A help text is below the
                              settings. */
    uint32_t key_columns;
    float key_top, key_width, key_height, key_gap;
    float foot_y, foot_width, foot_height, foot_gap;
};

static const struct measures wide = {
    .body = { 130.0f, 124.0f, 1020.0f, 464.0f },
    .hung_max = 4,
    .hung_width = 282.0f,
    .hung_height = 172.0f,
    .hung_gap = 26.0f,
    .hung_drop = 60.0f,
    .row_height = 52.0f,
    .row_pitch = 58.0f,
    .settings_height = 428.0f,
    .key_columns = 5,
    .key_top = 262.0f,
    .key_width = 150.0f,
    .key_height = 130.0f,
    .key_gap = 26.0f,
    .foot_y = 610.0f,
    .foot_width = 250.0f,
    .foot_height = 66.0f,
    .foot_gap = 24.0f,
};
static const struct measures upright_measures = {
    .body = { 27.0f, 200.0f, 800.0f, 1040.0f },
    .hung_max = 2,
    .hung_width = 372.0f,
    .hung_height = 200.0f,
    .hung_gap = 30.0f,
    .hung_drop = 72.0f,
    .row_height = 112.0f,
    .row_pitch = 128.0f,
    .settings_height = 912.0f,
    .key_columns = 3,
    .key_top = 420.0f,
    .key_width = 210.0f,
    .key_height = 160.0f,
    .key_gap = 36.0f,
    .foot_y = 1262.0f,
    .foot_width = 250.0f,
    .foot_height = 86.0f,
    .foot_gap = 20.0f,
};

/* Returns the number of available items from `first` up to, but not including, `limit`. */
static uint32_t count_offered(uint16_t offered, uint32_t first, uint32_t limit)
{
    uint32_t count = 0;
    for (uint32_t tag = first; tag < limit; tag++) {
        count += offered >> tag & 1u;
    }
    return count;
}

/* Returns the box of large item `nth` of `count`. The items lie in as few rows as possible, and
 * each row is centred. */
static struct layout_box hung_box(const struct measures *m, uint32_t nth, uint32_t count)
{
    const uint32_t rows = (count + m->hung_max - 1u) / m->hung_max;
    const uint32_t row = nth / m->hung_max, column = nth % m->hung_max;
    const uint32_t left = count - row * m->hung_max;
    const float in_row = (float)(left < m->hung_max ? left : m->hung_max);
    const float width = in_row * m->hung_width + (in_row - 1.0f) * m->hung_gap;
    const float pitch = m->hung_height + m->hung_drop;
    const float height = (float)rows * pitch - m->hung_drop;
    return (struct layout_box){
        m->body.x + 0.5f * (m->body.width - width) + (float)column * (m->hung_width + m->hung_gap),
        m->body.y + 0.5f * (m->body.height - height) + (float)row * pitch,
        m->hung_width,
        m->hung_height,
    };
}

/* Returns the box of item `nth` at the foot of the page. All items at the foot lie in one row and
 * share its width equally. */
static struct layout_box foot_box(const struct measures *m, int upright, uint32_t nth,
                                  uint32_t count)
{
    const float gaps = (float)(count - 1u) * m->foot_gap;
    const float width = f_min(m->foot_width, (m->body.width - gaps) / (float)count);
    const float row = (float)count * width + gaps;
    return (struct layout_box){
        0.5f * (pointer_layout_size(upright).x - row) + (float)nth * (width + m->foot_gap),
        m->foot_y,
        width,
        m->foot_height,
    };
}

/* Returns the box of digit key `nth`. The last row may have fewer keys and is centred. */
static struct layout_box key_box(const struct measures *m, uint32_t nth, uint32_t count)
{
    const uint32_t row = nth / m->key_columns, column = nth % m->key_columns;
    const uint32_t left = count - row * m->key_columns;
    const float in_row = (float)(left < m->key_columns ? left : m->key_columns);
    const float width = in_row * m->key_width + (in_row - 1.0f) * m->key_gap;
    return (struct layout_box){
        m->body.x + 0.5f * (m->body.width - width) + (float)column * (m->key_width + m->key_gap),
        m->key_top + (float)row * (m->key_height + m->key_gap),
        m->key_width,
        m->key_height,
    };
}

/* Returns the box of row `nth`. With many rows each row is lower than normal. */
static struct layout_box row_box(const struct measures *m, float height, uint32_t nth,
                                 uint32_t count)
{
    const float pitch = f_min(m->row_pitch, height / (float)count);
    return (struct layout_box){ m->body.x, m->body.y + (float)nth * pitch, m->body.width,
                                pitch * m->row_height / m->row_pitch };
}

struct layout_box menu_box(int upright, uint8_t page, uint16_t offered, uint32_t tag)
{
    const struct menu_page_desc *sheet = menu_page_desc_of(page);
    const struct measures *m = upright ? &upright_measures : &wide;
    CORE_ASSERT(tag < menu_tag_count(page));
    if (!(offered >> tag & 1u)) {
        return (struct layout_box){ 0.0f, 0.0f, 0.0f, 0.0f };
    }
    const uint32_t body_count = menu_body_count(page);
    if (tag >= body_count) {
        return foot_box(m, upright, count_offered(offered, body_count, tag),
                        count_offered(offered, body_count, menu_tag_count(page)));
    }
    switch (sheet->body) {
    case MENU_BODY_TILES:
    case MENU_BODY_PAGES:
        return hung_box(m, count_offered(offered, 0, tag), count_offered(offered, 0, body_count));
    case MENU_BODY_SETTINGS:
    case MENU_BODY_BITS:
        return row_box(m, m->settings_height, tag, body_count);
    case MENU_BODY_KEYS:
        return key_box(m, tag, body_count);
    default:
        return row_box(m, m->body.height, tag, body_count);
    }
}
