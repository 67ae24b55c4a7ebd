/* pads.c -- game pad hot-plug, and SDL's controller events as pad reports. */
#include "drivers/pads.h"

#include <SDL.h>
#include <stdio.h>
#include <string.h>

#include "drivers/usb_sysfs.h"

#define EVENT_BATCH 64

_Static_assert(PAD_SOUTH == 1u << SDL_CONTROLLER_BUTTON_A, "");
_Static_assert(PAD_EAST == 1u << SDL_CONTROLLER_BUTTON_B, "");
_Static_assert(PAD_WEST == 1u << SDL_CONTROLLER_BUTTON_X, "");
_Static_assert(PAD_NORTH == 1u << SDL_CONTROLLER_BUTTON_Y, "");
_Static_assert(PAD_BACK == 1u << SDL_CONTROLLER_BUTTON_BACK, "");
_Static_assert(PAD_START == 1u << SDL_CONTROLLER_BUTTON_START, "");
_Static_assert(PAD_STICK_RIGHT == 1u << SDL_CONTROLLER_BUTTON_RIGHTSTICK, "");
_Static_assert(PAD_SHOULDER_LEFT == 1u << SDL_CONTROLLER_BUTTON_LEFTSHOULDER, "");
_Static_assert(PAD_SHOULDER_RIGHT == 1u << SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, "");
_Static_assert(PAD_UP == 1u << SDL_CONTROLLER_BUTTON_DPAD_UP, "");
_Static_assert(PAD_DOWN == 1u << SDL_CONTROLLER_BUTTON_DPAD_DOWN, "");
_Static_assert(PAD_LEFT == 1u << SDL_CONTROLLER_BUTTON_DPAD_LEFT, "");
_Static_assert(PAD_RIGHT == 1u << SDL_CONTROLLER_BUTTON_DPAD_RIGHT, "");
_Static_assert(PAD_LEAD_X == (int)SDL_CONTROLLER_AXIS_LEFTX, "");
_Static_assert(PAD_LEAD_Y == (int)SDL_CONTROLLER_AXIS_LEFTY, "");
_Static_assert(PAD_TILT_X == (int)SDL_CONTROLLER_AXIS_RIGHTX, "");
_Static_assert(PAD_TILT_Y == (int)SDL_CONTROLLER_AXIS_RIGHTY, "");
_Static_assert(PAD_TRIGGER_LEFT == (int)SDL_CONTROLLER_AXIS_TRIGGERLEFT, "");
_Static_assert(PAD_TRIGGER_RIGHT == (int)SDL_CONTROLLER_AXIS_TRIGGERRIGHT, "");

uint64_t pads_now_ns(const struct pads *pads)
{
    return pads->clock.ops->now_ns(pads->clock.self);
}

/* ---- Hot-plug -------------------------------------------------------------------------------- */

static struct pad *pad_of(struct pads *pads, int32_t instance)
{
    for (uint32_t i = 0; i < PADS_MAX; i++) {
        if (pads->pad[i].controller && pads->pad[i].instance == instance) {
            return &pads->pad[i];
        }
    }
    return NULL;
}

static int was(const struct pad *pad, const char *guid, const char *serial)
{
    return pad->was_here && strcmp(pad->guid, guid) == 0 && strcmp(pad->serial, serial) == 0;
}

/* Returns a free place: the pad's former one, else one never used, else any. Returns null if all
 * are in use. */
static struct pad *place_for(struct pads *pads, const char *guid, const char *serial)
{
    struct pad *unused = NULL;
    struct pad *any = NULL;
    for (uint32_t i = PADS_MAX; i-- > 0;) {
        struct pad *pad = &pads->pad[i];
        if (pad->controller) {
            continue;
        }
        if (was(pad, guid, serial)) {
            return pad;
        }
        any = pad;
        unused = pad->was_here ? unused : pad;
    }
    return unused ? unused : any;
}

static void begin_pad(struct pad *pad)
{
    const char *name = SDL_GameControllerName(pad->controller);
    pad->now = (struct pad_report){ 0 };
    pad->was_here = 1;
    pad->rumble = (struct pad_rumble){ 0 };
    pad->cannot_rumble = SDL_GameControllerHasRumble(pad->controller) == SDL_FALSE;
    pad_track_init(&pad->track, &pad->pads->view, pads_now_ns(pad->pads));
    snprintf(pad->text, sizeof pad->text, "pad: %.80s%s (left stick leads, A dips)",
             name ? name : "of no name", pad->cannot_rumble ? "" : ", rumbles");
}

/* Enables the motion sensors of a pad that has them. */
static void begin_motion(struct pad *pad)
{
    static const SDL_SensorType types[] = { SDL_SENSOR_GYRO, SDL_SENSOR_ACCEL };
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        if (SDL_GameControllerHasSensor(pad->controller, types[i])) {
            SDL_GameControllerSetSensorEnabled(pad->controller, types[i], SDL_TRUE);
        }
    }
}

int pads_are_barred(const struct pads *pads, uint16_t vendor, uint16_t product,
                    const char *serial)
{
    for (uint32_t i = 0; i < pads->bar_count; i++) {
        const struct pad_bar *bar = &pads->bar[i];
        if (bar->vendor == vendor && bar->product == product &&
            (!bar->serial[0] || !serial[0] || !strcmp(bar->serial, serial))) {
            return 1;
        }
    }
    return 0;
}

/* Reads the ids of a pad that is not opened yet. */
static void look_at(int32_t device_index, struct pad *out)
{
    const char *node = SDL_JoystickPathForIndex(device_index);
    out->vendor = SDL_JoystickGetDeviceVendor(device_index);
    out->product = SDL_JoystickGetDeviceProduct(device_index);
    usb_sysfs_node_serial("/sys", node ? node : "", out->usb_serial);
}

/* Opens a new pad. When all places are in use the pad is ignored until it is plugged in again. */
static void plug_in(struct pads *pads, int32_t device_index)
{
    char guid[PAD_GUID_SIZE];
    char serial[sizeof pads->pad[0].serial] = "";
    struct pad seen = { 0 };
    if (!SDL_IsGameController(device_index) ||
        pad_of(pads, SDL_JoystickGetDeviceInstanceID(device_index))) {
        return;
    }
    look_at(device_index, &seen);
    if (pads_are_barred(pads, seen.vendor, seen.product, seen.usb_serial)) {
        return;
    }
    SDL_GameController *controller = SDL_GameControllerOpen(device_index);
    if (!controller) {
        return;
    }
    const char *said = SDL_GameControllerGetSerial(controller);
    SDL_Joystick *joystick = SDL_GameControllerGetJoystick(controller);
    SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(joystick), guid, (int)sizeof guid);
    snprintf(serial, sizeof serial, "%.31s", said ? said : "");
    struct pad *pad = place_for(pads, guid, serial);
    if (!pad) {
        SDL_GameControllerClose(controller);
        return;
    }
    memcpy(pad->guid, guid, sizeof guid);
    memcpy(pad->serial, serial, sizeof serial);
    memcpy(pad->usb_serial, seen.usb_serial, sizeof seen.usb_serial);
    pad->vendor = seen.vendor;
    pad->product = seen.product;
    pad->controller = controller;
    pad->instance = SDL_JoystickInstanceID(joystick);
    begin_pad(pad);
    begin_motion(pad);
}

static void pull_out(struct pads *pads, int32_t instance)
{
    struct pad *pad = pad_of(pads, instance);
    if (pad) {
        SDL_GameControllerClose(pad->controller);
        pad->controller = NULL;
    }
}

/* ---- Events ---------------------------------------------------------------------------------- */

static void keep(struct pad *pad, uint64_t time_ns)
{
    pad->now.time_ns = time_ns;
    pad_track_keep(&pad->track, &pad->now);
    pad->now.has_turn = pad->now.has_weight = 0;
}

static void move_axis(struct pads *pads, const SDL_ControllerAxisEvent *event, uint64_t time_ns)
{
    struct pad *pad = pad_of(pads, event->which);
    if (pad && event->axis < PAD_AXIS_COUNT) {
        pad->now.axis[event->axis] = event->value;
        keep(pad, time_ns);
    }
}

static void press(struct pads *pads, const SDL_ControllerButtonEvent *event, uint64_t time_ns)
{
    struct pad *pad = pad_of(pads, event->which);
    if (pad && event->button < 32) {
        const uint32_t bit = 1u << event->button;
        pad->now.buttons = event->state == SDL_PRESSED ? pad->now.buttons | bit
                                                       : pad->now.buttons & ~bit;
        keep(pad, time_ns);
    }
}

static void sense(struct pads *pads, const SDL_ControllerSensorEvent *event, uint64_t time_ns)
{
    struct pad *pad = pad_of(pads, event->which);
    const vec3 data = v3(event->data[0], event->data[1], event->data[2]);
    if (pad && event->sensor == SDL_SENSOR_GYRO) {
        pad->now.has_turn = 1;
        pad->now.turn_rad_s = data;
        keep(pad, time_ns);
    } else if (pad && event->sensor == SDL_SENSOR_ACCEL) {
        pad->now.has_weight = 1;
        pad->now.weight_m_s2 = data;
        keep(pad, time_ns);
    }
}

static void take_event(struct pads *pads, const SDL_Event *event, uint64_t time_ns)
{
    switch (event->type) {
    case SDL_CONTROLLERDEVICEADDED:
        plug_in(pads, event->cdevice.which);
        break;
    case SDL_CONTROLLERDEVICEREMOVED:
        pull_out(pads, event->cdevice.which);
        break;
    case SDL_CONTROLLERAXISMOTION:
        move_axis(pads, &event->caxis, time_ns);
        break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
        press(pads, &event->cbutton, time_ns);
        break;
    case SDL_CONTROLLERSENSORUPDATE:
        sense(pads, &event->csensor, time_ns);
        break;
    default: /* Events of the joystick API repeat the controller events. */
        break;
    }
}

/* Processes all pending events. SDL stamps events with the time of pumping, so they are spread
 * evenly over the time since the last call. */
void pads_pump(struct pads *pads)
{
    SDL_Event events[EVENT_BATCH];
    const uint64_t now = pads_now_ns(pads);
    int taken;
    if (!pads->is_open) {
        return;
    }
    do {
        const uint64_t span_ns = now - pads->pumped_ns;
        taken = SDL_PeepEvents(events, EVENT_BATCH, SDL_GETEVENT, SDL_JOYAXISMOTION,
                               SDL_FINGERDOWN - 1);
        for (int i = 0; i < taken; i++) {
            take_event(pads, &events[i],
                       pads->pumped_ns + span_ns * (uint64_t)(i + 1) / (uint64_t)taken);
        }
        pads->pumped_ns = taken > 0 ? now : pads->pumped_ns;
    } while (taken == EVENT_BATCH);
    pads->pumped_ns = now;
}

/* ---- Start and stop -------------------------------------------------------------------------- */

void pads_init(struct pads *pads, struct hal_clock clock, const struct view *view)
{
    *pads = (struct pads){ .clock = clock, .view = *view };
    for (uint32_t i = 0; i < PADS_MAX; i++) {
        pads->pad[i].pads = pads;
        pad_track_init(&pads->pad[i].track, view, 0);
    }
}

static void hint_at_bars(const struct pads *pads)
{
    char list[PADS_BAR_MAX * sizeof "0x0000/0x0000,"] = "";
    for (uint32_t i = 0; i < pads->bar_count; i++) {
        const size_t length = strlen(list);
        if (pads->bar[i].serial[0]) {
            continue;
        }
        snprintf(list + length, sizeof list - length, "0x%04x/0x%04x,", pads->bar[i].vendor,
                 pads->bar[i].product);
    }
    SDL_SetHint(SDL_HINT_GAMECONTROLLER_IGNORE_DEVICES, list);
}

void pads_bar(struct pads *pads, const struct pad_bar *bar, uint32_t count)
{
    const uint32_t kept = count < PADS_BAR_MAX ? count : PADS_BAR_MAX;
    if (kept == pads->bar_count && memcmp(pads->bar, bar, kept * sizeof *bar) == 0) {
        return;
    }
    memcpy(pads->bar, bar, kept * sizeof *bar);
    pads->bar_count = kept;
    hint_at_bars(pads);
    for (uint32_t i = 0; i < PADS_MAX; i++) {
        const struct pad *pad = &pads->pad[i];
        if (pad->controller &&
            pads_are_barred(pads, pad->vendor, pad->product, pad->usb_serial)) {
            pull_out(pads, pad->instance);
        }
    }
}

int pads_open(struct pads *pads, const char *database)
{
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    hint_at_bars(pads);
    if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0) {
        snprintf(pads->text, sizeof pads->text, "no pads: SDL: %.100s", SDL_GetError());
        return HAL_ERR_NONE;
    }
    if (database) {
        SDL_GameControllerAddMappingsFromFile(database); /* A missing file is not an error. */
    }
    pads->is_open = 1;
    pads->pumped_ns = pads_now_ns(pads);
    for (int i = 0; i < SDL_NumJoysticks(); i++) {
        plug_in(pads, i);
    }
    return HAL_OK;
}

void pads_close(struct pads *pads)
{
    for (uint32_t i = 0; i < PADS_MAX; i++) {
        if (pads->pad[i].controller) {
            SDL_GameControllerClose(pads->pad[i].controller);
            pads->pad[i].controller = NULL;
        }
    }
    if (pads->is_open) {
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
        pads->is_open = 0;
    }
}
