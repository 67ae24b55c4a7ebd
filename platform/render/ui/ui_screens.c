/* ui_screens.c -- selects the screen of each phase of the game, and records what the screen
 * shows. */
#include "platform/render/ui/ui_screens.h"

#include <math.h>

#include "platform/render/ui/ui_score_playback.h"
#include "platform/render/ui/ui_widgets.h"

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
        return; /* The menu draws the warnings itself. */
    default:    /* In the remaining phase, PHASE_WORDLESS, the screen has no text. */
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
    ui_batch_clear(batch);
    ui_screens_notice(memory, scene);
    ui_score_playback_fade(&frame, scene);
    phase_screen(&frame, memory, scene);
    ui_score_playback(&frame, scene);
}
