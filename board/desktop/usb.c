/* usb.c -- opens USB controllers: Kingyo's poi controller (drivers/hid/poi_report.h), and the
 * controllers that the operator selected. */
#include <stdio.h>

#include "board/desktop/parts.h"
#include "drivers/hid/controller_manager.h"
#include "drivers/hid/hid_mapping_store.h"
#include "drivers/hid/poi_hid.h"
#include "drivers/usb/usb_transport.h"
#include "platform/os/log.h"

#define PATH_SIZE 1100u /* Size of a path; large enough for a data folder and a file name. */

static struct {
    struct usb_seats *usb; /* The USB transport; null means that it is not started. */
    struct poi_hid poi[POI_MAX];
    struct hid_mapping_store book;
    struct controller_manager desk;
    struct usb_key listed[BOARD_USB_MAX];
    uint32_t listed_count;
    char choices[PATH_SIZE];
    char text[HAL_TEXT_SIZE];
} devices;

static void read_listed(const struct board_options *options)
{
    devices.listed_count = 0;
    for (uint32_t i = 0; i < options->usb_count && i < BOARD_USB_MAX; i++) {
        if (usb_key_read(&devices.listed[devices.listed_count], options->usb[i]) == 0) {
            devices.listed_count++;
        }
    }
}

int board_check_usb(const char *text)
{
    struct usb_key key;
    return usb_key_read(&key, text) == 0;
}

static void complain(void *self, const char *line)
{
    (void)self;
    log_print(LOG_LEVEL_WARNING, "%s", line);
}

/* Reports a rejected file in the log and on the operator's screen. Called only before threads
 * start. */
static void complain_of_file(void *self, const char *line)
{
    const struct board_options *options = self;
    complain(NULL, line);
    if (options->on_refused) {
        options->on_refused(options->on_refused_self, line);
    }
}

static void open_desk(struct hal *hal, const struct board_options *options)
{
    struct poi_hid *seats[POI_MAX];
    for (uint32_t i = 0; i < POI_MAX; i++) {
        seats[i] = &devices.poi[i];
        poi_hid_init(seats[i], usb_transport_port(devices.usb, i), hal->clock,
                     hid_mapping_store_mapper(&devices.book), &options->view);
    }
    controller_manager_init(&devices.desk, usb_transport_roster(devices.usb), &devices.book, seats);
    hal->controllers = controller_manager_device(&devices.desk);
}

/* Opens USB only if the option --poi is auto or usb. */
void usb_open(struct hal *hal, const struct board_options *options)
{
    if (options->poi != BOARD_POI_AUTO && options->poi != BOARD_POI_USB) {
        return;
    }
    read_listed(options);
    snprintf(devices.choices, sizeof devices.choices, "%.1000s/usb.txt",
             options->data_dir ? options->data_dir : "");
    const struct usb_transport_config config = {
        .clock = hal->clock,
        .choices = options->data_dir ? devices.choices : NULL,
        .listed = devices.listed,
        .listed_count = devices.listed_count,
        .tell = complain,
    };
    struct board_options told = *options;
    hid_mapping_store_open(&devices.book, options->data_dir, complain_of_file, &told);
    hid_mapping_store_set_error_sink(&devices.book, complain, NULL);
    devices.usb = usb_transport_start(&config, devices.text);
    if (devices.text[0]) {
        complain_of_file(&told, devices.text);
    }
    open_desk(hal, options);
}

/* Returns 1 if the controller of a slot is ready to play, otherwise 0. A controller is ready if it
 * has a mapping. Reports of controllers without a mapping are read too, so that the controller
 * manager can learn a mapping. */
static int is_there(void *self)
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

void usb_add_seats(struct input_mux *seats)
{
    for (uint32_t i = 0; devices.usb && i < POI_MAX; i++) {
        const struct input_source source = {
            .poi = poi_hid_device(&devices.poi[i]),
            .fan = poi_hid_fan(&devices.poi[i]),
            .is_there = is_there,
            .self = &devices.poi[i],
            .kind = INPUT_KIND_USB,
        };
        input_mux_add(seats, &source);
    }
}

void usb_add_buttons(struct buttons_mux *join)
{
    for (uint32_t i = 0; devices.usb && i < POI_MAX; i++) {
        buttons_mux_add(join, poi_hid_buttons(&devices.poi[i]));
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

/* Copies the selected controllers, which SDL must not open from the start, and the controllers that
 * play or were lost. Returns their number. */
uint32_t usb_exclusions(struct gamepad_exclusion out[GAMEPADS_EXCLUSION_MAX])
{
    struct usb_key wanted[USB_REQUEST_MAX];
    struct hid_row rows[CONTROLLER_MAX];
    uint32_t count = 0;
    if (!devices.usb) {
        return 0;
    }
    const struct hid_device_list device_list = usb_transport_roster(devices.usb);
    const uint32_t wanted_count = usb_transport_wanted(devices.usb, wanted);
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

void usb_close(void)
{
    if (devices.usb) {
        usb_transport_stop(devices.usb);
        hid_mapping_store_close(&devices.book);
        devices.usb = NULL;
    }
}
