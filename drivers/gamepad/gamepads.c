/* gamepads.c -- implements hot-plug of game pads, and converts SDL's controller events to
 * reports. */
#include "drivers/gamepad/gamepads.h"

#include <SDL.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/usb/usb_sysfs.h"

#define EVENT_BATCH 64

_Static_assert(
    offsetof(SDL_ControllerAxisEvent, which) == offsetof(SDL_ControllerDeviceEvent, which) &&
        offsetof(SDL_ControllerButtonEvent, which) == offsetof(SDL_ControllerDeviceEvent, which) &&
        offsetof(SDL_ControllerSensorEvent, which) == offsetof(SDL_ControllerDeviceEvent, which),
    "the instance id of all controller events is at the same place");
_Static_assert(GAMEPAD_SOUTH == 1u << SDL_CONTROLLER_BUTTON_A &&
                   GAMEPAD_EAST == 1u << SDL_CONTROLLER_BUTTON_B &&
                   GAMEPAD_WEST == 1u << SDL_CONTROLLER_BUTTON_X &&
                   GAMEPAD_NORTH == 1u << SDL_CONTROLLER_BUTTON_Y &&
                   GAMEPAD_BACK == 1u << SDL_CONTROLLER_BUTTON_BACK &&
                   GAMEPAD_START == 1u << SDL_CONTROLLER_BUTTON_START &&
                   GAMEPAD_STICK_RIGHT == 1u << SDL_CONTROLLER_BUTTON_RIGHTSTICK &&
                   GAMEPAD_SHOULDER_LEFT == 1u << SDL_CONTROLLER_BUTTON_LEFTSHOULDER &&
                   GAMEPAD_SHOULDER_RIGHT == 1u << SDL_CONTROLLER_BUTTON_RIGHTSHOULDER &&
                   GAMEPAD_UP == 1u << SDL_CONTROLLER_BUTTON_DPAD_UP &&
                   GAMEPAD_DOWN == 1u << SDL_CONTROLLER_BUTTON_DPAD_DOWN &&
                   GAMEPAD_LEFT == 1u << SDL_CONTROLLER_BUTTON_DPAD_LEFT &&
                   GAMEPAD_RIGHT == 1u << SDL_CONTROLLER_BUTTON_DPAD_RIGHT,
               "the buttons are those of SDL");
_Static_assert(GAMEPAD_LEAD_X == (int)SDL_CONTROLLER_AXIS_LEFTX &&
                   GAMEPAD_LEAD_Y == (int)SDL_CONTROLLER_AXIS_LEFTY &&
                   GAMEPAD_TILT_X == (int)SDL_CONTROLLER_AXIS_RIGHTX &&
                   GAMEPAD_TILT_Y == (int)SDL_CONTROLLER_AXIS_RIGHTY &&
                   GAMEPAD_TRIGGER_LEFT == (int)SDL_CONTROLLER_AXIS_TRIGGERLEFT &&
                   GAMEPAD_TRIGGER_RIGHT == (int)SDL_CONTROLLER_AXIS_TRIGGERRIGHT,
               "the axes are those of SDL");

/* ---- Hot-plug -------------------------------------------------------------------------------- */

static struct gamepad *pad_of(struct gamepads *gamepads, int32_t instance)
{
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        if (gamepads->pad[i].controller && gamepads->pad[i].instance == instance) {
            return &gamepads->pad[i];
        }
    }
    return NULL;
}

/* Returns a free element of `pad`. The element that the pad used last is preferred, then an element
 * that was never used. Returns null if all elements are in use. */
static struct gamepad *free_pad(struct gamepads *gamepads, const char *guid, const char *serial)
{
    struct gamepad *unused = NULL;
    struct gamepad *any = NULL;
    for (uint32_t i = GAMEPADS_MAX; i-- > 0;) {
        struct gamepad *pad = &gamepads->pad[i];
        if (pad->controller) {
            continue;
        }
        if (pad->was_here && strcmp(pad->guid, guid) == 0 && strcmp(pad->serial, serial) == 0) {
            return pad;
        }
        any = pad;
        unused = pad->was_here ? unused : pad;
    }
    return unused ? unused : any;
}

static void begin_pad(struct gamepad *pad)
{
    CORE_ASSERT(pad->controller && pad->gamepads);
    const char *name = SDL_GameControllerName(pad->controller);
    pad->now = (struct gamepad_report){ 0 };
    pad->was_here = true;
    pad->rumble = (struct gamepad_rumble){ 0 };
    pad->cannot_rumble = SDL_GameControllerHasRumble(pad->controller) == SDL_FALSE;
    gamepad_queue_init(&pad->track, &pad->gamepads->view, hal_now_ns(pad->gamepads->clock));
    snprintf(pad->text, sizeof pad->text, "pad: %.80s%s (left stick leads, A dips)",
             name ? name : "of no name", pad->cannot_rumble ? "" : ", rumbles");
    /* The gyroscope and the accelerometer are enabled if the pad has these sensors. */
    static const SDL_SensorType types[] = { SDL_SENSOR_GYRO, SDL_SENSOR_ACCEL };
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        if (SDL_GameControllerHasSensor(pad->controller, types[i])) {
            SDL_GameControllerSetSensorEnabled(pad->controller, types[i], SDL_TRUE);
        }
    }
}

bool gamepads_is_excluded(const struct gamepads *gamepads, const struct usb_key *key)
{
    CORE_ASSERT(gamepads->bar_count <= GAMEPADS_EXCLUSION_MAX);
    CORE_ASSERT(key);
    for (uint32_t i = 0; i < gamepads->bar_count; i++) {
        const struct usb_key *bar = &gamepads->bar[i];
        if (bar->vendor == key->vendor && bar->product == key->product &&
            (!bar->serial[0] || !key->serial[0] || !strcmp(bar->serial, key->serial))) {
            return true;
        }
    }
    return false;
}

/* Opens a game pad that was plugged in. If all GAMEPADS_MAX elements of `pad` are in use, the game
 * pad is ignored until it is plugged in again. */
static void plug_in(struct gamepads *gamepads, int32_t device_index)
{
    CORE_ASSERT(gamepads->is_open);
    char guid[GAMEPAD_GUID_SIZE];
    char serial[sizeof gamepads->pad[0].serial] = "";
    if (!SDL_IsGameController(device_index) ||
        pad_of(gamepads, SDL_JoystickGetDeviceInstanceID(device_index))) {
        return;
    }
    const char *node = SDL_JoystickPathForIndex(device_index);
    struct usb_key usb = { .vendor = SDL_JoystickGetDeviceVendor(device_index),
                           .product = SDL_JoystickGetDeviceProduct(device_index) };
    usb_sysfs_node_serial("/sys", node ? node : "", usb.serial);
    if (gamepads_is_excluded(gamepads, &usb)) {
        return;
    }
    SDL_GameController *controller = SDL_GameControllerOpen(device_index);
    if (!controller) {
        return;
    }
    const char *serial_text = SDL_GameControllerGetSerial(controller);
    SDL_Joystick *joystick = SDL_GameControllerGetJoystick(controller);
    SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(joystick), guid, (int)sizeof guid);
    snprintf(serial, sizeof serial, "%.31s", serial_text ? serial_text : "");
    struct gamepad *pad = free_pad(gamepads, guid, serial);
    if (!pad) {
        SDL_GameControllerClose(controller);
        return;
    }
    memcpy(pad->guid, guid, sizeof guid);
    memcpy(pad->serial, serial, sizeof serial);
    pad->usb = usb;
    pad->controller = controller;
    pad->instance = SDL_JoystickInstanceID(joystick);
    begin_pad(pad);
}

/* Closes a pad. Does nothing if `pad` is null or is not open. */
static void pull_out(struct gamepad *pad)
{
    if (pad && pad->controller) {
        SDL_GameControllerClose(pad->controller);
        pad->controller = NULL;
    }
}

/* ---- Events ---------------------------------------------------------------------------------- */

/* Applies an event to the state of its pad, and queues the new state as a report. Events of other
 * types are ignored. SDL's joystick events repeat the controller events. */
static void gamepads_take_event(struct gamepads *gamepads, const SDL_Event *event, uint64_t time_ns)
{
    CORE_ASSERT(time_ns >= gamepads->pumped_ns);
    if (event->type == SDL_CONTROLLERDEVICEADDED) {
        plug_in(gamepads, event->cdevice.which);
        return;
    }
    if (event->type == SDL_CONTROLLERDEVICEREMOVED) {
        pull_out(pad_of(gamepads, event->cdevice.which));
        return;
    }
    /* Every controller event of SDL has the instance id of the pad at the same offset, so `cdevice`
     * can be read for all of them. */
    struct gamepad *pad = pad_of(gamepads, event->cdevice.which);
    bool is_new = false;
    if (!pad) {
        return;
    }
    if (event->type == SDL_CONTROLLERAXISMOTION) {
        is_new = event->caxis.axis < GAMEPAD_AXIS_COUNT;
        if (is_new) {
            pad->now.axis[event->caxis.axis] = event->caxis.value;
        }
    } else if (event->type == SDL_CONTROLLERBUTTONDOWN || event->type == SDL_CONTROLLERBUTTONUP) {
        const uint32_t bit = event->cbutton.button < 32 ? 1u << event->cbutton.button : 0u;
        is_new = bit != 0;
        pad->now.buttons =
            event->cbutton.state == SDL_PRESSED ? pad->now.buttons | bit : pad->now.buttons & ~bit;
    } else if (event->type == SDL_CONTROLLERSENSORUPDATE) {
        const float *data = event->csensor.data;
        const bool is_turn = event->csensor.sensor == SDL_SENSOR_GYRO;
        is_new = is_turn || event->csensor.sensor == SDL_SENSOR_ACCEL;
        pad->now.has_turn |= is_new && is_turn;
        pad->now.has_weight |= is_new && !is_turn;
        if (is_new) {
            *(is_turn ? &pad->now.turn_rad_s : &pad->now.weight_m_s2) =
                v3(data[0], data[1], data[2]);
        }
    }
    if (is_new) {
        pad->now.time_ns = time_ns;
        gamepad_queue_push(&pad->track, &pad->now);
        pad->now.has_turn = pad->now.has_weight = false;
    }
}

/* Processes all pending events. SDL sets the time stamp of an event when SDL moves the event into
 * its queue, not when the event occurs. Therefore the events are spread evenly over the time from
 * the previous call to the current call. */
void gamepads_poll(struct gamepads *gamepads)
{
    SDL_Event events[EVENT_BATCH];
    const uint64_t now = hal_now_ns(gamepads->clock);
    int taken;
    if (!gamepads->is_open) {
        return;
    }
    do {
        const uint64_t span_ns = now - gamepads->pumped_ns;
        taken = SDL_PeepEvents(events, EVENT_BATCH, SDL_GETEVENT, SDL_JOYAXISMOTION,
                               SDL_FINGERDOWN - 1);
        for (int i = 0; i < taken; i++) {
            gamepads_take_event(gamepads, &events[i],
                                gamepads->pumped_ns +
                                    span_ns * (uint64_t)(i + 1) / (uint64_t)taken);
        }
        gamepads->pumped_ns = taken > 0 ? now : gamepads->pumped_ns;
    } while (taken == EVENT_BATCH);
    gamepads->pumped_ns = now;
}

/* ---- Start and stop -------------------------------------------------------------------------- */

void gamepads_init(struct gamepads *gamepads, struct hal_clock clock, const struct view *view)
{
    CORE_ASSERT(view);
    *gamepads = (struct gamepads){ .clock = clock, .view = *view };
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        gamepads->pad[i].gamepads = gamepads;
        gamepad_queue_init(&gamepads->pad[i].track, view, 0);
    }
}

static void hint_at_bars(const struct gamepads *gamepads)
{
    CORE_ASSERT(gamepads->bar_count <= GAMEPADS_EXCLUSION_MAX);
    char list[GAMEPADS_EXCLUSION_MAX * sizeof "0x0000/0x0000,"] = "";
    for (uint32_t i = 0; i < gamepads->bar_count; i++) {
        const size_t length = strlen(list);
        if (gamepads->bar[i].serial[0]) {
            continue;
        }
        snprintf(list + length, sizeof list - length, "0x%04x/0x%04x,", gamepads->bar[i].vendor,
                 gamepads->bar[i].product);
    }
    SDL_SetHint(SDL_HINT_GAMECONTROLLER_IGNORE_DEVICES, list);
}

void gamepads_exclude(struct gamepads *gamepads, const struct usb_key *bar, uint32_t count)
{
    CORE_ASSERT(bar || count == 0);
    const uint32_t kept = count < GAMEPADS_EXCLUSION_MAX ? count : GAMEPADS_EXCLUSION_MAX;
    if (kept == gamepads->bar_count && memcmp(gamepads->bar, bar, kept * sizeof *bar) == 0) {
        return;
    }
    memcpy(gamepads->bar, bar, kept * sizeof *bar);
    gamepads->bar_count = kept;
    hint_at_bars(gamepads);
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        struct gamepad *pad = &gamepads->pad[i];
        if (gamepads_is_excluded(gamepads, &pad->usb)) {
            pull_out(pad);
        }
    }
}

int gamepads_open(struct gamepads *gamepads, const char *database)
{
    CORE_ASSERT(!gamepads->is_open);
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    hint_at_bars(gamepads);
    if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0) {
        snprintf(gamepads->text, sizeof gamepads->text, "no pads: SDL: %.100s", SDL_GetError());
        return HAL_ERR_ABSENT;
    }
    if (database) {
        SDL_GameControllerAddMappingsFromFile(database); /* The result is ignored, because the
                                                            mapping file may be missing. */
    }
    gamepads->is_open = true;
    gamepads->pumped_ns = hal_now_ns(gamepads->clock);
    for (int i = 0; i < SDL_NumJoysticks(); i++) {
        plug_in(gamepads, i);
    }
    return HAL_OK;
}

void gamepads_close(struct gamepads *gamepads)
{
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        pull_out(&gamepads->pad[i]);
    }
    if (gamepads->is_open) {
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
        gamepads->is_open = false;
    }
}
