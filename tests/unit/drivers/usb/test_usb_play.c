/* test_usb_play.c -- tests that no credit is lost when a poi is unplugged a thousand times during
 * paid rounds. The USB thread, the decoder, the frame loop and the core are real. Only the bus is
 * simulated. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdatomic.h>

#include "core/tank/preset.h"
#include "drivers/hid/poi_hid.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/storage_sim.h"
#include "drivers/usb/usb_transport.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/balance.h"
#include "tests/unit/support/usb/usb_fixture.h"

#define UNPLUG_COUNT 1000u
#define FRAME_NS 16666667ull
#define COINS 9u
#define FRAMES_MAX 20000u

static struct {
    struct usb_fixture fixture;
    atomic_ullong now_ns; /* Simulated time in ns, which both threads read. A frame adds
                             1/60 s. */
    struct button_event event[2];
    struct buttons_sim buttons;
    struct poi_hid poi;
    struct storage_sim storage;
    struct hal hal;
    struct kiosk kiosk;
    uint32_t device;
    uint8_t is_plugged;
    uint32_t sent; /* Number of reports since the device was plugged in. */
    uint8_t sequence;
} rig;

static uint64_t stall_now_ns(void *self)
{
    (void)self;
    return atomic_load(&rig.now_ns);
}

static struct hal_clock rig_clock(void)
{
    static const struct hal_clock_ops ops = { .now_ns = stall_now_ns };
    return (struct hal_clock){ .ops = &ops };
}

/* ---- Simulated poi -------------------------------------------------------------------------- */

static void plug(void)
{
    rig.device = usb_sim_plug(&own_poi, 1);
    rig.is_plugged = 1;
    rig.sent = 0;
}

static void unplug(uint32_t how)
{
    usb_sim_unplug(rig.device, (enum usb_sim_unplug_order)(how % 2u));
    rig.is_plugged = 0;
}

/* Sends the pose of a controller that hovers above the water and trembles a little. */
static void send_pose(void)
{
    uint8_t bytes[POI_REPORT_SIZE];
    const float sway_m = 0.001f * (float)(rig.sequence % 16u);
    const struct poi_report report = { .target.position_m = { sway_m, 0.15f, -sway_m },
                                       .sequence = rig.sequence++ };
    poi_report_encode(&report, bytes);
    usb_sim_report(rig.device, bytes, sizeof bytes);
    rig.sent++;
}

/* ---- Simulated kiosk ------------------------------------------------------------------------ */

static void frame(void)
{
    if (rig.is_plugged) {
        send_pose();
        send_pose();
        for (uint32_t i = 0; i < 200 && usb_sim_waiting(rig.device) > 0; i++) {
            usleep(50);
        }
    }
    atomic_fetch_add(&rig.now_ns, FRAME_NS);
    kiosk_frame(&rig.kiosk, &rig.hal);
}

static int frames_until(bool (*is_so)(void))
{
    for (uint32_t i = 0; i < FRAMES_MAX; i++) {
        if (is_so()) {
            return 1;
        }
        frame();
        if (!rig.is_plugged || i > 100u) {
            usleep(50); /* Gives the USB thread time to run. */
        }
    }
    return 0;
}

static bool is_round(void)
{
    return rig.kiosk.core.game.phase == PHASE_ROUND;
}

static bool is_paused(void)
{
    return rig.kiosk.scene.paused || !is_round();
}

static bool runs(void)
{
    return is_round() && !rig.kiosk.scene.paused && rig.kiosk.samplers[0].link == POI_SOURCE_LIVE;
}

static bool is_attract(void)
{
    return rig.kiosk.core.game.phase == PHASE_ATTRACT &&
           rig.kiosk.samplers[0].link == POI_SOURCE_LIVE;
}

static void press_start(void)
{
    rig.event[1] =
        (struct button_event){ .time_ns = atomic_load(&rig.now_ns), .pressed = INPUT_START };
    rig.buttons =
        (struct buttons_sim){ .clock = rig_clock(), .events = &rig.event[1], .event_count = 1 };
}

static int set_up(void **state)
{
    (void)state;
    static const struct kiosk_config config = {
        .core = { .seed = 11, .fish_count = 4, .round_s = 600, .credit_coins = 1 }
    };
    memset(&rig, 0, sizeof rig);
    atomic_store(&rig.now_ns, 1000000000000ull);
    fixture_prepare(&rig.fixture);
    fixture_start_with(&rig.fixture, rig_clock(), NULL, 0);
    rig.hal = null_hal(NULL);
    rig.hal.clock = rig_clock();
    rig.event[0] = (struct button_event){ .coin_count[0] = COINS };
    rig.buttons =
        (struct buttons_sim){ .clock = rig_clock(), .events = rig.event, .event_count = 1 };
    rig.hal.buttons = sim_buttons_device(&rig.buttons);
    const struct view view = tank_preset(TANK_PRESET_FESTIVAL)->view;
    poi_hid_init(&rig.poi, usb_transport_port(rig.fixture.thread, 0), rig_clock(),
                 (struct hid_mapper){ NULL, NULL }, &view);
    rig.hal.poi[0] = poi_hid_devices(&rig.poi).poi;
    rig.hal.storage = storage_sim_device(&rig.storage);
    return kiosk_init(&rig.kiosk, &rig.hal, &config);
}

static int tear_down(void **state)
{
    (void)state;
    assert_int_equal(fixture_end(&rig.fixture), 0);
    assert_int_equal(usb_sim_breaches(), 0);
    return 0;
}

static uint32_t credits(void)
{
    return balance_credits(&rig.kiosk.core);
}

static uint32_t refunds(void)
{
    return balance_audit(&rig.kiosk.core, AUDIT_REFUNDS);
}

static void begin_round(void)
{
    assert_true(frames_until(is_attract));
    assert_true(credits() > 0);
    press_start();
    assert_true(frames_until(runs));
}

static void test_a_thousand_unplugs_lose_no_credit(void **state)
{
    (void)state;
    uint32_t resumed = 0, paid_back = 0, over = 0;
    plug();
    frame();
    begin_round();
    assert_int_equal(credits(), COINS - 1u);
    for (uint32_t i = 0; i < UNPLUG_COUNT; i++) {
        const uint32_t had = credits(), paid_before = refunds();
        for (uint32_t k = 0; k < i % 23u; k++) {
            send_pose();
        }
        unplug(i);
        assert_true(frames_until(is_paused));
        plug();
        for (uint32_t k = 0; k < FRAMES_MAX && !runs() && is_round(); k++) {
            frame();
            usleep(20);
        }
        /* The sum of all pauses of this round has exceeded the limit, so the credit of the round
         * was refunded. */
        if (refunds() > paid_before) {
            assert_int_equal(credits(), had + 1u);
            paid_back++;
            begin_round();
            continue;
        }
        /* A round that was paid with a refunded credit ends without another refund, because a
         * credit is refunded only once. */
        if (!is_round()) {
            assert_int_equal(credits(), had);
            over++;
            begin_round();
            continue;
        }
        assert_true(runs());
        assert_int_equal(credits(), had);
        resumed++;
    }
    assert_int_equal(resumed + paid_back + over, UNPLUG_COUNT);
    assert_in_range(over, 0, paid_back);
    assert_true(resumed > UNPLUG_COUNT * 9u / 10u);
    /* One more credit is not in credits(), because it pays for the running round. The counted
     * rounds have used up the credits of `over`. */
    assert_int_equal(credits() + 1u + over, COINS);
    printf("# %u unplugs in a round: %u resumed, %u paid back, %u rounds counted, 0 credits lost\n",
           UNPLUG_COUNT, resumed, paid_back, over);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_thousand_unplugs_lose_no_credit, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
