/* ui_screens.c -- selects the screen of each phase of the game, records the shown values for
 * animations, and draws the ribbon over a score playback. A score playback is the replayed
 * recording of a round. */
#include "platform/render/ui/ui_screens.h"

#include <math.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

/* Growth of the common font with each step of the text size. */
#define TEXT_STEP 0.2f
/* Width and height, in layout units, of the progress bar in the ribbon of a score playback. */
#define BAR_WIDTH 360.0f
#define BAR_HEIGHT 8.0f

void ui_screens_notice(struct ui_memory *memory, const struct scene *scene)
{
    if (scene->hint != memory->hint) {
        memory->hint = scene->hint;
        memory->hint_tick = scene->tick;
    }
    ui_catch_notice(memory, scene);
    if (scene->pointed_tags != memory->pointed) {
        memory->pointed_before = memory->pointed;
        memory->pointed = scene->pointed_tags;
        memory->pointed_tick = scene->tick;
    }
    memory->phase = scene->phase;
    memory->tick = scene->tick;
}

/* Draws the ribbon of a score playback over all other drawings. The ribbon shows the round and
 * whether its score is verified. Draws nothing if no score playback runs. */
static void playback_ribbon(const struct ui_frame *frame)
{
    static const struct {
        enum text_key words;
        uint32_t fill;
    } verdicts[PLAYBACK_COUNT] = {
        [PLAYBACK_SEEKS] = { TEXT_PLAYBACK_SEEKS, UI_NIGHT },
        [PLAYBACK_PLAYS] = { TEXT_PLAYBACK_PLAYS, UI_NIGHT },
        [PLAYBACK_GENUINE] = { TEXT_PLAYBACK_GENUINE, 0x17754ee8u },
        [PLAYBACK_OTHER] = { TEXT_PLAYBACK_OTHER, 0xb8301ee8u },
        [PLAYBACK_NONE] = { TEXT_PLAYBACK_NONE, 0xb8301ee8u },
    };
    const uint8_t playback = frame->scene->playback;
    if (playback == PLAYBACK_OFF || playback >= PLAYBACK_COUNT) {
        return;
    }
    const float u = frame->unit;
    const bool seeks = playback == PLAYBACK_SEEKS, is_end = !seeks && playback != PLAYBACK_PLAYS;
    const float y = seeks ? 0.5f * frame->height : frame->height - 120.0f * u;
    frame->batch->opacity = 1.0f;
    if (frame->scene->phase == PHASE_MENU) {
        ui_veil(frame, 0x0a0c24d8u); /* The page from which the playback starts is below. */
    }
    ui_ribbon(frame, (struct ui_ribbon){ FONT_BODY, verdicts[playback].fill, UI_GOLD, 0 }, y,
              (is_end ? 40.0f : 30.0f) * u, ui_words(frame, verdicts[playback].words));
    /* While the recording is played fast up to the beginning of the round, a bar shows the
     * progress. */
    if (seeks) {
        const float width = BAR_WIDTH * u;
        struct ui_box bar = { 0.5f * (frame->width - width), y + 44.0f * u, width, BAR_HEIGHT * u };
        ui_fill(frame, bar, UI_NIGHT);
        bar.width = width * f_clamp(frame->scene->playback_progress, 0.0f, 1.0f);
        ui_fill(frame, bar, UI_GOLD);
    }
}

void ui_screens(struct ui_batch *batch, struct ui_memory *memory, const struct scene *scene,
                float width_px, float height_px)
{
    /* PHASE_WORDLESS has no screen, because this phase shows no text. */
    static void (*const screens[])(const struct ui_frame *frame) = {
        [PHASE_ATTRACT] = ui_attract,     [PHASE_READY] = ui_ready,        [PHASE_ROUND] = ui_round,
        [PHASE_RESULT] = ui_result,       [PHASE_MODE_SELECT] = ui_choose, [PHASE_LAB] = ui_lab,
        [PHASE_ALBUM] = ui_album,         [PHASE_MENU] = ui_menu,          [PHASE_NAME] = ui_name,
        [PHASE_LEADERBOARD] = ui_ranking,
    };
    const struct ui_frame frame = {
        .batch = batch,
        .scene = scene,
        .memory = memory,
        .width = width_px,
        .height = height_px,
        .unit = fminf(height_px / 720.0f, width_px / 860.0f),
        /* The text of the menu is not enlarged, because the pages of the menu have no free
         * space. */
        .text_scale = scene->phase == PHASE_MENU ? 1.0f : 1.0f + TEXT_STEP * scene->text_size,
        .time_s = (float)(scene->tick % (3600u * CORE_TICK_HZ)) * CORE_TICK_S,
        .language = scene->language,
    };
    CORE_ASSERT(width_px > 0.0f && height_px > 0.0f);
    ui_batch_clear(batch);
    ui_screens_notice(memory, scene);
    if (scene->veil > 0.0f) { /* The tank is darkened while the program fades out and in. */
        ui_veil(&frame, ui_fade(0x05060fffu, scene->veil));
    }
    if (scene->phase < sizeof screens / sizeof *screens && screens[scene->phase]) {
        screens[scene->phase](&frame);
        if (scene->phase != PHASE_MENU) { /* The pages of the menu show no warnings. */
            ui_warnings(&frame);
        }
    }
    playback_ribbon(&frame);
}
