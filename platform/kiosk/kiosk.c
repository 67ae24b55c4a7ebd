/* kiosk.c -- one frame, one direction: sample, step, present. The core never calls out. */
#include "platform/kiosk/kiosk.h"

#include <string.h>

#include "core/game/menu_pages.h"
#include "platform/kiosk/chapters.h"
#include "platform/kiosk/dressing.h"
#include "platform/kiosk/encore.h"

#define RESTART_WAIT_NS 5000000000ull /* A card that takes longer than this for an entry is full. */
#define RETRY_NS 1000000000ull /* A lost card, a failed save: once a second is often enough. */

static uint64_t clock_ns(struct hal_clock clock)
{
    return clock.ops ? clock.ops->now_ns(clock.self) : 0;
}

static void read_wall(struct kiosk *kiosk, const struct hal *hal)
{
    if (hal->clock.ops->civil) {
        hal->clock.ops->civil(hal->clock.self, &kiosk->input.day, &kiosk->input.minute);
    }
}

/* The display, and whoever points at the picture, are told when it is another one. */
static void show_hands(struct kiosk *kiosk, const struct hal *hal)
{
    const struct showing showing =
        lighting_step(&kiosk->lighting, &kiosk->core.config.memory.settings, &kiosk->input,
                      kiosk->core.game.phase == PHASE_ATTRACT, clock_ns(hal->clock));
    const int is_other = memcmp(&kiosk->showing, &showing, sizeof showing) != 0;
    if (!is_other &&
        memcmp(&kiosk->view, &kiosk->scene.view, sizeof kiosk->view) == 0) {
        return;
    }
    kiosk->view = kiosk->scene.view;
    kiosk->showing = showing;
    hal->display.ops->place(hal->display.self, &showing);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hal->poi[i].ops->look(hal->poi[i].self, &kiosk->view, &showing);
    }
}

static void open_seat(struct kiosk *kiosk, const struct hal *hal, uint32_t seat, uint64_t now_ns)
{
    kiosk->faults.poi += poi_hand_open(&kiosk->hands[seat], &hal->poi[seat], now_ns);
    if (seat < SHADE_MAX) {
        kiosk->faults.shade += shade_hand_open(&kiosk->shades[seat], &hal->shade[seat], now_ns);
    }
}

/* Between two games, and while the operator looks at what plays, a seat may go to a better
 * controller; nobody loses his in the middle of a game. */
static void arrange_seats(struct kiosk *kiosk, const struct hal *hal)
{
    const uint8_t phase = kiosk->core.game.phase;
    const int may_move = phase == PHASE_ATTRACT || phase == PHASE_MENU;
    const uint32_t moved = hal->seats.ops->arrange(hal->seats.self, may_move);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (moved & (1u << i)) {
            open_seat(kiosk, hal, i, kiosk->sampled_ns);
        }
    }
}

enum core_error kiosk_init(struct kiosk *kiosk, const struct hal *hal,
                           const struct kiosk_config *config)
{
    memset(kiosk, 0, sizeof *kiosk);
    kiosk->config = *config;
    kiosk->switches.active = 1u << HAL_COIN_LOCKOUT; /* As it begins. */
    kiosk->accepted_id = kiosk->output.entry_id = config->core.memory.ledger.last_id;
    const enum core_error error = core_init(&kiosk->core, &config->core);
    if (error != CORE_OK) {
        return error;
    }
    read_wall(kiosk, hal); /* The C library reads the time zone once, here: it allocates. */
    voice_open(&kiosk->voice, &hal->audio, clock_ns(hal->clock));
    hal->seats.ops->arrange(hal->seats.self, 1);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        open_seat(kiosk, hal, i, clock_ns(hal->clock));
    }
    if (config->chapters) {
        chapters_begin(config->chapters, &kiosk->core);
    }
    core_scene(&kiosk->core, &kiosk->scene);
    show_hands(kiosk, hal);
    return CORE_OK;
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
    line_book_note(&kiosk->lines, &buttons);
    if (buttons.full_screen) {
        hal->display.ops->toggle_full_screen(hal->display.self);
    }
    if (buttons.quit && kiosk->core.game.phase == PHASE_MENU) {
        kiosk->input.pressed |= MENU_WAY_BACK;
    } else if (buttons.quit) {
        kiosk->end = KIOSK_QUIT;
    }
}

/* A store writes on a thread of its own: what it could not write there is a fault like any
 * other. */
static void count_refused_writes(struct kiosk *kiosk, const struct hal_storage *storage)
{
    const uint32_t refused = storage->ops->refused_count(storage->self);
    kiosk->faults.storage += refused - kiosk->refused_seen;
    kiosk->refused_seen = refused;
}

uint32_t kiosk_fault_count(const struct kiosk_faults *faults)
{
    return faults->poi + faults->shade + faults->display + faults->audio + faults->storage +
           faults->buttons + faults->switches;
}

/* The only reads from devices. The display comes first: it pumps the queue that a desktop's
 * mouse and keyboard take their events from. */
static void sample_devices(struct kiosk *kiosk, const struct hal *hal)
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
    hal->controllers.ops->poll(hal->controllers.self, &kiosk->input.desk);
    kiosk->input.desk.file_count = dressing_file_count(kiosk->config.notes);
    const uint64_t now_ns = kiosk->sampled_ns = clock_ns(hal->clock);
    arrange_seats(kiosk, hal);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        kiosk->faults.poi += poi_hand_sample(&kiosk->hands[i], &hal->poi[i], now_ns);
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        kiosk->faults.shade += shade_hand_sample(&kiosk->shades[i], &hal->shade[i], now_ns);
    }
    sample_buttons(kiosk, hal); /* After the pois: a controller's own buttons came with it. */
    kiosk->input.record_saved_id = hal->storage.ops->saved_id(hal->storage.self);
    kiosk->input.edit_saved_id = hal->storage.ops->kept_edit_id(hal->storage.self);
    kiosk->input.edit_refused = hal->storage.ops->refuses_edits(hal->storage.self) != 0;
    read_wall(kiosk, hal);
    kiosk->input.store_well = hal->storage.ops->is_well(hal->storage.self) != 0;
    count_refused_writes(kiosk, &hal->storage);
    kiosk->input.dropped_ticks = (uint32_t)kiosk->pace.dropped;
    kiosk->input.device_faults = kiosk_fault_count(&kiosk->faults);
}

/* The part of the input that each tick has for itself: one pose a tick, none used twice. */
static void pose_hands(struct kiosk *kiosk, uint32_t index, uint32_t tick_count)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct poi_input *poi = &kiosk->input.poi[i];
        poi_hand_at(&kiosk->hands[i], index, tick_count, kiosk->sampled_ns, poi);
        poi->link = kiosk->config.bot[i] ? (uint8_t)POI_LINK_BOT : poi->link;
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        kiosk->input.shade[i] = shade_hand_at(&kiosk->shades[i], index, tick_count);
    }
}

static int is_encore_on(const struct kiosk *kiosk)
{
    return kiosk->config.encore && kiosk->config.encore->state != ENCORE_OFF;
}

/* While a score is shown again, hands and buttons are its audience's: the stall sees none but the
 * coins, and what ends the show is not heard there. */
static void lend_hands(struct kiosk *kiosk)
{
    if (is_encore_on(kiosk)) {
        encore_heeds(kiosk->config.encore, kiosk->input.pressed, kiosk->input.poi);
        kiosk->input.pressed = kiosk->input.held = 0;
        for (uint32_t i = 0; i < POI_MAX; i++) {
            kiosk->input.poi[i].link = POI_LINK_ABSENT;
        }
    }
}

/* 0 when there is no input to run the tick with. */
static int prepare_tick(struct kiosk *kiosk, uint32_t index, uint32_t tick_count)
{
    if (!kiosk->config.source.next) {
        pose_hands(kiosk, index, tick_count);
        lend_hands(kiosk);
        return 1;
    }
    if (!kiosk->config.source.next(kiosk->config.source.self, &kiosk->input)) {
        kiosk->end = KIOSK_SOURCE_END;
        return 0;
    }
    return 1;
}

/* On the clock that stamps the reports. */
static void time_reports(struct kiosk *kiosk, const struct hal *hal)
{
    const uint64_t now_ns = clock_ns(hal->clock);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        poi_hand_time(&kiosk->hands[i], now_ns, &kiosk->report_wait);
    }
}

static uint32_t run_ticks(struct kiosk *kiosk, uint32_t tick_count)
{
    const struct kiosk_tap *tap = &kiosk->config.tap;
    uint32_t done = 0;
    kiosk->output.sound_count = 0;
    if (tick_count > 0) { /* Else the hand goes on feeling what it felt. */
        memset(kiosk->felt, 0, sizeof kiosk->felt);
    }
    while (done < tick_count && prepare_tick(kiosk, done, tick_count)) {
        if (tap->before) {
            tap->before(tap->self, &kiosk->input);
        }
        core_tick(&kiosk->core, &kiosk->input, &kiosk->output);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            output_feel(&kiosk->felt[i], &kiosk->output.poi[i]);
        }
        if (tap->tick) {
            tap->tick(tap->self, &kiosk->input, &kiosk->core);
        }
        if (kiosk->config.chapters) {
            chapters_tick(kiosk->config.chapters, &kiosk->input, &kiosk->core, &kiosk->output);
        }
        kiosk->input.pressed = 0; /* One press, one tick. */
        memset(kiosk->input.coin_count, 0, sizeof kiosk->input.coin_count);
        done++;
    }
    if (done > 0) {
        for (uint32_t i = 0; i < POI_MAX; i++) {
            poi_hand_end(&kiosk->hands[i]);
        }
        for (uint32_t i = 0; i < SHADE_MAX; i++) {
            shade_hand_end(&kiosk->shades[i]);
        }
        core_scene(&kiosk->core, &kiosk->scene);
    }
    return done;
}

/* A score is shown again in place of the stall. */
static void show_encore(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count)
{
    struct encore *encore = kiosk->config.encore;
    if (!encore) {
        return;
    }
    if (kiosk->wanted_replay_id != 0) {
        encore_ask(encore, kiosk->wanted_replay_id);
        kiosk->wanted_replay_id = 0;
    }
    encore_frame(encore, hal, &kiosk->config.stopwatch, &kiosk->core.game.ranking, tick_count);
    encore_show(encore, &kiosk->scene, &kiosk->output);
}

static void present_sounds(struct kiosk *kiosk, const struct hal *hal)
{
    kiosk->faults.audio += voice_put(&kiosk->voice, &hal->audio, &kiosk->output,
                                     &kiosk->core.config.memory.settings,
                                     kiosk->core.game.phase == PHASE_ATTRACT,
                                     clock_ns(hal->clock));
}

/* A replay's coins were metered when they fell, and those that fall now would be nobody's: the slot
 * stays closed, as it begins. */
static void present_switches(struct kiosk *kiosk, const struct hal *hal)
{
    if (!kiosk->config.source.next) {
        kiosk->faults.switches += switches_put(&kiosk->switches, &hal->switches, &kiosk->output,
                                               clock_ns(hal->clock));
    }
}

_Static_assert(PACE_TICKS_MAX / MENU_TAKE_TICKS + 2u <= DESK_ORDER_MAX,
               "a take in the first tick, one after each pause, and the menu that closes itself");

/* All of the frame's, in the order in which they were given. */
static void present_orders(struct kiosk *kiosk, const struct hal *hal)
{
    const struct output *output = &kiosk->output;
    while (!kiosk->config.source.next && kiosk->told_orders != output->order_count) {
        const struct desk_order *order = &output->orders[kiosk->told_orders++ % DESK_ORDER_MAX];
        if (order->kind == DESK_RESTART) {
            kiosk->restart_ns = clock_ns(hal->clock) + RESTART_WAIT_NS;
        } else if (order->kind == DESK_REPLAY) {
            kiosk->wanted_replay_id = order->round_id;
        } else {
            hal->controllers.ops->order(hal->controllers.self, order);
        }
    }
}

/* Another start would go on from a store that came late: with its settings, and with coins. Nobody
 * plays, nobody's money lies only in this memory, and no recording would be written over. */
static int is_called_back(const struct kiosk *kiosk, const struct hal *hal)
{
    const struct purse *purse = &kiosk->core.game.ledger.purse;
    return kiosk->core.game.phase == PHASE_ATTRACT && !kiosk->config.source.next &&
           !kiosk->config.tap.tick && purse->units == 0 && purse->paid == 0 &&
           purse->service == 0 && purse->untold == 0 && purse->open == OPEN_NONE &&
           hal->storage.ops->wants_restart(hal->storage.self);
}

/* The operator wants a restart: once the store has every entry, or will not take them. */
static void end_for_restart(struct kiosk *kiosk, const struct hal *hal)
{
    if (is_called_back(kiosk, hal)) {
        kiosk->end = KIOSK_RESTART;
        return;
    }
    const int is_kept = kiosk->accepted_id == kiosk->output.entry_id;
    if (kiosk->restart_ns > 0 && (is_kept || clock_ns(hal->clock) >= kiosk->restart_ns)) {
        kiosk->end = KIOSK_RESTART;
    }
}

static void present_forces(struct kiosk *kiosk, const struct hal *hal)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (kiosk->hands[i].link == POI_LINK_LIVE) {
            const int result = hal->poi[i].ops->feel(hal->poi[i].self, &kiosk->felt[i]);
            kiosk->faults.poi += (uint32_t)hal_is_fault(result);
        }
    }
}

/* Whether a store is done with what it was offered; one that failed is left alone for a second. */
static int is_settled(struct kiosk *kiosk, int result, uint64_t now_ns)
{
    if (result == HAL_OK || result == HAL_ERR_NONE) {
        return 1;
    }
    if (result != HAL_ERR_BUSY) {
        kiosk->faults.storage++;
        kiosk->save_retry_ns = now_ns + RETRY_NS;
    }
    return 0;
}

/* Offers the ledger's entries, the oldest first, until the store takes them: busy, next frame;
 * failed, in a second. A store that is not there never will. A replay's were kept when they were
 * played. */
static void present_entries(struct kiosk *kiosk, const struct hal *hal)
{
    const struct output *output = &kiosk->output;
    const uint64_t now_ns = clock_ns(hal->clock);
    while (!kiosk->config.source.next && kiosk->accepted_id != output->entry_id &&
           now_ns >= kiosk->save_retry_ns) {
        const uint32_t behind = output->entry_id - kiosk->accepted_id;
        kiosk->accepted_id += behind > LEDGER_RING ? behind - LEDGER_RING : 0u;
        const uint32_t place = (kiosk->accepted_id + 1u) % LEDGER_RING;
        const int result = hal->storage.ops->keep(hal->storage.self, &output->entries[place]);
        if (!is_settled(kiosk, result, now_ns)) {
            return;
        }
        kiosk->accepted_id++;
    }
}

/* The same of the newest graph from the growth lab. */
static void present_edit(struct kiosk *kiosk, const struct hal *hal)
{
    const struct edit_record *edit = &kiosk->output.edit;
    const uint64_t now_ns = clock_ns(hal->clock);
    if (!kiosk->config.source.next && edit->id != kiosk->accepted_edit_id &&
        now_ns >= kiosk->save_retry_ns &&
        is_settled(kiosk, hal->storage.ops->keep_edit(hal->storage.self, edit), now_ns)) {
        kiosk->accepted_edit_id = edit->id;
    }
}

/* Without a picture the game goes on, and the store with it: a display that went, or that never
 * was there, is looked for once a second. */
static void present_picture(struct kiosk *kiosk, const struct hal *hal)
{
    const struct hal_display *display = &hal->display;
    const uint64_t now_ns = clock_ns(hal->clock);
    if (kiosk->display_retry_ns > 0 && now_ns >= kiosk->display_retry_ns) {
        const int is_back = display->ops->open(display->self) == HAL_OK;
        kiosk->display_retry_ns = is_back ? 0 : clock_ns(hal->clock) + RETRY_NS;
    }
    if (kiosk->display_retry_ns > 0) {
        return;
    }
    const int result = display->ops->present(display->self, &kiosk->scene);
    kiosk->faults.display += (uint32_t)hal_is_fault(result);
    if (result == HAL_ERR_GONE) {
        kiosk->display_retry_ns = now_ns + RETRY_NS;
    }
}

/* A score's replay, once the score is on disk. */
static void present_replay(struct kiosk *kiosk, const struct hal *hal)
{
    if (kiosk->config.chapters) {
        kiosk->faults.storage += (uint32_t)chapters_offer(kiosk->config.chapters, &hal->storage);
    }
}

/* The only writes to devices. The picture comes last: it may wait for the screen, and a sound
 * should not wait with it. */
static void present(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count)
{
    if (tick_count > 0) {
        present_sounds(kiosk, hal);
        present_switches(kiosk, hal);
        present_orders(kiosk, hal);
        present_forces(kiosk, hal);
        present_entries(kiosk, hal);
        present_replay(kiosk, hal);
        present_edit(kiosk, hal);
        end_for_restart(kiosk, hal);
    }
    present_picture(kiosk, hal);
}

/* An orderly end tells how long the machine was up, when nothing else waits to be told. */
static void tell_last_word(struct kiosk *kiosk, const struct hal *hal)
{
    struct ledger_entry entry;
    if (!kiosk->config.source.next && kiosk->accepted_id == kiosk->output.entry_id &&
        upkeep_last_word(&kiosk->core, &kiosk->input, &entry)) {
        hal->storage.ops->keep(hal->storage.self, &entry);
    }
}

uint32_t kiosk_close_store(struct kiosk *kiosk, const struct hal *hal)
{
    const int is_replay = kiosk->config.source.next != NULL;
    const uint32_t waiting = is_replay ? 0 : kiosk->output.entry_id - kiosk->accepted_id;
    tell_last_word(kiosk, hal);
    const uint32_t unwritten = hal->storage.ops->close(hal->storage.self);
    count_refused_writes(kiosk, &hal->storage);
    return unwritten + waiting;
}

static uint64_t stopwatch_ns(const struct kiosk *kiosk)
{
    return clock_ns(kiosk->config.stopwatch);
}

static void begin_frame(struct kiosk *kiosk)
{
    const uint64_t now_ns = stopwatch_ns(kiosk);
    if (kiosk->frames > 0) {
        timing_add(&kiosk->frame_time, now_ns - kiosk->frame_begin_ns);
    }
    kiosk->frame_begin_ns = now_ns;
    kiosk->frames++;
}

enum kiosk_end kiosk_frame(struct kiosk *kiosk, const struct hal *hal)
{
    begin_frame(kiosk);
    const uint32_t tick_due = pace_ticks_due(&kiosk->pace, clock_ns(hal->clock));
    sample_devices(kiosk, hal);
    if (tick_due > 0) {
        time_reports(kiosk, hal);
    }
    lighting_notice(&kiosk->lighting, &kiosk->input, kiosk->core.game.phase == PHASE_ATTRACT);
    const uint64_t core_begin_ns = stopwatch_ns(kiosk);
    const uint32_t tick_count = run_ticks(kiosk, tick_due);
    const struct dressing dressing = { .notes = kiosk->config.notes,
                                       .input = &kiosk->input,
                                       .hands = kiosk->hands,
                                       .lines = &kiosk->lines,
                                       .button_faults = kiosk->faults.buttons,
                                       .frame_ns = timing_quantile_ns(&kiosk->frame_time, 0.5) };
    show_encore(kiosk, hal, tick_count);
    dressing_put(&kiosk->scene, hal, &dressing);
    kiosk->core_ns += stopwatch_ns(kiosk) - core_begin_ns;
    show_hands(kiosk, hal);
    present(kiosk, hal, tick_count);
    if (tick_count > 0) {
        hal->watchdog.ops->kick(hal->watchdog.self); /* A hung core restarts the kiosk. */
    }
    timing_add(&kiosk->work_time, stopwatch_ns(kiosk) - kiosk->frame_begin_ns);
    return kiosk->end;
}
