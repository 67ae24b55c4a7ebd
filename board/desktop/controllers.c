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
    struct usb_seats *seats; /* State of the USB transport. Null means that the transport has not
                                been started. */
    struct poi_hid poi[POI_MAX];
    struct hid_mapping_store book;
    struct controller_manager desk;
    struct usb_key listed[BOARD_USB_MAX];
    uint32_t listed_count;
    char choices[PATH_SIZE];
    char text[HAL_TEXT_SIZE];
} usb;

int board_check_usb(const char *text)
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
static void complain_of_file(void *self, const char *line)
{
    const struct board_options *options = self;
    log_controller_warning(NULL, line);
    if (options->on_refused) {
        options->on_refused(options->on_refused_self, line);
    }
}

static void open_desk(struct hal *hal, const struct board_options *options)
{
    CORE_ASSERT(hal->clock.ops);
    struct poi_hid *seats[POI_MAX];
    for (uint32_t i = 0; i < POI_MAX; i++) {
        seats[i] = &usb.poi[i];
        poi_hid_init(seats[i], usb_transport_port(usb.seats, i), hal->clock,
                     hid_mapping_store_mapper(&usb.book), &options->view);
    }
    controller_manager_init(&usb.desk, usb_transport_roster(usb.seats), &usb.book, seats);
    hal->controllers = controller_manager_device(&usb.desk);
}

/* Opens USB only if the option --poi is auto or usb. */
static void usb_open(struct hal *hal, const struct board_options *options)
{
    if (options->poi != BOARD_POI_AUTO && options->poi != BOARD_POI_USB) {
        return;
    }
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
        .tell = log_controller_warning,
    };
    struct board_options told = *options;
    hid_mapping_store_open(&usb.book, options->data_dir, complain_of_file, &told);
    hid_mapping_store_set_error_sink(&usb.book, log_controller_warning, NULL);
    usb.seats = usb_transport_start(&config, usb.text);
    if (usb.text[0]) {
        complain_of_file(&told, usb.text);
    }
    open_desk(hal, options);
}

/* Returns 1 if the controller of a slot is ready to play, otherwise 0. A controller is ready if it
 * has a mapping. Reports of controllers without a mapping are read too, so that the controller
 * manager can learn a mapping. */
static int is_controller_ready(void *self)
{
    struct poi_hid *poi = self;
    const struct hal_poi device = poi_hid_device(poi);
    struct poi_sample unheard;
    if (!poi->is_open) {
        device.ops->open(device.self);
    } else if (!poi->plays) {
        device.ops->poll(device.self, &unheard, 1);
    }
    return poi->is_open && poi->plays;
}

static void usb_add_seats(struct input_mux *seats)
{
    CORE_ASSERT(seats);
    for (uint32_t i = 0; usb.seats && i < POI_MAX; i++) {
        const struct input_source source = {
            .poi = poi_hid_device(&usb.poi[i]),
            .fan = poi_hid_fan(&usb.poi[i]),
            .is_there = is_controller_ready,
            .self = &usb.poi[i],
            .kind = INPUT_KIND_USB,
        };
        input_mux_add(seats, &source);
    }
}

static void usb_fill_exclusion(struct gamepad_exclusion *out, uint16_t vendor, uint16_t product,
                               const char *serial)
{
    *out = (struct gamepad_exclusion){ .vendor = vendor, .product = product };
    snprintf(out->serial, sizeof out->serial, "%s", serial);
}

_Static_assert(GAMEPADS_EXCLUSION_MAX >= USB_REQUEST_MAX + CONTROLLER_MAX,
               "every one of both finds room");

/* Copies two groups of USB controllers to `out`, which SDL must not open: the selected controllers,
 * and the controllers that are in use or were disconnected. Returns the number of controllers in
 * `out`. */
static uint32_t usb_exclusions(struct gamepad_exclusion out[GAMEPADS_EXCLUSION_MAX])
{
    struct usb_key wanted[USB_REQUEST_MAX];
    struct hid_row rows[CONTROLLER_MAX];
    uint32_t count = 0;
    if (!usb.seats) {
        return 0;
    }
    const struct hid_device_list device_list = usb_transport_roster(usb.seats);
    const uint32_t wanted_count = usb_transport_wanted(usb.seats, wanted);
    device_list.ops->rows(device_list.self, rows);
    for (uint32_t i = 0; i < wanted_count; i++) {
        usb_fill_exclusion(&out[count++], wanted[i].vendor, wanted[i].product, wanted[i].serial);
    }
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        const struct hid_identity *who = &rows[i].identity;
        if (rows[i].state == CONTROLLER_ACTIVE || rows[i].state == CONTROLLER_LOST) {
            usb_fill_exclusion(&out[count++], who->vendor, who->product, who->serial);
        }
    }
    return count;
}

/* ---- Game pads and pointers ------------------------------------------------------------------ */

static struct {
    struct input_mux seats;
    struct mouse_poi mouse;
    struct gamepads gamepads;
    uint8_t has_pointer;
} hands;

static int wants(const struct board_options *options, enum board_poi kind)
{
    return options->poi == BOARD_POI_AUTO || options->poi == kind;
}

static void add_pointer(struct hal *hal, const struct board_options *options, uint32_t heeds)
{
    CORE_ASSERT(heeds != 0);
    const uint32_t width = options->width ? options->width : 1280;
    const uint32_t height = options->height ? options->height : 720;
    mouse_poi_init(&hands.mouse, hal->clock, &options->view, width, height, heeds);
    hands.has_pointer = 1;
    const struct input_source mouse = {
        .poi = mouse_poi_device(&hands.mouse),
        .fan = mouse_poi_fan(&hands.mouse),
        .is_there = mouse_poi_is_used,
        .self = &hands.mouse,
        .kind = INPUT_KIND_POINTER,
        .stands_in = 1,
    };
    input_mux_add(&hands.seats, &mouse);
}

/* Excludes the devices of the USB driver from SDL, so that each device has one owner. */
static void bar_pads(void)
{
    struct gamepad_exclusion bar[GAMEPADS_EXCLUSION_MAX] = { 0 };
    gamepads_exclude(&hands.gamepads, bar, usb_exclusions(bar));
}

/* Returns 1 if the game pad is plugged in, otherwise 0. The operator may select USB controllers
 * while the kiosk runs, so the exclusions are updated once in each frame. */
static int pad_is_there(void *self)
{
    if (self == &hands.gamepads.pad[0]) {
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
    gamepads_init(&hands.gamepads, hal->clock, &options->view);
    bar_pads();
    gamepads_open(&hands.gamepads, database[0] ? database : NULL);
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        const struct input_source pad = {
            .poi = gamepad_poi_device(&hands.gamepads, i),
            .fan = gamepad_poi_fan(&hands.gamepads, i),
            .is_there = pad_is_there,
            .self = &hands.gamepads.pad[i],
            .kind = INPUT_KIND_GAMEPAD,
        };
        input_mux_add(&hands.seats, &pad);
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
    const uint32_t heeds = (wants(options, BOARD_POI_MOUSE) ? (uint32_t)POINTER_FILTER_MOUSE : 0u) |
                           (wants(options, BOARD_POI_TOUCH) ? (uint32_t)POINTER_FILTER_TOUCH : 0u);
    usb_open(hal, options);
    hands.has_pointer = 0;
    if (!heeds) { /* SDL drops mouse and touch events, because no driver reads them. */
        static const Uint32 types[] = { SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP,
                                        SDL_MOUSEWHEEL,  SDL_FINGERDOWN,      SDL_FINGERUP,
                                        SDL_FINGERMOTION };
        screen_ignore(types, sizeof types / sizeof types[0]);
    }
    if (options->poi == BOARD_POI_BOT) {
        return;
    }
    input_mux_init(&hands.seats, missing_poi(options->poi));
    usb_add_seats(&hands.seats);
    if (wants(options, BOARD_POI_PAD)) {
        add_pads(hal, options);
    }
    if (heeds) {
        add_pointer(hal, options, heeds);
    }
    hal->seats = input_mux_device(&hands.seats);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hal->poi[i] = input_mux_poi(&hands.seats, i);
        hal->fan[i] = input_mux_fan(&hands.seats, i);
    }
}

void controllers_add_buttons(struct buttons_mux *join)
{
    for (uint32_t i = 0; usb.seats && i < POI_MAX; i++) {
        buttons_mux_add(join, poi_hid_buttons(&usb.poi[i]));
    }
    if (hands.gamepads.is_open) {
        buttons_mux_add(join, gamepad_poi_buttons(&hands.gamepads));
    }
    if (hands.has_pointer) {
        buttons_mux_add(join, mouse_poi_buttons(&hands.mouse));
    }
}

void controllers_close(void)
{
    gamepads_close(&hands.gamepads);
    if (usb.seats) {
        usb_transport_stop(usb.seats);
        hid_mapping_store_close(&usb.book);
        usb.seats = NULL;
    }
}
