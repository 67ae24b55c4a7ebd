/* ui_menu_update.c -- draws the page of the update by USB stick: the steps for the operator, the
 * progress, and one line with the result. */
#include "core/base/panic.h"
#include "platform/render/ui/menu/ui_menu.h"

#define STEP_COUNT 4u

/* Boxes of the parts of the page, on the canvas. */
struct places {
    struct layout_box paper;
    float step_pitch; /* Distance between the lines of two steps. */
    struct layout_box name, bar, line;
};

/* Layouts of a wide screen (index 0) and of an upright screen (index 1). */
static const struct places layouts[2] = {
    { { 130, 120, 1020, 474 },
      56,
      { 160, 384, 960, 50 },
      { 160, 446, 960, 34 },
      { 160, 500, 960, 70 } },
    { { 27, 200, 800, 1020 },
      100,
      { 57, 720, 740, 70 },
      { 57, 820, 740, 50 },
      { 57, 920, 740, 100 } },
};

/* Texts of the steps, of which the last one has a text for each fault instead. */
static const enum text_key step_words[UPDATE_STEP_COUNT] = {
    [UPDATE_STEP_WAIT] = TEXT_UPDATE_WAIT,       [UPDATE_STEP_NO_STICK] = TEXT_UPDATE_NO_STICK,
    [UPDATE_STEP_FOUND] = TEXT_UPDATE_FOUND,     [UPDATE_STEP_CHECKING] = TEXT_UPDATE_CHECKING,
    [UPDATE_STEP_WRITING] = TEXT_UPDATE_WRITING, [UPDATE_STEP_DONE] = TEXT_UPDATE_DONE,
    [UPDATE_STEP_FAILED] = TEXT_UPDATE_DAMAGED,
};
static const enum text_key fault_words[UPDATE_FAULT_COUNT] = {
    [UPDATE_FAULT_NONE] = TEXT_UPDATE_DAMAGED,
    [UPDATE_FAULT_FELL_BACK] = TEXT_UPDATE_FELL_BACK,
    [UPDATE_FAULT_NO_FILESYSTEM] = TEXT_UPDATE_NO_FILESYSTEM,
    [UPDATE_FAULT_NO_FOLDER] = TEXT_UPDATE_NO_FOLDER,
    [UPDATE_FAULT_UNSIGNED] = TEXT_UPDATE_UNSIGNED,
    [UPDATE_FAULT_WRONG_KEY] = TEXT_UPDATE_WRONG_KEY,
    [UPDATE_FAULT_WRONG_BOARD] = TEXT_UPDATE_WRONG_BOARD,
    [UPDATE_FAULT_OLDER] = TEXT_UPDATE_OLDER,
    [UPDATE_FAULT_SAME_VERSION] = TEXT_UPDATE_SAME_VERSION,
    [UPDATE_FAULT_TOO_LARGE] = TEXT_UPDATE_TOO_LARGE,
    [UPDATE_FAULT_DAMAGED] = TEXT_UPDATE_DAMAGED,
    [UPDATE_FAULT_PULLED] = TEXT_UPDATE_PULLED,
    [UPDATE_FAULT_CANCELED] = TEXT_UPDATE_CANCELED,
    [UPDATE_FAULT_CARD] = TEXT_UPDATE_CARD,
    [UPDATE_FAULT_ON_TRIAL] = TEXT_UPDATE_ON_TRIAL,
};

static void draw_bar(const struct ui_frame *frame, struct ui_box box, const struct scene_update *is)
{
    const float u = frame->unit, radius = 0.5f * box.height;
    struct ui_box full = ui_inset(box, 4.0f * u);
    full.width *= (float)is->percent * 0.01f;
    ui_panel(frame, UI_PANEL, box, radius, 1.5f * u, 0x2a160c30u, MENU_INK_SOFT);
    if (is->percent > 0) {
        ui_panel(frame, UI_PANEL, full, radius - 4.0f * u, 0.0f, MENU_GOOD, 0);
    }
}

void menu_update(const struct ui_frame *frame)
{
    static const enum text_key steps[STEP_COUNT] = { TEXT_UPDATE_STEP_1, TEXT_UPDATE_STEP_2,
                                                     TEXT_UPDATE_STEP_3, TEXT_UPDATE_STEP_4 };
    const struct scene_update *const is = &frame->scene->devices.update;
    const struct places *const places = &layouts[frame->is_upright];
    const float u = frame->unit;
    const struct ui_box paper = ui_place(frame, places->paper);
    CORE_ASSERT(is->step < UPDATE_STEP_COUNT && is->fault < UPDATE_FAULT_COUNT);
    menu_paper(frame, paper);
    for (uint32_t i = 0; i < STEP_COUNT; i++) {
        ui_words_at(frame, paper.x + 30.0f * u,
                    paper.y + (0.8f + (float)i) * places->step_pitch * u, paper.width - 60.0f * u,
                    0.0f, ui_body(frame, 28.0f, UI_INK), ui_words(frame, steps[i]));
    }
    const bool is_bad = is->step == UPDATE_STEP_FAILED ||
                        (is->step == UPDATE_STEP_NO_STICK && is->fault != UPDATE_FAULT_NONE);
    const bool is_good = is->step == UPDATE_STEP_FOUND || is->step == UPDATE_STEP_DONE;
    const uint32_t paint = is_bad ? MENU_BAD : is_good ? MENU_GOOD : UI_INK;
    const enum text_key line = is_bad ? fault_words[is->fault] : step_words[is->step];
    ui_words_in(frame, ui_place(frame, places->line), ui_body(frame, 34.0f, paint),
                ui_words(frame, line));
    if (is->step == UPDATE_STEP_CHECKING || is->step == UPDATE_STEP_WRITING) {
        draw_bar(frame, ui_place(frame, places->bar), is);
    }
    if (is->name[0] && !is_bad) {
        ui_words_in(frame, ui_place(frame, places->name), ui_body(frame, 30.0f, UI_INK), is->name);
    }
}
