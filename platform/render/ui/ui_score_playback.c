/* ui_score_playback.c -- draws the ribbon over a score playback, which is the replayed recording of
 * a round. The ribbon shows the round and whether its score is verified. */
#include "platform/render/ui/ui_score_playback.h"

#include "platform/render/ui/text.h"

#define BAR_WIDTH 360.0f
#define BAR_HEIGHT 8.0f

void ui_score_playback_fade(const struct ui_frame *frame, const struct scene *scene)
{
    if (scene->veil > 0.0f) {
        const struct ui_box all = { 0.0f, 0.0f, frame->width, frame->height };
        ui_shape(frame->batch, &(struct ui_shape){ .box = all,
                                                   .kind = UI_PANEL,
                                                   .fill = ui_fade(0x05060fffu, scene->veil) });
    }
}

struct verdict_paint {
    uint16_t words; /* Text key of the verification result (enum text_key). */
    uint32_t fill;
};

static struct verdict_paint ui_score_playback_paint_of(uint8_t playback)
{
    switch (playback) {
    case ENCORE_SEEKS:
        return (struct verdict_paint){ TEXT_ENCORE_SEEKS, UI_NIGHT };
    case ENCORE_PLAYS:
        return (struct verdict_paint){ TEXT_ENCORE_PLAYS, UI_NIGHT };
    case ENCORE_GENUINE:
        return (struct verdict_paint){ TEXT_ENCORE_GENUINE, 0x17754ee8u };
    case ENCORE_OTHER:
        return (struct verdict_paint){ TEXT_ENCORE_OTHER, 0xb8301ee8u };
    default:
        return (struct verdict_paint){ TEXT_ENCORE_NONE, 0xb8301ee8u };
    }
}

static void ui_score_playback_bar(const struct ui_frame *frame, float y, float share)
{
    const float u = frame->unit, width = BAR_WIDTH * u, height = BAR_HEIGHT * u;
    const struct ui_box whole = { 0.5f * (frame->width - width), y, width, height };
    const struct ui_box done = { whole.x, y, width * ui_clamp01(share), height };
    ui_shape(frame->batch, &(struct ui_shape){ .box = whole, .kind = UI_PANEL, .fill = UI_NIGHT });
    ui_shape(frame->batch, &(struct ui_shape){ .box = done, .kind = UI_PANEL, .fill = UI_GOLD });
}

void ui_score_playback(const struct ui_frame *frame, const struct scene *scene)
{
    if (scene->playback == ENCORE_OFF || scene->playback >= ENCORE_COUNT) {
        return;
    }
    const float u = frame->unit;
    const struct verdict_paint paint = ui_score_playback_paint_of(scene->playback);
    const int is_end = scene->playback != ENCORE_SEEKS && scene->playback != ENCORE_PLAYS;
    const struct ui_ribbon ribbon = {
        .x = 0.5f * frame->width,
        .y = scene->playback == ENCORE_SEEKS ? 0.5f * frame->height : frame->height - 120.0f * u,
        .size_px = (is_end ? 40.0f : 30.0f) * u,
        .font = FONT_BODY,
        .fill = paint.fill,
        .line = UI_GOLD,
        .ink = 0xfff8eaffu,
        .room_px = frame->width - 32.0f * u,
    };
    frame->batch->opacity = 1.0f;
    ui_ribbon(frame, &ribbon, text_words(frame->language, (enum text_key)paint.words));
    if (scene->playback == ENCORE_SEEKS) {
        ui_score_playback_bar(frame, ribbon.y + 44.0f * u, scene->encore_progress);
    }
}
