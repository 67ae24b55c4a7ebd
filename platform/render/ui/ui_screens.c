/* ui_screens.c -- selects the screen of each phase of the game, records what the screen shows, and
 * draws the ribbon over a score playback. A score playback is the replayed recording of a round. */
#include "platform/render/ui/ui_screens.h"

#include <math.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

/* Width and height of the progress bar in layout units. */
#define BAR_WIDTH 360.0f
#define BAR_HEIGHT 8.0f

void ui_screens_notice(struct ui_memory *memory, const struct scene *scene)
{
    if (scene->hint != memory->hint) {
        memory->hint = scene->hint;
        memory->hint_tick = scene->tick;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->caught[i] != memory->caught[i]) {
            memory->caught[i] = scene->caught[i];
            memory->caught_tick[i] = scene->tick;
        }
    }
    if (scene->choice != memory->pointed) {
        memory->pointed_before = memory->pointed;
        memory->pointed = scene->choice;
        memory->pointed_tick = scene->tick;
    }
}

/* Draws the ribbon of a score playback over all other drawings. The ribbon shows the round and
 * whether its score is verified. Draws nothing if no score playback runs. */
static void playback_ribbon(const struct ui_frame *frame, const struct scene *scene)
{
    static const struct {
        enum text_key words;
        uint32_t fill;
    } verdicts[ENCORE_COUNT] = {
        [ENCORE_SEEKS] = { TEXT_ENCORE_SEEKS, UI_NIGHT },
        [ENCORE_PLAYS] = { TEXT_ENCORE_PLAYS, UI_NIGHT },
        [ENCORE_GENUINE] = { TEXT_ENCORE_GENUINE, 0x17754ee8u },
        [ENCORE_OTHER] = { TEXT_ENCORE_OTHER, 0xb8301ee8u },
        [ENCORE_NONE] = { TEXT_ENCORE_NONE, 0xb8301ee8u },
    };
    const float u = frame->unit;
    if (scene->playback == ENCORE_OFF || scene->playback >= ENCORE_COUNT) {
        return;
    }
    const int seeks = scene->playback == ENCORE_SEEKS;
    const int is_end = !seeks && scene->playback != ENCORE_PLAYS;
    const struct ui_ribbon ribbon = { .y =
                                          seeks ? 0.5f * frame->height : frame->height - 120.0f * u,
                                      .size_px = (is_end ? 40.0f : 30.0f) * u,
                                      .font = FONT_BODY,
                                      .fill = verdicts[scene->playback].fill,
                                      .line = UI_GOLD };
    frame->batch->opacity = 1.0f;
    ui_ribbon(frame, &ribbon, ui_words(frame, verdicts[scene->playback].words));
    if (seeks) { /* The bar shows the fraction of the recording that has been searched. */
        const float width = BAR_WIDTH * u, share = ui_clamp01(scene->encore_progress);
        struct ui_box bar = { 0.5f * (frame->width - width), ribbon.y + 44.0f * u, width,
                              BAR_HEIGHT * u };
        ui_panel(frame, UI_PANEL, bar, 0.0f, 0.0f, UI_NIGHT, 0);
        bar.width = width * share;
        ui_panel(frame, UI_PANEL, bar, 0.0f, 0.0f, UI_GOLD, 0);
    }
}

static void phase_screen(const struct ui_frame *frame, struct ui_memory *memory,
                         const struct scene *scene)
{
    switch (scene->phase) {
    case PHASE_READY:
        ui_ready(frame, scene, memory);
        break;
    case PHASE_ROUND:
        ui_round(frame, scene, memory);
        break;
    case PHASE_RESULT:
        ui_result(frame, scene, memory);
        break;
    case PHASE_MODE_SELECT:
        ui_choose(frame, scene, memory);
        break;
    case PHASE_LAB:
        ui_lab(frame, scene, memory);
        break;
    case PHASE_ALBUM:
        ui_album(frame, scene);
        break;
    case PHASE_NAME:
        ui_name(frame, scene);
        break;
    case PHASE_LEADERBOARD:
        ui_ranking(frame, scene);
        break;
    case PHASE_ATTRACT:
        ui_attract(frame, scene);
        break;
    case PHASE_MENU:
        ui_menu(frame, scene);
        return; /* ui_menu() has already drawn the warnings. */
    default:    /* Only PHASE_WORDLESS reaches this case. The screen of this phase has no text. */
        return;
    }
    ui_warnings(frame, scene);
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
    CORE_ASSERT(width_px > 0.0f && height_px > 0.0f);
    ui_batch_clear(batch);
    ui_screens_notice(memory, scene);
    if (scene->veil > 0.0f) { /* The fade between two sessions darkens the tank. */
        ui_panel(&frame, UI_PANEL, (struct ui_box){ 0.0f, 0.0f, width_px, height_px }, 0.0f, 0.0f,
                 ui_fade(0x05060fffu, scene->veil), 0);
    }
    phase_screen(&frame, memory, scene);
    playback_ribbon(&frame, scene);
}
