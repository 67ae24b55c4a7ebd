/* ui_screens.c -- what stands where in each phase of the game. */
#include "platform/render/ui_screens.h"

#include <math.h>

#include "platform/render/ui_parts.h"

#define GRADES 6u
#define HURRY_S 10.0f        /* The clock turns red. */
#define HINT_FADE_S 0.35f
#define POP_S 0.45f          /* The count jumps when a fish lands. */
#define COUNT_UP_S 1.0f      /* The result counts up to its number. */

static const uint32_t player_colours[POI_MAX] = { 0xe84a7affu, 0x4aa3e8ffu, 0xf2c14effu, 0x63c178ffu };

/* ---- Small signs ---------------------------------------------------------------------------- */

static void fish_sign(const struct ui_frame *frame, float x, float y, float width)
{
    const float height = 0.56f * width;
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { x - 0.5f * width, y - 0.5f * height, width, height },
                                 .kind = UI_FISH, .fill = 0xf2552effu, .line = 0xfff4e4ffu,
                                 .shape = { 0, 0, sinf(frame->time_s * 6.0f) } });
}

static void poi_sign(const struct ui_frame *frame, float x, float y, float radius, float paper_left,
                     uint32_t ring)
{
    const float reach = 1.5f * radius; /* The handle goes down to the right. */
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { x - reach, y - reach, 2.0f * reach, 2.0f * reach },
                                 .kind = UI_POI, .fill = ring,
                                 .shape = { radius, ui_clamp01(paper_left) } });
}

static void plate(const struct ui_frame *frame, struct ui_box box)
{
    const float u = frame->unit;
    ui_shape(frame->batch, &(struct ui_shape){ .box = box, .kind = UI_WAVES, .fill = UI_NIGHT,
                                               .line = UI_GOLD_DIM,
                                               .shape = { 0, 0, 16.0f * u, 1.5f * u } });
}

/* ---- Hints ---------------------------------------------------------------------------------- */

static const char *hint_words(uint8_t language, uint8_t hint)
{
    static const uint8_t keys[HINT_COUNT] = {
        [HINT_START] = TEXT_HINT_START,   [HINT_MOVE] = TEXT_HINT_MOVE,
        [HINT_DIP] = TEXT_HINT_DIP,       [HINT_LIFT] = TEXT_HINT_LIFT,
        [HINT_BOWL] = TEXT_HINT_BOWL,     [HINT_TILT] = TEXT_HINT_TILT,
        [HINT_SLOWLY] = TEXT_HINT_SLOWLY, [HINT_TORN] = TEXT_HINT_TORN,
        [HINT_LOST_POI] = TEXT_HINT_LOST_POI,
    };
    return text_words(language, (enum text_key)keys[hint]);
}

static void hint_ribbon(const struct ui_frame *frame, const struct scene *scene, float age_s)
{
    if (scene->hint == HINT_NONE || scene->hint >= HINT_COUNT) {
        return;
    }
    const float u = frame->unit, in = ui_smooth(0.0f, HINT_FADE_S, age_s);
    const int urgent = scene->hint == HINT_TORN || scene->hint == HINT_LOST_POI ||
                       scene->hint == HINT_LIFT;
    const struct ui_ribbon ribbon = {
        .x = 0.5f * frame->width,
        .y = frame->height - 52.0f * u + 14.0f * u * (1.0f - in),
        .size_px = 32.0f * u,
        .font = FONT_BODY,
        .fill = urgent ? 0xb8301ee8u : UI_NIGHT,
        .line = urgent ? UI_GOLD : UI_GOLD_DIM,
        .ink = 0xfff8eaffu,
        .room_px = frame->width - 32.0f * u,
    };
    frame->batch->opacity = in;
    ui_ribbon(frame, &ribbon, hint_words(scene->language, scene->hint));
    frame->batch->opacity = 1.0f;
}

/* ---- Attract -------------------------------------------------------------------------------- */

static void best_words(const struct scene *scene, char *out, size_t out_size)
{
    const enum text_key key = scene->best_today > 0 ? TEXT_BEST_TODAY : TEXT_NO_BEST;
    text_number(out, out_size, text_words(scene->language, key), scene->best_today);
}

static void best_tag(const struct ui_frame *frame, const struct scene *scene, float y)
{
    char words[TEXT_LINE_MAX];
    best_words(scene, words, sizeof words);
    const struct ui_ribbon tag = { .x = 0.5f * frame->width, .y = y, .size_px = 24.0f * frame->unit,
                                   .font = FONT_STALL, .fill = UI_NIGHT, .line = 0,
                                   .ink = UI_GOLD, .room_px = frame->width - 32.0f * frame->unit };
    ui_ribbon(frame, &tag, words);
}

static void start_ribbon(const struct ui_frame *frame, float y, enum text_key key)
{
    const float u = frame->unit, pulse = ui_pulse(frame->time_s, 2.4f);
    const struct ui_box halo = { 0.5f * frame->width - 400.0f * u, y - 64.0f * u, 800.0f * u,
                                 128.0f * u };
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = halo, .kind = UI_GLOW, .shape = { 0, 0, 1.0f },
                                 .fill = ui_fade(0xff7a30b0u, 0.25f + 0.55f * pulse) });
    const struct ui_ribbon ribbon = { .x = 0.5f * frame->width, .y = y, .size_px = 35.0f * u,
                                      .font = FONT_STALL, .fill = 0xc8341ff2u, .line = UI_GOLD,
                                      .ink = ui_fade(0xfff8eaffu, 0.82f + 0.18f * pulse),
                                      .room_px = frame->width - 32.0f * u };
    ui_ribbon(frame, &ribbon, text_words(frame->language, key));
}

static void key_lines(const struct ui_frame *frame)
{
    const float u = frame->unit;
    const struct ui_text text = { .font = FONT_BODY, .size_px = 17.0f * u, .align = 0.5f,
                                  .outline_em = 0.05f, .soft_em = 0.12f, .fill = 0xe9dcc6ffu,
                                  .line = 0x0a0814d0u, .fit_px = frame->width - 32.0f * u };
    const float x = 0.5f * frame->width;
    ui_text(frame->batch, &text, x, frame->height - 41.0f * u,
            text_words(frame->language, TEXT_MOUSE));
    ui_text(frame->batch, &text, x, frame->height - 15.0f * u,
            text_words(frame->language, TEXT_KEYS));
}

static void attract(const struct ui_frame *frame, const struct scene *scene)
{
    const float u = frame->unit;
    ui_noren(frame, 1.0f - ui_smooth(0.0f, 0.8f, scene->phase_s));
    best_tag(frame, scene, frame->height - 174.0f * u);
    start_ribbon(frame, frame->height - 108.0f * u, TEXT_START);
    key_lines(frame);
}

/* ---- Ready ---------------------------------------------------------------------------------- */

static void big_word(const struct ui_frame *frame, enum font_id font, float y, float size_px,
                     float alpha, const char *words)
{
    const struct ui_text text = { .font = font, .size_px = size_px, .align = 0.5f,
                                  .weight_em = font == FONT_BRUSH ? 0.024f : 0.0f,
                                  .spacing_em = font == FONT_BRUSH ? -0.14f : 0.0f,
                                  .outline_em = 0.014f, .soft_em = 0.035f,
                                  .fill = 0xfff6e2ffu, .line = 0x9c1f14ffu,
                                  .fit_px = frame->width - 48.0f * frame->unit };
    struct ui_text fitted = text;
    fitted.size_px = ui_text_size(&text, words);
    frame->batch->opacity = alpha;
    ui_text(frame->batch, &text, 0.5f * frame->width, ui_text_middle(&fitted, y), words);
    frame->batch->opacity = 1.0f;
}

/* The curtain rises, then three seconds run down in a ring over the water. */
static void ready(const struct ui_frame *frame, const struct scene *scene, float hint_age_s)
{
    const float u = frame->unit, x = 0.5f * frame->width, y = 0.42f * frame->height;
    const float whole = ceilf(scene->seconds_left), radius = 128.0f * u;
    const float gone = whole - scene->seconds_left; /* 0 .. 1 within this second */
    const float in = ui_smooth(0.15f, 0.5f, scene->phase_s);
    ui_noren(frame, ui_smooth(0.0f, 0.6f, scene->phase_s));
    frame->batch->opacity = in;
    const struct ui_box shade = { x - 1.8f * radius, y - 1.8f * radius, 3.6f * radius,
                                  3.6f * radius };
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = shade, .kind = UI_GLOW, .fill = 0x080c24d8u });
    const struct ui_box ring = { x - radius, y - radius, 2.0f * radius, 2.0f * radius };
    ui_shape(frame->batch, &(struct ui_shape){ .box = ring, .kind = UI_RING, .fill = UI_VERMILION,
                                               .line = 0xffffff26u,
                                               .shape = { radius, 9.0f * u, 1.0f - gone } });
    const struct ui_text word = { .font = FONT_STALL, .size_px = 46.0f * u, .align = 0.5f,
                                  .outline_em = 0.03f, .soft_em = 0.1f, .fill = 0xfff6e2ffu,
                                  .line = 0x0a0c24e0u };
    ui_text(frame->batch, &word, x, y + radius + 62.0f * u,
            text_words(frame->language, TEXT_READY));
    frame->batch->opacity = 1.0f;
    if (whole >= 1.0f) {
        const char digit[2] = { (char)('0' + (int)fminf(whole, 9.0f)), 0 };
        const float pop = 1.0f + 0.35f * (1.0f - ui_smooth(0.0f, 0.25f, gone));
        big_word(frame, FONT_STALL, y, 190.0f * u * pop, in * (1.0f - ui_smooth(0.82f, 1.0f, gone)),
                 digit);
    }
    hint_ribbon(frame, scene, hint_age_s);
}

/* ---- Round ---------------------------------------------------------------------------------- */

static void caught_plate(const struct ui_frame *frame, const struct scene *scene, float pop)
{
    const float u = frame->unit, left = 18.0f * u, top = 16.0f * u, height = 88.0f * u;
    char number[12];
    text_number(number, sizeof number, "{}", scene->caught[0]);
    const struct ui_text digits = { .font = FONT_STALL, .size_px = 68.0f * u, .fill = 0xfff8eaffu };
    const struct ui_text unit = { .font = FONT_STALL, .size_px = 34.0f * u, .fill = UI_GOLD };
    const char *words = text_words(frame->language, TEXT_UNIT);
    const float number_x = left + 108.0f * u;
    const float unit_x = number_x + ui_text_width(&digits, number) + 12.0f * u;
    const float right = unit_x + ui_text_width(&unit, words) + 22.0f * u;
    const float baseline = ui_text_middle(&digits, top + 0.5f * height);
    plate(frame, (struct ui_box){ left, top, right - left, height });
    fish_sign(frame, left + 58.0f * u, top + 0.5f * height, (74.0f + 12.0f * pop) * u);
    struct ui_text jump = digits;
    jump.size_px *= 1.0f + 0.22f * pop;
    jump.align = 0.5f;
    ui_text(frame->batch, &jump, number_x + 0.5f * ui_text_width(&digits, number),
            ui_text_middle(&jump, top + 0.5f * height), number);
    ui_text(frame->batch, &unit, unit_x, baseline, words);
}

/* The others at the tank, each a chip in the colour of their ring. */
static void other_players(const struct ui_frame *frame, const struct scene *scene)
{
    const float u = frame->unit;
    float top = 114.0f * u;
    for (uint32_t i = 1; i < POI_MAX; i++) {
        if (!scene->poi[i].present) {
            continue;
        }
        char number[12];
        text_number(number, sizeof number, "{}", scene->caught[i]);
        const struct ui_text digits = { .font = FONT_STALL, .size_px = 32.0f * u,
                                        .fill = 0xfff8eaffu };
        const float width = 66.0f * u + ui_text_width(&digits, number);
        plate(frame, (struct ui_box){ 18.0f * u, top, width, 46.0f * u });
        poi_sign(frame, 44.0f * u, top + 19.0f * u, 11.0f * u, scene->poi[i].paper_left,
                 player_colours[i]);
        ui_text(frame->batch, &digits, 68.0f * u, ui_text_middle(&digits, top + 23.0f * u), number);
        top += 52.0f * u;
    }
}

static void time_ring(const struct ui_frame *frame, const struct scene *scene, float x, float y)
{
    const float u = frame->unit, radius = 37.0f * u;
    const float total = scene->phase_s + scene->seconds_left;
    const int hurry = scene->seconds_left < HURRY_S;
    const float beat = hurry ? ui_pulse(scene->seconds_left, 1.0f) : 0.0f;
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { x - radius, y - radius, 2.0f * radius, 2.0f * radius },
                                 .kind = UI_RING,
                                 .fill = hurry ? UI_VERMILION : UI_GOLD, .line = 0xffffff28u,
                                 .shape = { radius, 6.0f * u,
                                            total > 0.0f ? scene->seconds_left / total : 0.0f } });
    char number[12];
    text_number(number, sizeof number, "{}", (uint32_t)ceilf(fmaxf(scene->seconds_left, 0.0f)));
    const struct ui_text digits = { .font = FONT_STALL, .size_px = (36.0f + 5.0f * beat) * u,
                                    .align = 0.5f, .fit_px = 56.0f * u,
                                    .fill = hurry ? 0xff9a80ffu : 0xfff8eaffu };
    struct ui_text fitted = digits;
    fitted.size_px = ui_text_size(&digits, number);
    ui_text(frame->batch, &digits, x, ui_text_middle(&fitted, y), number);
}

static void state_plate(const struct ui_frame *frame, const struct scene *scene)
{
    const float u = frame->unit, height = 88.0f * u, top = 16.0f * u, y = top + 0.5f * height;
    const struct ui_text label = { .font = FONT_STALL, .size_px = 27.0f * u, .fill = UI_GOLD,
                                   .fit_px = 88.0f * u };
    const char *paper = text_words(frame->language, TEXT_PAPER_LEFT);
    const char *time = text_words(frame->language, TEXT_TIME_LEFT);
    const float paper_width = ui_text_width(&label, paper), time_width = ui_text_width(&label, time);
    const float width = paper_width + time_width + 224.0f * u;
    const float left = frame->width - 18.0f * u - width, baseline = ui_text_middle(&label, y);
    plate(frame, (struct ui_box){ left, top, width, height });
    float x = left + 20.0f * u;
    ui_text(frame->batch, &label, x, baseline, paper);
    x += paper_width + 38.0f * u;
    poi_sign(frame, x, y - 9.0f * u, 26.0f * u, scene->poi[0].paper_left, player_colours[0]);
    x += 58.0f * u;
    ui_text(frame->batch, &label, x, baseline, time);
    time_ring(frame, scene, x + time_width + 50.0f * u, y);
}

static void play(const struct ui_frame *frame, const struct scene *scene,
                 const struct ui_memory *memory)
{
    const float since_s = (float)(scene->tick - memory->caught_tick) * CORE_TICK_S;
    const float pop = memory->caught > 0 ? 1.0f - ui_smooth(0.0f, POP_S, since_s) : 0.0f;
    caught_plate(frame, scene, pop);
    other_players(frame, scene);
    state_plate(frame, scene);
    if (scene->phase_s < 1.0f) {
        const float out = 1.0f - ui_smooth(0.55f, 1.0f, scene->phase_s);
        const float grow = 1.0f + 0.25f * ui_smooth(0.0f, 1.0f, scene->phase_s);
        big_word(frame, frame->language == LANGUAGE_JA ? FONT_BRUSH : FONT_STALL,
                 0.44f * frame->height, 150.0f * frame->unit * grow, out,
                 text_words(frame->language, TEXT_GO));
    }
    hint_ribbon(frame, scene, (float)(scene->tick - memory->hint_tick) * CORE_TICK_S);
}

/* ---- Result --------------------------------------------------------------------------------- */

struct grade {
    uint32_t at_least;           /* Fish. A stall's guest takes three to five home. */
    enum text_key praise, words;
};

static const struct grade *grade_of(uint32_t caught)
{
    static const struct grade grades[GRADES] = {
        { 0, TEXT_GRADE_0, TEXT_GRADE_0_WORDS },  { 1, TEXT_GRADE_1, TEXT_GRADE_1_WORDS },
        { 3, TEXT_GRADE_2, TEXT_GRADE_2_WORDS },  { 6, TEXT_GRADE_3, TEXT_GRADE_3_WORDS },
        { 10, TEXT_GRADE_4, TEXT_GRADE_4_WORDS }, { 15, TEXT_GRADE_5, TEXT_GRADE_5_WORDS },
    };
    uint32_t grade = 0;
    while (grade + 1u < GRADES && caught >= grades[grade + 1u].at_least) {
        grade++;
    }
    return &grades[grade];
}

/* The seal that a proud stallkeeper stamps on a record. */
static void seal(const struct ui_frame *frame, float x, float y, float in)
{
    const float u = frame->unit;
    const char *words = text_words(frame->language, TEXT_NEW_BEST);
    const struct ui_text text = { .font = FONT_STALL, .size_px = 27.0f * u * (2.0f - in),
                                  .align = 0.5f, .fill = 0xfff1ddffu };
    const float width = ui_text_width(&text, words) + 34.0f * u, height = 50.0f * u * (2.0f - in);
    frame->batch->opacity = in;
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { x - 0.5f * width, y - 0.5f * height, width, height },
                                 .kind = UI_WASHI, .fill = 0xc92c1cffu, .line = 0xfff1ddb0u,
                                 .shape = { 0, 0, 8.0f * u, 2.5f * u } });
    ui_text(frame->batch, &text, x, ui_text_middle(&text, y), words);
    frame->batch->opacity = 1.0f;
}

static void result_count(const struct ui_frame *frame, const struct scene *scene, float x, float y)
{
    const float u = frame->unit, counted = ui_smooth(0.2f, 0.2f + COUNT_UP_S, scene->phase_s);
    char number[12];
    text_number(number, sizeof number, "{}",
                (uint32_t)(counted * (float)scene->caught[0] + 0.001f));
    const struct ui_text digits = { .font = FONT_STALL, .size_px = 116.0f * u, .fill = UI_INK };
    const struct ui_text unit = { .font = FONT_STALL, .size_px = 48.0f * u, .fill = UI_INK_SOFT };
    const char *words = text_words(frame->language, TEXT_UNIT);
    const float fish = 164.0f * u, gap = 20.0f * u;
    const float number_width = ui_text_width(&digits, number);
    const float whole = fish + number_width + ui_text_width(&unit, words) + 2.0f * gap;
    const float left = x - 0.5f * whole, baseline = ui_text_middle(&digits, y);
    fish_sign(frame, left + 0.5f * fish, y, fish);
    ui_text(frame->batch, &digits, left + fish + gap, baseline, number);
    ui_text(frame->batch, &unit, left + fish + number_width + 2.0f * gap, baseline, words);
}

/* A paper card; its shadow is drawn only where it shows, for a card covers many pixels. */
static void card(const struct ui_frame *frame, struct ui_box box)
{
    const float u = frame->unit;
    const struct ui_box shade = { box.x - 2.0f * u, box.y + box.height - 28.0f * u,
                                  box.width + 4.0f * u, 38.0f * u };
    ui_shape(frame->batch, &(struct ui_shape){ .box = shade, .kind = UI_PANEL, .fill = 0x05061c80u,
                                               .shape = { 0, 0, 16.0f * u } });
    ui_shape(frame->batch, &(struct ui_shape){ .box = box, .kind = UI_WASHI,
                                               .fill = UI_WASHI_WHITE, .line = 0xb5762fffu,
                                               .shape = { 0, 0, 14.0f * u, 3.0f * u } });
}

static void result_words(const struct ui_frame *frame, const struct scene *scene, struct ui_box box)
{
    const float u = frame->unit, x = box.x + 0.5f * box.width;
    const struct grade *grade = grade_of(scene->caught[0]);
    const int brush = frame->language == LANGUAGE_JA;
    const struct ui_text heading = { .font = FONT_STALL, .size_px = 30.0f * u, .align = 0.5f,
                                     .fill = UI_INK_SOFT };
    const struct ui_text praise = { .font = brush ? FONT_BRUSH : FONT_STALL, .align = 0.5f,
                                    .size_px = (brush ? 104.0f : 76.0f) * u,
                                    .weight_em = brush ? 0.022f : 0.0f, .spacing_em = brush ? -0.10f : 0.0f, .fill = 0xc8301effu,
                                    .fit_px = box.width - 60.0f * u };
    const struct ui_text words = { .font = FONT_BODY, .size_px = 27.0f * u, .align = 0.5f,
                                   .fill = UI_INK, .fit_px = box.width - 60.0f * u };
    ui_text(frame->batch, &heading, x, box.y + 52.0f * u,
            text_words(frame->language, TEXT_RESULT));
    result_count(frame, scene, x, box.y + 128.0f * u);
    frame->batch->opacity = ui_smooth(1.1f, 1.5f, scene->phase_s);
    ui_text(frame->batch, &praise, x, ui_text_middle(&praise, box.y + 252.0f * u),
            text_words(frame->language, grade->praise));
    ui_text(frame->batch, &words, x, box.y + 338.0f * u,
            text_words(frame->language, grade->words));
    frame->batch->opacity = 1.0f;
    char best[TEXT_LINE_MAX];
    best_words(scene, best, sizeof best);
    const struct ui_text small = { .font = FONT_STALL, .size_px = 25.0f * u, .align = 0.5f,
                                   .fill = 0x8a5a1cffu };
    ui_text(frame->batch, &small, x, box.y + 388.0f * u, best);
}

static void result(const struct ui_frame *frame, const struct scene *scene,
                   const struct ui_memory *memory)
{
    const float u = frame->unit, in = ui_smooth(0.0f, 0.45f, scene->phase_s);
    const float width = fminf(680.0f * u, frame->width - 40.0f * u), height = 416.0f * u;
    const struct ui_box box = { 0.5f * (frame->width - width),
                                0.45f * frame->height - 0.5f * height + 40.0f * u * (1.0f - in),
                                width, height };
    other_players(frame, scene);
    frame->batch->opacity = in;
    card(frame, box);
    frame->batch->opacity = 1.0f;
    result_words(frame, scene, box);
    const float stamped = ui_smooth(1.6f, 1.8f, scene->phase_s);
    if (stamped > 0.0f && scene->caught[0] > memory->best_before) {
        seal(frame, box.x + box.width - 130.0f * u, box.y + 8.0f * u, stamped);
    }
    if (scene->hint == HINT_START) {
        start_ribbon(frame, frame->height - 58.0f * u, TEXT_AGAIN);
    } else {
        hint_ribbon(frame, scene, (float)(scene->tick - memory->hint_tick) * CORE_TICK_S);
    }
}

/* ---- The whole ------------------------------------------------------------------------------ */

static void remember(struct ui_memory *memory, const struct scene *scene)
{
    if (scene->hint != memory->hint) {
        memory->hint = scene->hint;
        memory->hint_tick = scene->tick;
    }
    if (scene->caught[0] != memory->caught) {
        memory->caught = scene->caught[0];
        memory->caught_tick = scene->tick;
    }
    if (scene->phase != PHASE_RESULT) {
        memory->best_before = scene->best_today;
    }
}

void ui_screens(struct ui_batch *batch, struct ui_memory *memory, const struct scene *scene,
                float width_px, float height_px)
{
    const struct ui_frame frame = {
        .batch = batch,
        .width = width_px,
        .height = height_px,
        .unit = fminf(height_px / 720.0f, width_px / 860.0f),
        .time_s = (float)(scene->tick % (3600u * CORE_TICK_HZ)) * CORE_TICK_S,
        .language = scene->language,
    };
    ui_batch_clear(batch);
    remember(memory, scene);
    switch (scene->phase) {
    case PHASE_READY:
        ready(&frame, scene, (float)(scene->tick - memory->hint_tick) * CORE_TICK_S);
        break;
    case PHASE_ROUND:
        play(&frame, scene, memory);
        break;
    case PHASE_RESULT:
        result(&frame, scene, memory);
        break;
    default:
        attract(&frame, scene);
        break;
    }
}
