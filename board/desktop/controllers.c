/* controllers.c -- opens the controllers (poi devices) and assigns them to the players' slots by
 * drivers/input_mux.h.
 *
 * The controllers are Kingyo's USB poi (drivers/hid/poi_report.h), the USB controllers that the
 * operator selected, game pads, mouse and touch screen. */
#include <SDL.h>
#include <stdio.h>

#include "board/desktop/parts.h"
#include "core/base/panic.h"
#include "drivers/hid/controller_manager.h"
#include "drivers/hid/hid_mapping_store.h"
#include "drivers/hid/poi_hid.h"
#include "drivers/input_mux.h"
#include "drivers/pointer/mouse_poi.h"
#include "drivers/usb/usb_transport.h"
#include "platform/os/log.h"

/* ---- USB ------------------------------------------------------------------------------------- */

/* Maximum size of a path in bytes, enough for the path of a data folder and a file name. */
#define PATH_SIZE 1100u

static struct {
    struct usb_event_thread *transport; /* State of the USB transport. Null means that the transport
                                           has not been started. */
    struct poi_hid poi[POI_MAX];
    struct hid_mapping_store store;
    struct controller_manager manager;
    struct usb_key listed[BOARD_USB_MAX];
    uint32_t listed_count;
    char choices[PATH_SIZE];
    char text[HAL_TEXT_SIZE];
} usb;

bool board_check_usb(const char *text)
{
    struct usb_key key;
    return usb_key_read(&key, text) == 0;
}

static void log_controller_warning(void *self, const char *line)
{
    (void)self;
    log_print(LOG_LEVEL_WARNING, "%s", line);
}

/* Reports a rejected mapping file in the log and on the operator's screen. Called only before
 * threads start. */
static void report_mapping_error(void *self, const char *line)
{
    const struct board_options *options = self;
    log_controller_warning(NULL, line);
    if (options->on_refused) {
        options->on_refused(options->on_refused_self, line);
    }
}

/* Opens USB only if the option --poi is auto or usb. */
static void usb_open(struct hal *hal, const struct board_options *options)
{
    if (options->poi != BOARD_POI_AUTO && options->poi != BOARD_POI_USB) {
        return;
    }
    struct poi_hid *pois[POI_MAX];
    usb.listed_count = 0;
    for (uint32_t i = 0; i < options->usb_count && i < BOARD_USB_MAX; i++) {
        usb.listed_count += usb_key_read(&usb.listed[usb.listed_count], options->usb[i]) == 0;
    }
    snprintf(usb.choices, sizeof usb.choices, "%.1000s/usb.txt",
             options->data_dir ? options->data_dir : "");
    const struct usb_transport_config config = {
        .clock = hal->clock,
        .choices = options->data_dir ? usb.choices : NULL,
        .listed = usb.listed,
        .listed_count = usb.listed_count,
        .report = log_controller_warning,
    };
    struct board_options report_options = *options;
    hid_mapping_store_open(&usb.store, options->data_dir, report_mapping_error, &report_options);
    hid_mapping_store_set_error_sink(&usb.store, log_controller_warning, NULL);
    usb.transport = usb_transport_start(&config, usb.text);
    if (usb.text[0]) {
        report_mapping_error(&report_options, usb.text);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        pois[i] = &usb.poi[i];
        poi_hid_init(pois[i], usb_transport_port(usb.transport, i), hal->clock,
                     hid_mapping_store_mapper(&usb.store), &options->view);
    }
    hal->controllers =
        controller_manager_init(&usb.manager, usb_transport_list(usb.transport), &usb.store, pois);
}

/* Returns true if the controller of a slot is ready to play. A controller is ready if it has a
 * mapping. Reports of controllers without a mapping are read too, so that the controller
 * manager can learn a mapping. */
static bool is_controller_ready(void *self)
{
    struct poi_hid *poi = self;
    const struct hal_poi device = poi_hid_devices(poi).poi;
    struct poi_sample discarded;
    if (!poi->is_open) {
        device.ops->open(device.self);
    } else if (!poi->plays) {
        device.ops->poll(device.self, &discarded, 1);
    }
    return poi->plays;
}

_Static_assert(GAMEPADS_EXCLUSION_MAX >= USB_REQUEST_MAX + CONTROLLER_MAX,
               "the list of exclusions has too few entries");

/* Copies two groups of USB controllers to `out`, which SDL must not open: the selected controllers,
 * and the controllers that are in use or were disconnected. Returns the number of controllers in
 * `out`. */
static uint32_t usb_exclusions(struct usb_key out[GAMEPADS_EXCLUSION_MAX])
{
    struct hid_row rows[CONTROLLER_MAX];
    if (!usb.transport) {
        return 0;
    }
    const struct hid_device_list device_list = usb_transport_list(usb.transport);
    uint32_t count = usb_transport_wanted(usb.transport, out);
    device_list.ops->rows(device_list.self, rows);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        if (rows[i].state == CONTROLLER_ACTIVE || rows[i].state == CONTROLLER_LOST) {
            out[count++] = usb_key_of(&rows[i].identity);
        }
    }
    return count;
}

/* ---- Game pads and pointers ------------------------------------------------------------------ */

static struct {
    struct input_mux mux;
    struct mouse_poi mouse;
    struct gamepads gamepads;
    bool has_pointer;
} devices;

/* Adds a poi and its fan to the input multiplexer. `kind` is an enum input_kind. */
static void add_source(struct hal_controller_devices parts, bool (*is_present)(void *self),
                       void *self, uint8_t kind, bool stands_in)
{
    const struct input_source source = {
        .poi = parts.poi,
        .fan = parts.fan,
        .is_present = is_present,
        .self = self,
        .kind = kind,
        .stands_in = stands_in,
    };
    input_mux_add(&devices.mux, &source);
}

/* Returns true if the option --poi is auto or selects this kind. */
static bool is_on(const struct board_options *options, enum board_poi kind)
{
    return options->poi == BOARD_POI_AUTO || options->poi == kind;
}

static void add_pointer(struct hal *hal, const struct board_options *options, uint32_t kinds)
{
    CORE_ASSERT(kinds != 0);
    const uint32_t width = options->width ? options->width : 1280;
    const uint32_t height = options->height ? options->height : 720;
    mouse_poi_init(&devices.mouse, hal->clock, &options->view, width, height, kinds);
    devices.has_pointer = true;
    add_source(mouse_poi_devices(&devices.mouse), mouse_poi_is_used, &devices.mouse,
               INPUT_KIND_POINTER, true);
}

/* Excludes the devices of the USB driver from SDL, so that each device has one owner. */
static void bar_pads(void)
{
    struct usb_key bar[GAMEPADS_EXCLUSION_MAX] = { 0 };
    gamepads_exclude(&devices.gamepads, bar, usb_exclusions(bar));
}

/* Returns true if the game pad is plugged in. Also updates the devices that are excluded from SDL,
 * because the operator may select USB controllers while the kiosk runs. */
static bool pad_is_present(void *self)
{
    if (self == &devices.gamepads.pad[0]) {
        bar_pads();
    }
    return gamepad_poi_is_present(self);
}

/* Adds the game pads. A file in the data folder can contain mappings of game pads that SDL does not
 * know. */
static void add_pads(struct hal *hal, const struct board_options *options)
{
    CORE_ASSERT(hal->clock.ops);
    char database[1100] = "";
    if (options->data_dir) {
        snprintf(database, sizeof database, "%.1024s/gamecontrollerdb.txt", options->data_dir);
    }
    gamepads_init(&devices.gamepads, hal->clock, &options->view);
    bar_pads();
    gamepads_open(&devices.gamepads, database[0] ? database : NULL);
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        add_source(gamepad_poi_devices(&devices.gamepads, i), pad_is_present,
                   &devices.gamepads.pad[i], INPUT_KIND_GAMEPAD, false);
    }
}

static const char *missing_poi(uint8_t poi)
{
    return poi == BOARD_POI_PAD   ? "no pad yet: plug one in; --poi auto plays with the mouse, too"
           : poi == BOARD_POI_USB ? "no USB poi yet: plug one in, or choose a controller in the "
                                    "operator's menu; --poi auto plays with the mouse, too"
                                  : "";
}

void controllers_open(struct hal *hal, const struct board_options *options)
{
    CORE_ASSERT(hal->clock.ops && options);
    /* Pointer devices in use, as bits of enum pointer_filter. The mouse and the touch screen
     * control the same poi. The device that moved last sets the position of the poi. */
    const uint32_t kinds = (is_on(options, BOARD_POI_MOUSE) ? (uint32_t)POINTER_FILTER_MOUSE : 0u) |
                           (is_on(options, BOARD_POI_TOUCH) ? (uint32_t)POINTER_FILTER_TOUCH : 0u);
    usb_open(hal, options);
    devices.has_pointer = false;
    /* No pointer device is in use, so no driver reads mouse and touch events. SDL therefore drops
     * them. */
    if (!kinds) {
        static const Uint32 types[] = { SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP,
                                        SDL_MOUSEWHEEL,  SDL_FINGERDOWN,      SDL_FINGERUP,
                                        SDL_FINGERMOTION };
        screen_ignore(types, sizeof types / sizeof types[0]);
    }
    if (options->poi == BOARD_POI_BOT) {
        return;
    }
    hal->slots = input_mux_init(&devices.mux, hal, missing_poi(options->poi));
    for (uint32_t i = 0; usb.transport && i < POI_MAX; i++) {
        add_source(poi_hid_devices(&usb.poi[i]), is_controller_ready, &usb.poi[i], INPUT_KIND_USB,
                   false);
    }
    if (is_on(options, BOARD_POI_PAD)) {
        add_pads(hal, options);
    }
    if (kinds) {
        add_pointer(hal, options, kinds);
    }
}

void controllers_add_buttons(struct input_buttons *buttons)
{
    for (uint32_t i = 0; usb.transport && i < POI_MAX; i++) {
        input_buttons_add(buttons, poi_hid_devices(&usb.poi[i]).buttons);
    }
    if (devices.gamepads.is_open) {
        input_buttons_add(buttons, gamepad_poi_devices(&devices.gamepads, 0).buttons);
    }
    if (devices.has_pointer) {
        input_buttons_add(buttons, mouse_poi_devices(&devices.mouse).buttons);
    }
}

void controllers_close(void)
{
    gamepads_close(&devices.gamepads);
    if (usb.transport) {
        usb_transport_stop(usb.transport);
        hid_mapping_store_close(&usb.store);
        usb.transport = NULL;
    }
}
