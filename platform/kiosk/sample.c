/* sample.c -- reads the devices for a frame; see sample.h. */
#include "platform/kiosk/sample.h"

#include "core/game/menu/menu_pages.h"

/* Maximum time between two presses of the quit key. The time is equal to MENU_ASK_TICKS, the
 * maximum time between two presses of TEST in a round. */
#define QUIT_ASK_NS 5000000000ull

static void read_wall(struct kiosk *kiosk, const struct hal *hal)
{
    if (hal->clock.ops->civil) {
        hal->clock.ops->civil(hal->clock.self, &kiosk->input.day, &kiosk->input.minute);
    }
}

static void open_seat(struct kiosk *kiosk, const struct hal *hal, uint32_t seat, uint64_t now_ns)
{
    kiosk->faults.poi += poi_sampler_open(&kiosk->hands[seat], &hal->poi[seat], now_ns);
    if (seat < SHADE_MAX) {
        kiosk->faults.shade += fan_sampler_open(&kiosk->shades[seat], &hal->fan[seat], now_ns);
    }
}

/* Assigns controllers to slots. Slots change only between two games and while the operator's menu
 * is shown, so that no player loses a controller during a game. */
static void arrange_seats(struct kiosk *kiosk, const struct hal *hal)
{
    const uint8_t phase = kiosk->output.phase;
    const int may_move = phase == PHASE_ATTRACT || phase == PHASE_MENU;
    const uint32_t moved = hal->seats.ops->arrange(hal->seats.self, may_move);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (moved & (1u << i)) {
            open_seat(kiosk, hal, i, kiosk->sampled_ns);
        }
    }
}

void sample_open(struct kiosk *kiosk, const struct hal *hal)
{
    read_wall(kiosk, hal); /* The first call reads the time zone in the C library, which allocates
                              memory. */
    hal->seats.ops->arrange(hal->seats.self, 1);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        open_seat(kiosk, hal, i, hal_now_ns(hal->clock));
    }
}

/* Handles the quit key. A desktop requires a second press within QUIT_ASK_NS, because Esc is easily
 * pressed by accident. Any other button cancels the first press. A replay ends at the first press.
 * In the operator's menu the key goes back one page. */
static void heed_quit(struct kiosk *kiosk, const struct button_sample *buttons)
{
    const int is_menu = kiosk->output.phase == PHASE_MENU;
    if (buttons->pressed != 0 || is_menu) {
        kiosk->quit_until_ns = 0;
    }
    if (!buttons->quit) {
        return;
    }
    if (is_menu) {
        kiosk->input.pressed |= MENU_WAY_BACK;
    } else if (kiosk_asks_to_quit(kiosk) || kiosk->config.source.next) {
        kiosk->end = KIOSK_QUIT;
    } else {
        kiosk->quit_until_ns = kiosk->sampled_ns + QUIT_ASK_NS;
    }
}

static void sample_buttons(struct kiosk *kiosk, const struct hal *hal)
{
    struct button_sample buttons = { 0 };
    hal->buttons.ops->poll(hal->buttons.self, &buttons);
    kiosk->input.held = buttons.held & (uint32_t)INPUT_BUTTON_ALL;
    kiosk->input.pressed |= buttons.pressed & (uint32_t)INPUT_BUTTON_ALL;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        kiosk->input.coin_count[line] += buttons.coin_count[line];
    }
    kiosk->faults.buttons += buttons.faults;
    operator_view_lines_add(&kiosk->lines, &buttons);
    if (buttons.full_screen) {
        hal->display.ops->toggle_full_screen(hal->display.self);
    }
    heed_quit(kiosk, &buttons);
}

static void sample_display(struct kiosk *kiosk, const struct hal *hal)
{
    struct display_events events = { 0 };
    if (hal->display.ops->poll(hal->display.self, &events) == HAL_OK) {
        kiosk->input.upright = events.upright;
    }
    if (events.quit) {
        kiosk->end = KIOSK_QUIT;
    }
    if (events.lost) {
        kiosk->end = KIOSK_DISPLAY_LOST;
    }
}

static void sample_store(struct kiosk *kiosk, const struct hal_storage *storage)
{
    kiosk->input.record_saved_id = storage->ledger.ops->committed_id(storage->ledger.self);
    kiosk->input.edit_saved_id = storage->edits.ops->stored_id(storage->edits.self);
    kiosk->input.edit_refused = storage->edits.ops->has_failed(storage->edits.self) != 0;
    kiosk->input.store_well = storage->ledger.ops->is_healthy(storage->ledger.self) != 0;
    kiosk->faults.storage += saving_refused(&kiosk->saving, &storage->ledger);
}

void sample_devices(struct kiosk *kiosk, const struct hal *hal)
{
    sample_display(kiosk, hal); /* The display is polled first, because its poll() fills the event
                                   queue from which mouse and keyboard are read. */
    hal->controllers.ops->poll(hal->controllers.self, &kiosk->input.controllers);
    kiosk->input.controllers.file_count = operator_view_file_count(kiosk->config.notes);
    const uint64_t now_ns = kiosk->sampled_ns = hal_now_ns(hal->clock);
    arrange_seats(kiosk, hal);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        kiosk->faults.poi += poi_sampler_sample(&kiosk->hands[i], &hal->poi[i], now_ns);
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        kiosk->faults.shade += fan_sampler_sample(&kiosk->shades[i], &hal->fan[i], now_ns);
    }
    sample_buttons(kiosk, hal); /* The buttons are polled after the pois, because polling a poi also
                                   reads the buttons of its controller. */
    sample_store(kiosk, &hal->storage);
    kiosk->input.tickets_done = output_lines_are_done(&kiosk->switches, &hal->switches, HAL_TICKET);
    read_wall(kiosk, hal);
    kiosk->input.dropped_ticks = (uint32_t)kiosk->pace.dropped;
    kiosk->input.device_faults = kiosk_fault_count(&kiosk->faults);
}
