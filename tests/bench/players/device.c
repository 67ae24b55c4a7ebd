/* device.c -- implementation of device.h: moves the hand of a simulated player and makes the
 * reports of the player's input device. */
#include "tests/bench/players/device.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/view.h"
#include "drivers/hid/poi_report.h"

#define FRAME_NS (1000000000ull / PLAYER_HZ)
#define FRAME_S (1.0f / (float)PLAYER_HZ)
/* Time constant in seconds with which the hand slows down before its goal. When the hand speeds up,
 * the time constant is half as long. */
#define EASE_S 0.10f
#define HEIGHT_EASE_S 0.08f
/* Gain of the thumb on the stick: the speed of the ring in pixels per second, divided by its
 * distance from the goal in pixels. */
#define STICK_PER_S 3.0f
#define PX_PER_M 1800.0f /* Mean size of one metre of the tank on the screen, in pixels. */
#define STICK_FULL 32767.0f
/* Roll angle to which a player tips a physical poi over the bowl, to empty it. */
#define TIP_RAD (60.0f * F_DEG)
#define TIP_RAD_S (150.0f * F_DEG)
/* Height by which a player raises a physical poi while it is tipped. */
#define TIP_RISE_M 0.075f
/* Number of random points per second in the tremor of the hand. Between two points the hand moves
 * along a straight line. */
#define TREMOR_HZ 8u
#define POI_HOVER_M 0.045f /* Height of a physical poi above the water. */

/* Moves the hand toward the position in `command`. The speed and the acceleration of the hand are
 * limited. */
static void move_hand(struct device *device, const struct player_command *command)
{
    const float dx = command->x_px - device->x_px, dy = command->y_px - device->y_px;
    const float gap_px = f_sqrt(dx * dx + dy * dy);
    const float pace_px_s = f_min(command->speed_px_s, gap_px / EASE_S);
    const float share = FRAME_S / (FRAME_S + 0.5f * EASE_S);
    const float unit = gap_px > 1e-3f ? pace_px_s / gap_px : 0.0f;
    device->pace_x_px_s += (unit * dx - device->pace_x_px_s) * share;
    device->pace_y_px_s += (unit * dy - device->pace_y_px_s) * share;
    device->x_px = f_clamp(device->x_px + device->pace_x_px_s * FRAME_S, 0.0f, PLAYER_WIDTH_PX);
    device->y_px = f_clamp(device->y_px + device->pace_y_px_s * FRAME_S, 0.0f, PLAYER_HEIGHT_PX);
}

/* ---- Pointers -------------------------------------------------------------------------------- */

/* Sends a report of the mouse. The position is rounded to whole pixels, and the wheel turns by at
 * most one notch per frame. */
static void send_mouse(struct device *device, const struct player_command *command)
{
    const float turn = f_clamp(command->tilt_notches - device->notches, -1.0f, 1.0f);
    device->notches += turn;
    device->pointer_reports[0] = (struct pointer_report){
        .time_ns = device->clock->now_ns,
        .x_px = f_floor(device->x_px + 0.5f),
        .y_px = f_floor(device->y_px + 0.5f),
        .width_px = (uint32_t)PLAYER_WIDTH_PX,
        .height_px = (uint32_t)PLAYER_HEIGHT_PX,
        .buttons = command->dips ? (uint32_t)POINTER_DIP : 0u,
        .wheel_notches = turn,
    };
    device->pointer.feed.count = 1;
}

static void add_touch(struct device *device, uint8_t kind, int64_t finger)
{
    CORE_ASSERT(device->pointer.feed.count < DEVICE_REPORTS_MAX);
    device->touch_events[device->pointer.feed.count++] = (struct touch_event){
        .time_ns = device->clock->now_ns,
        .kind = kind,
        .id = finger,
        .x = device->x_px / PLAYER_WIDTH_PX,
        .y = device->y_px / PLAYER_HEIGHT_PX,
    };
}

static void send_touch(struct device *device, const struct player_command *command)
{
    device->pointer.feed.count = 0;
    add_touch(device, device->finger_down ? TOUCH_MOVE : TOUCH_DOWN, 1);
    device->finger_down = true;
    if (command->dips != device->dips) {
        add_touch(device, command->dips ? TOUCH_DOWN : TOUCH_UP, 2);
        device->dips = command->dips;
    }
}

/* ---- Game pad -------------------------------------------------------------------------------- */

/* Returns the deflection of the stick (0 to 1) that moves the ring at the fraction `share` of its
 * full speed. This function is the inverse of the decoder's dead zone and cubic response
 * (stick_motion.c), because an experienced player compensates for both. */
static float deflection_of(float share)
{
    float push = share;
    for (uint32_t i = 0; i < 4; i++) {
        const float slope = 0.35f + 1.95f * push * push;
        push -= (push * (0.35f + 0.65f * push * push) - share) / slope;
    }
    const float dead = (float)GAMEPAD_DEAD / STICK_FULL;
    return share > 1e-3f ? f_clamp(dead + (1.0f - dead) * push, 0.0f, 1.0f) : 0.0f;
}

/* Deflects the stick toward the goal. The deflection grows with the distance between ring and goal
 * on the screen. */
static void send_gamepad(struct device *device, const struct player_command *command)
{
    struct gamepad_report *report = &device->gamepad_reports[0];
    const float full_m_s = command->dips ? STICK_MOTION_WATER_M_S : STICK_MOTION_AIR_M_S;
    const float dx = command->x_px - command->ring_x_px, dy = command->y_px - command->ring_y_px;
    const float gap_px = f_sqrt(dx * dx + dy * dy);
    const float pace_px_s = f_min(command->speed_px_s, STICK_PER_S * gap_px);
    const float push = deflection_of(f_min(pace_px_s / (PX_PER_M * full_m_s), 1.0f));
    *report = (struct gamepad_report){
        .time_ns = device->clock->now_ns,
        .buttons = command->dips ? (uint32_t)GAMEPAD_SOUTH : 0u,
    };
    if (gap_px > 1.0f) {
        report->axis[GAMEPAD_LEAD_X] = (int16_t)(STICK_FULL * push * dx / gap_px);
        report->axis[GAMEPAD_LEAD_Y] = (int16_t)(STICK_FULL * push * dy / gap_px);
    }
    device->gamepad.feed.count = 1;
}

/* ---- Physical poi ---------------------------------------------------------------------------- */

static float tremor_m(const struct device *device, uint32_t axis)
{
    /* Number of reports between two random points of the tremor. A physical poi sends two reports
     * per frame. */
    const uint32_t span = 2u * PLAYER_HZ / TREMOR_HZ;
    const struct rng_key from = { device->seed, device->report_count / span, axis, RNG_BOT_TREMOR };
    const struct rng_key to = { from.seed, from.tick + 1u, axis, RNG_BOT_TREMOR };
    const float share = (float)(device->report_count % span) / (float)span;
    return device->habits->tremor_m *
           f_lerp(rng_range(from, -1.0f, 1.0f), rng_range(to, -1.0f, 1.0f), share);
}

static float approach(float from, float to, float step)
{
    return from + f_clamp(to - from, -step, step);
}

/* Sends the pose of a physical poi. As with a mouse, the ring stays on the line of sight through
 * the hand's position on the screen. The player also controls the height and the angles of the
 * ring. */
static void send_poi(struct device *device, const struct player_command *command)
{
    const struct habits *habits = device->habits;
    const float dt_s = 0.5f * FRAME_S;
    const float depth_m = habits->depth_m != 0.0f ? habits->depth_m : DIP_DEPTH_M;
    const float goal_m = command->dips ? depth_m : POI_HOVER_M;
    const float most_m_s = command->dips ? habits->dip_m_s : habits->lift_m_s;
    const float pace_m_s =
        f_clamp((goal_m - device->height_m) / HEIGHT_EASE_S, -most_m_s, most_m_s);
    const bool goes_down = command->dips && device->height_m > 0.6f * depth_m;
    device->climb_m_s += (pace_m_s - device->climb_m_s) * (dt_s / (dt_s + 0.5f * HEIGHT_EASE_S));
    device->height_m += device->climb_m_s * dt_s;
    device->pitch_rad =
        approach(device->pitch_rad, goes_down ? -habits->entry_rad : 0.0f, TIP_RAD_S * dt_s);
    device->roll_rad = approach(device->roll_rad, command->tips ? TIP_RAD : 0.0f, TIP_RAD_S * dt_s);
    const float height_m = device->height_m + TIP_RISE_M * f_sin(device->roll_rad);
    const vec3 place_m =
        view_point_on_plane(&device->view, PLAYER_WIDTH_PX / PLAYER_HEIGHT_PX,
                            2.0f * device->x_px / PLAYER_WIDTH_PX - 1.0f,
                            1.0f - 2.0f * device->y_px / PLAYER_HEIGHT_PX, height_m);
    const struct poi_report report = {
        .target = { .position_m = v3_add(
                        place_m, v3(tremor_m(device, 0), tremor_m(device, 1), tremor_m(device, 2))),
                    .angles = { .pitch_rad = device->pitch_rad, .roll_rad = device->roll_rad } },
        .sequence = (uint8_t)device->report_count,
    };
    uint8_t bytes[POI_REPORT_SIZE];
    poi_report_encode(&report, bytes);
    hid_port_sim_report(&device->port, bytes, sizeof bytes);
    device->report_count++;
}

/* ---- Public functions ------------------------------------------------------------------------ */

void device_init(struct device *device, const struct habits *habits, struct clock_sim *clock,
                 const struct view *view, uint32_t seed)
{
    const struct hal_clock time = sim_clock_device(clock);
    struct hid_device_info face = { .descriptor_size = POI_DESCRIPTOR_SIZE };
    memcpy(face.descriptor, poi_descriptor, POI_DESCRIPTOR_SIZE);
    *device = (struct device){ .habits = habits,
                               .clock = clock,
                               .view = *view,
                               .seed = seed,
                               .x_px = 0.5f * PLAYER_WIDTH_PX,
                               .y_px = 0.5f * PLAYER_HEIGHT_PX,
                               .height_m = POI_HOVER_M };
    if (habits->device == PLAYER_FINGER) {
        pointer_sim_init_touch(&device->pointer, time, view, (uint32_t)PLAYER_WIDTH_PX,
                               (uint32_t)PLAYER_HEIGHT_PX);
    } else {
        pointer_sim_init(&device->pointer, time, view);
    }
    device->pointer.reports = device->pointer_reports;
    device->pointer.events = device->touch_events;
    gamepad_sim_init(&device->gamepad, time, view);
    device->gamepad.reports = device->gamepad_reports;
    hid_port_sim_init(&device->port, time, &face);
    poi_hid_init(&device->poi, &device->port.port, time, (struct hid_mapper){ 0 }, view);
}

struct hal_poi device_poi(struct device *device)
{
    switch (device->habits->device) {
    case PLAYER_MOUSE:
    case PLAYER_FINGER:
        return pointer_sim_devices(&device->pointer).poi;
    case PLAYER_GAMEPAD:
        return gamepad_sim_devices(&device->gamepad).poi;
    default:
        return poi_hid_devices(&device->poi).poi;
    }
}

void device_frame(struct device *device, const struct player_command *command)
{
    const uint64_t end_ns = device->clock->now_ns + FRAME_NS;
    move_hand(device, command);
    if (device->habits->device == PLAYER_POI) {
        send_poi(device, command);
        device->clock->now_ns += FRAME_NS / 2u;
        send_poi(device, command);
        device->clock->now_ns = end_ns;
        return;
    }
    device->clock->now_ns = end_ns;
    device->pointer.feed.next = device->gamepad.feed.next = 0;
    if (device->habits->device == PLAYER_MOUSE) {
        send_mouse(device, command);
    } else if (device->habits->device == PLAYER_FINGER) {
        send_touch(device, command);
    } else if (device->habits->device == PLAYER_GAMEPAD) {
        send_gamepad(device, command);
    }
}
