/* test_hid_play.c -- tests that fish can be caught with every built-in mapping. The raw reports of
 * real devices pass through a simulated port, the decoder and the frame loop. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/control/controller.h"
#include "core/tank/preset.h"
#include "drivers/hid/poi_report.h"
#include "drivers/hid/poi_hid.h"
#include "drivers/null.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/calm_fish.h"
#include "tests/unit/support/hid_wire.h"

#define REPORT_NS 8333333ull /* 120 reports per second, two per frame. */
#define WIDTH 1920.0f
#define HEIGHT 1080.0f

/* Goal of the simulated player's next motion. */
struct target {
    vec3 over_m; /* Point of the water surface above which the ring should be. */
    uint8_t dips;
    /* 1 if the ring should be tipped over the bowl. Only a controller that reports an orientation
     * can tip the ring by rotation. */
    uint8_t is_tipping;
};

static struct hid_player {
    struct clock_sim clock;
    struct hid_wire wire;
    struct poi_hid poi;
    struct hal hal;
    struct kiosk kiosk;
    struct target target;
    /* Function that sends one report of the tested controller. The report moves the ring toward the
     * target. */
    void (*send)(const struct target *target);
    uint32_t report_count;
    vec3 arm_m; /* Position of the simulated player's arm, for a controller that reports poses. */
    float tip_rad;
    struct dip dip; /* Downward or upward motion of the simulated player's arm. */
    uint8_t dipped;
    float x_px, y_px; /* Mouse motion that has not been sent yet, because it is less than a whole
                         count. */
} player;

static vec3 ring_m(void)
{
    return player.kiosk.core.world.poi[0].position_m;
}

static void report(void)
{
    player.clock.now_ns += REPORT_NS;
    player.send(&player.target);
    if (++player.report_count % 2u == 0) {
        kiosk_frame(&player.kiosk, &player.hal);
    }
}

static void reports(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        report();
    }
}

/* ---- Reports of the simulated controllers --------------------------------------------------- */

/* Projects a point of the tank to pixels on the screen, for controllers that move a pointer. */
static void to_screen(vec3 point, float *x_px, float *y_px)
{
    const struct view *view = &tank_preset(TANK_PRESET_FESTIVAL)->view;
    const struct basis axes = view_basis(view);
    const vec3 body = vec_basis_to_body(&axes, v3_sub(point, view->eye_m));
    const float tan_y = view_half_height_tan(view, WIDTH / HEIGHT);
    *x_px = 0.5f * (body.x / -body.z / (tan_y * WIDTH / HEIGHT) + 1.0f) * WIDTH;
    *y_px = 0.5f * (1.0f - body.y / -body.z / tan_y) * HEIGHT;
}

/* Returns the stick deflection in [-1, 1] for a distance to the target. The deflection is full from
 * 8 cm on. */
static float push_of(float way_m)
{
    return f_clamp(way_m / 0.08f, -1.0f, 1.0f);
}

static void put_stick(hid_usage usage, float push)
{
    wire_put(&player.wire, -1, usage, wire_share(&player.wire, -1, usage, 0.5f + 0.5f * push));
}

static void send_pad(const struct target *target, uint32_t dip_button)
{
    const vec3 way = v3_sub(target->over_m, ring_m());
    put_stick(USAGE_X, push_of(way.x));
    put_stick(USAGE_Y, push_of(way.z));
    wire_send(&player.wire, wire_put(&player.wire, -1, USAGE_BUTTON + dip_button, target->dips));
}

static void send_generic_pad(const struct target *target)
{
    send_pad(target, 1);
}

static void send_playstation(const struct target *target)
{
    send_pad(target, 6); /* Button 6 (R1) dips the ring. */
}

/* A 3D mouse controls the height directly. The mouse is pushed down until the ring is deep enough,
 * and later up. */
static void send_3d_mouse(const struct target *target)
{
    const vec3 ring = ring_m();
    const float high_m = target->dips ? DIP_DEPTH_M : target->is_tipping ? 0.07f : DIP_HOVER_M;
    const vec3 way = v3_sub(v3(target->over_m.x, high_m, target->over_m.z), ring);
    put_stick(USAGE_X, push_of(way.x));
    put_stick(USAGE_Y, push_of(way.z));
    put_stick(USAGE_Z, -f_clamp(way.y / 0.03f, -0.9f, 0.9f));
    wire_send(&player.wire, 1);
}

/* Moves the mouse by a fifth of the screen distance from the ring to the target, but by at most
 * `pace` pixels on each axis. */
static void send_mouse(const struct target *target)
{
    float x_px, y_px, at_x_px, at_y_px;
    to_screen(target->over_m, &x_px, &y_px);
    to_screen(ring_m(), &at_x_px, &at_y_px);
    const float pace = target->dips ? 2.4f : 6.0f;
    const float dx = f_clamp(0.2f * (x_px - at_x_px), -pace, pace);
    const float dy = f_clamp(0.2f * (y_px - at_y_px), -pace, pace);
    player.x_px += dx;
    player.y_px += dy;
    const int64_t steps_x = (int64_t)player.x_px, steps_y = (int64_t)player.y_px;
    player.x_px -= (float)steps_x;
    player.y_px -= (float)steps_y;
    wire_put(&player.wire, -1, USAGE_X, steps_x);
    wire_put(&player.wire, -1, USAGE_Y, steps_y);
    wire_send(&player.wire, wire_put(&player.wire, -1, USAGE_BUTTON + 1u, target->dips));
}

/* Holds the pen over the target within its hovering range. The pen touches the tablet to dip the
 * ring. */
static void send_pen(const struct target *target)
{
    const int id = player.wire.descriptor.report_bits[9] && !player.wire.descriptor.report_bits[7]
                       ? 9 /* Report 9 of device 157 has both a pen and a mouse. */
                       : (int)player.poi.decoder.map.binding[0].report_id;
    float x_px, y_px;
    to_screen(target->over_m, &x_px, &y_px);
    const float pace = target->dips ? 2.4f : 7.0f;
    player.x_px += f_clamp(x_px - player.x_px, -pace, pace);
    player.y_px += f_clamp(y_px - player.y_px, -pace, pace);
    wire_put(&player.wire, id, USAGE_X, wire_share(&player.wire, id, USAGE_X, player.x_px / WIDTH));
    wire_put(&player.wire, id, USAGE_Y,
             wire_share(&player.wire, id, USAGE_Y, player.y_px / HEIGHT));
    if (hid_mapping_auto_find(&player.wire.descriptor, 0, id, 1, USAGE_IN_RANGE).group) {
        wire_put(&player.wire, id, USAGE_IN_RANGE, 1);
    }
    const int has_tip =
        hid_mapping_auto_find(&player.wire.descriptor, 0, id, 1, USAGE_TIP).group != NULL;
    wire_put(&player.wire, id, has_tip ? (hid_usage)USAGE_TIP : (hid_usage)USAGE_BUTTON + 1u,
             target->dips);
    wire_send(&player.wire, (uint8_t)id);
}

/* Simulates an arm that holds a Kingyo poi. The arm moves at a limited speed, dips as the mouse
 * pointer does, and rolls the ring over the bowl. */
static void send_own_poi(const struct target *target)
{
    const float pace_m = (target->dips ? 0.10f : 0.35f) * (float)REPORT_NS * 1e-9f;
    const vec3 way = v3_sub(target->over_m, player.arm_m);
    player.arm_m = v3_add(player.arm_m, v3_limit(v3(way.x, 0.0f, way.z), pace_m));
    if (target->dips != player.dipped) {
        player.dipped = target->dips;
        pointer_dip_begin(&player.dip, player.clock.now_ns, target->dips);
    }
    const struct dip_state stroke = pointer_dip_at(&player.dip, player.clock.now_ns);
    const float down_m = DIP_HOVER_M - stroke.height_m;
    player.tip_rad +=
        f_clamp((target->is_tipping ? 60.0f * F_DEG : 0.0f) - player.tip_rad, -0.02f, 0.02f);
    const float lifted_m = 0.09f * f_sin(player.tip_rad);
    const struct poi_report report = {
        .target = { .position_m = v3(player.arm_m.x, stroke.height_m + lifted_m,
                                     player.arm_m.z - 0.65f * down_m + stroke.near_m),
                    .angles = { .pitch_rad = -pointer_dip_slant_rad(stroke.speed_m_s),
                                .roll_rad = player.tip_rad } },
        .sequence = (uint8_t)player.report_count,
    };
    uint8_t bytes[POI_REPORT_SIZE];
    poi_report_encode(&report, bytes);
    hid_port_sim_report(&player.wire.port, bytes, sizeof bytes);
}

/* ---- Rounds with each controller ------------------------------------------------------------ */

static void begin_round(uint32_t seed)
{
    const struct kiosk_config config = { .core = { .seed = seed, .fish_count = 300 } };
    const struct view *view = &tank_preset(TANK_PRESET_FESTIVAL)->view;
    player.hal = null_hal(NULL);
    player.hal.clock = sim_clock_device(&player.clock);
    poi_hid_init(&player.poi, &player.wire.port.port, player.hal.clock, (struct hid_mapper){ 0 },
                 view);
    player.hal.poi[0] = poi_hid_devices(&player.poi).poi;
    pointer_dip_init(&player.dip);
    player.arm_m = v3(0.0f, DIP_HOVER_M, 0.0f);
    player.target = (struct target){ .over_m = player.arm_m };
    to_screen(player.arm_m, &player.x_px, &player.y_px);
    assert_int_equal(kiosk_init(&player.kiosk, &player.hal, &config), CORE_OK);
    assert_true(player.poi.plays);
    reports(20);
    player.kiosk.input.pressed = INPUT_START;
    while (player.kiosk.core.game.phase != PHASE_ROUND) {
        report();
        assert_true(player.kiosk.core.game.tick < 10 * CORE_TICK_HZ);
    }
}

static const struct fish *choose(void)
{
    return calmest_fish(&player.kiosk.core.world.tank, ring_m(), DIP_DEPTH_M);
}

static int goes_to(vec3 over_m, float near_m, uint32_t reports_max)
{
    player.target.over_m = over_m;
    for (uint32_t i = 0; i < reports_max; i++) {
        const vec3 way = v3_sub(over_m, ring_m());
        if (v3_length(v3(way.x, 0.0f, way.z)) < near_m) {
            return 1;
        }
        report();
    }
    return 0;
}

static void empty_over_bowl(void)
{
    const vec3 bowl = player.kiosk.core.world.bowl[0].position_m;
    const int has_wrist = player.poi.decoder.map.style == HID_STYLE_POSE;
    goes_to(v3(bowl.x - (has_wrist ? 0.045f : 0.0f), DIP_HOVER_M, bowl.z), 0.012f, 400);
    player.target.is_tipping = 1;
    reports(200);
    player.target.is_tipping = 0;
    reports(40);
}

/* Makes one attempt to catch a fish. Dips the ring beside the fish, moves the ring below the fish,
 * lifts the fish and tips it into the bowl. */
static void try_once(void)
{
    const struct fish *fish = choose();
    if (!fish) {
        reports(40);
        return;
    }
    const float side = fish->position_m.x > 0.0f ? -0.08f : 0.08f;
    goes_to(v3_add(fish->position_m, v3(side, 0.0f, 0.0f)), 0.015f, 300);
    player.target.dips = 1;
    reports(44);
    for (uint32_t i = 0; i < 90; i++) {
        player.target.over_m = fish->position_m;
        report();
    }
    const vec3 still_m = player.target.over_m;
    player.target.dips = 0;
    const int flies = player.poi.decoder.map.style == HID_STYLE_FLY;
    for (uint32_t i = 0; i < 70 || (i < 150 && ring_m().y < 0.02f); i++) {
        /* With a controller of the style HID_STYLE_FLY the player releases the stick, so the target
         * is the ring's own position. With any other controller the target stays where it was. */
        player.target.over_m = flies ? ring_m() : still_m;
        report();
    }
    if (player.kiosk.core.world.poi[0].carried_count > 0) {
        empty_over_bowl();
    }
}

/* Plays `rounds` rounds. Prints and returns the number of caught fish. Each test requires half of
 * the number that is usual for its controller. */
static uint32_t landed_in(uint32_t rounds, const char *what)
{
    uint32_t landed = 0;
    for (uint32_t seed = 1; seed <= rounds; seed++) {
        begin_round(seed);
        for (uint32_t i = 0; i < 12 && player.kiosk.core.game.phase == PHASE_ROUND; i++) {
            try_once();
            assert_false(controller_is_lost(&player.kiosk.core.world, 0));
        }
        landed += player.kiosk.core.game.player[0].caught;
        player.clock.now_ns = 0;
        hid_port_sim_init(&player.wire.port, sim_clock_device(&player.clock), &player.wire.face);
    }
    print_message("%s: %u fish in %u rounds\n", what, landed, rounds);
    return landed;
}

static void capture_fish(const char *name, uint16_t vendor, uint16_t product,
                         void (*send)(const struct target *))
{
    memset(&player, 0, sizeof player);
    wire_load(&player.wire, &player.clock, name);
    player.wire.face.identity.vendor = vendor;
    player.wire.face.identity.product = product;
    hid_port_sim_plug(&player.wire.port, &player.wire.face);
    player.send = send;
    if (hid_mapping_auto_find(&player.wire.descriptor, 0, -1, 0, USAGE_HAT).group) {
        /* A value outside the hat's range means that the hat is released. */
        wire_put(&player.wire, -1, USAGE_HAT, 15);
    }
}

static void test_fish_can_be_caught_with_a_kingyo_poi(void **state)
{
    (void)state;
    memset(&player, 0, sizeof player);
    wire_begin(&player.wire, &player.clock, poi_descriptor, POI_DESCRIPTOR_SIZE);
    player.send = send_own_poi;
    assert_true(landed_in(2, "our own poi") >= 2);
}

static void test_fish_can_be_caught_with_a_mouse(void **state)
{
    (void)state;
    capture_fish("011-dell-413c-301a-mouse", 0x413c, 0x301a, send_mouse);
    assert_true(landed_in(2, "mouse of 16 bits") >= 5);
    capture_fish("187-hr-0003-045e-0040-0004", 0x045e, 0x0040, send_mouse);
    assert_true(landed_in(2, "mouse of 8 bits") >= 5);
}

static void test_fish_can_be_caught_with_a_pen_tablet(void **state)
{
    (void)state;
    capture_fish("137-dg-huion-h610-if0", 0x256c, 0x006e, send_pen);
    assert_true(landed_in(2, "pen tablet") >= 5);
    capture_fish("194-hr-0003-256c-006e-0008", 0x256c, 0x006e, send_pen);
    assert_true(landed_in(2, "pen of 24 bits with tilt") >= 5);
    capture_fish("157-dg-xp-pen-deco-01-if0", 0x28bd, 0x0042, send_pen);
    assert_true(landed_in(2, "pen in a mouse's report") >= 5);
}

static void test_fish_can_be_caught_with_a_playstation_gamepad(void **state)
{
    (void)state;
    capture_fish(KNOWN "054c-05c4-dualshock4", 0x054c, 0x05c4, send_playstation);
    assert_true(landed_in(2, "DualShock 4") >= 2);
    assert_int_equal(player.poi.decoder.map.source, HID_MAPPING_KNOWN);
    capture_fish("016-ci-dualsense", 0x054c, 0x0ce6, send_playstation);
    assert_true(landed_in(2, "DualSense") >= 2);
    assert_int_equal(player.poi.decoder.map.source, HID_MAPPING_KNOWN);
}

static void test_fish_can_be_caught_with_gamepads_and_joysticks_of_any_vendor(void **state)
{
    (void)state;
    capture_fish("010-8bitdo-sn30pro-bt-dinput", 0x2dc8, 0x6001, send_generic_pad);
    assert_true(landed_in(2, "pad of 8 bits") >= 2);
    capture_fish("033-ci-xboxone-model-1708-bluetooth", 0x045e, 0x02fd, send_generic_pad);
    assert_true(landed_in(2, "pad of 16 bits") >= 5);
    capture_fish("203-hr-libinput-issue201-0003-06a3-0c2d-0", 0x06a3, 0x0c2d, send_generic_pad);
    assert_true(landed_in(2, "joystick") >= 2);
}

static void test_fish_can_be_caught_with_a_3dconnexion_mouse(void **state)
{
    (void)state;
    capture_fish("002-3dconnexion-spacemouse-wireless", 0x256f, 0xc62e, send_3d_mouse);
    assert_true(landed_in(2, "puck") >= 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_can_be_caught_with_a_kingyo_poi),
        cmocka_unit_test(test_fish_can_be_caught_with_a_mouse),
        cmocka_unit_test(test_fish_can_be_caught_with_a_pen_tablet),
        cmocka_unit_test(test_fish_can_be_caught_with_a_playstation_gamepad),
        cmocka_unit_test(test_fish_can_be_caught_with_gamepads_and_joysticks_of_any_vendor),
        cmocka_unit_test(test_fish_can_be_caught_with_a_3dconnexion_mouse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
