/* test_input_mux.c -- tests which controller gets which player slot while controllers are plugged
 * in and out. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "drivers/input_mux.h"
#include "drivers/null.h"

/* ---- Assignment of devices to players ------------------------------------------------------- */

enum { USB0, USB1, USB2, USB3, PAD0, PAD1, PAD2, PAD3, MOUSE, COUNT };
#define NOBODY SLOT_NONE
#define BIT(who) (1u << (who))

static const uint8_t kinds[COUNT] = { INPUT_KIND_USB,     INPUT_KIND_USB,     INPUT_KIND_USB,
                                      INPUT_KIND_USB,     INPUT_KIND_GAMEPAD, INPUT_KIND_GAMEPAD,
                                      INPUT_KIND_GAMEPAD, INPUT_KIND_GAMEPAD, INPUT_KIND_POINTER };

static void assert_share(uint8_t slot[POI_MAX], uint32_t there, const uint8_t expected[POI_MAX])
{
    input_mux_assign(slot, kinds, COUNT, there);
    assert_memory_equal(slot, expected, POI_MAX);
}

static void test_the_best_controller_gets_the_first_slot(void **state)
{
    (void)state;
    uint8_t slot[POI_MAX] = { NOBODY, NOBODY, NOBODY, NOBODY };
    assert_share(slot, 0, (uint8_t[]){ NOBODY, NOBODY, NOBODY, NOBODY });
    assert_share(slot, BIT(MOUSE), (uint8_t[]){ MOUSE, NOBODY, NOBODY, NOBODY });
    assert_share(slot, BIT(MOUSE) | BIT(PAD2), (uint8_t[]){ PAD2, MOUSE, NOBODY, NOBODY });
    assert_share(slot, BIT(MOUSE) | BIT(PAD2) | BIT(USB1),
                 (uint8_t[]){ USB1, PAD2, MOUSE, NOBODY });
    assert_share(slot, BIT(MOUSE), (uint8_t[]){ MOUSE, NOBODY, NOBODY, NOBODY });
}

static void test_an_assigned_controller_keeps_its_slot_among_its_kind(void **state)
{
    (void)state;
    uint8_t slot[POI_MAX] = { NOBODY, NOBODY, NOBODY, NOBODY };
    assert_share(slot, BIT(USB2), (uint8_t[]){ USB2, NOBODY, NOBODY, NOBODY });
    assert_share(slot, BIT(USB2) | BIT(USB0), (uint8_t[]){ USB2, USB0, NOBODY, NOBODY });
    assert_share(slot, BIT(USB2) | BIT(USB0) | BIT(USB3), (uint8_t[]){ USB2, USB0, USB3, NOBODY });
    assert_share(slot, BIT(USB0) | BIT(USB3), (uint8_t[]){ USB3, USB0, NOBODY, NOBODY });
}

static void test_a_fifth_controller_gets_no_slot(void **state)
{
    (void)state;
    uint8_t slot[POI_MAX] = { NOBODY, NOBODY, NOBODY, NOBODY };
    assert_share(slot, BIT(PAD0) | BIT(PAD1) | BIT(PAD2) | BIT(PAD3) | BIT(MOUSE),
                 (uint8_t[]){ PAD0, PAD1, PAD2, PAD3 });
    assert_share(slot, BIT(USB0) | BIT(PAD0) | BIT(PAD1) | BIT(PAD2) | BIT(PAD3) | BIT(MOUSE),
                 (uint8_t[]){ USB0, PAD1, PAD2, PAD0 });
}

/* Plugs controllers in and out at random. After each assignment, no slot has two controllers, no
 * slot is empty while a controller is left, and better kinds of controllers have the lower slots. A
 * second assignment must change nothing. */
static void test_every_set_of_controllers_is_assigned_correctly(void **state)
{
    (void)state;
    uint8_t slot[POI_MAX] = { NOBODY, NOBODY, NOBODY, NOBODY };
    for (uint32_t turn = 0; turn < 20000; turn++) {
        const uint32_t there =
            rng_u32((struct rng_key){ 6, turn, 0, RNG_TEST }) & (BIT(COUNT) - 1u);
        const uint32_t guests = (uint32_t)__builtin_popcount(there);
        uint32_t seen = 0;
        input_mux_assign(slot, kinds, COUNT, there);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            assert_int_equal(slot[i] != NOBODY, i < guests);
            if (slot[i] != NOBODY) {
                assert_true(there & BIT(slot[i]));
                assert_false(seen & BIT(slot[i]));
                assert_true(i == 0 || kinds[slot[i - 1]] <= kinds[slot[i]]);
                seen |= BIT(slot[i]);
            }
        }
        const uint8_t before[POI_MAX] = { slot[0], slot[1], slot[2], slot[3] };
        assert_share(slot, there, before);
    }
}

/* ---- The player slots ----------------------------------------------------------------------- */

struct source {
    int there;
    /* 1 if open() succeeds although source_is_present() returns false, as for a device that is
     * connected but unused. */
    int lies_about;
    uint32_t opened, polled, asked;
    struct poi_force felt;
};

static int source_open(void *self)
{
    struct source *source = self;
    source->opened++;
    return source->there || source->lies_about ? HAL_OK : HAL_ERR_GONE;
}

static int source_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct source *source = self;
    assert_true(max > 0);
    source->polled++;
    out[0] = (struct poi_sample){ .time_ns = 7 };
    return source->there || source->lies_about ? 1 : (int)HAL_ERR_GONE;
}

static int source_feel(void *self, const struct poi_force *force)
{
    struct source *source = self;
    source->felt = *force;
    return HAL_OK;
}

static const char *source_describe(void *self)
{
    (void)self;
    return "a source";
}

static bool source_is_present(void *self)
{
    struct source *source = self;
    source->asked++;
    return source->there;
}

static struct input_mux mux;
static struct hal hal;
static struct source usb, pad, mouse;

static void add(struct source *source, enum input_kind kind)
{
    static const struct hal_poi_ops ops = {
        .open = source_open,
        .poll = source_poll,
        .set_force = source_feel,
        .describe = source_describe,
    };
    const struct input_source one = {
        .poi = { .ops = &ops, .self = source },
        .is_present = source_is_present,
        .self = source,
        .kind = (uint8_t)kind,
    };
    assert_int_equal(input_mux_add(&mux, &one), 0);
}

static int begin(void **state)
{
    (void)state;
    usb = pad = (struct source){ 0 };
    mouse = (struct source){ .there = 1 };
    hal = null_hal(NULL);
    hal.slots = input_mux_init(&mux, &hal, "plug one in");
    add(&usb, INPUT_KIND_USB);
    add(&pad, INPUT_KIND_GAMEPAD);
    add(&mouse, INPUT_KIND_POINTER);
    return 0;
}

static uint32_t arrange(int may_move)
{
    return hal.slots.ops->arrange(hal.slots.self, may_move);
}

static void test_a_slot_forwards_calls_to_its_assigned_source(void **state)
{
    (void)state;
    const struct hal_poi *const poi = &hal.poi[0];
    struct poi_sample sample;
    assert_int_equal(poi->ops->open(poi->self), HAL_ERR_ABSENT);
    assert_int_equal(poi->ops->poll(poi->self, &sample, 1), HAL_ERR_ABSENT);
    assert_string_equal(poi->ops->describe(poi->self), "plug one in");
    assert_int_equal(arrange(1), 1u);
    assert_int_equal(poi->ops->open(poi->self), HAL_OK);
    assert_int_equal(poi->ops->poll(poi->self, &sample, 1), 1);
    assert_int_equal(mouse.polled, 1);
    assert_string_equal(poi->ops->describe(poi->self), "a source");
    const struct hal_poi *const second = &hal.poi[1];
    assert_string_equal(second->ops->describe(second->self), "");
}

static void test_a_better_controller_gets_the_slot_only_between_games(void **state)
{
    (void)state;
    arrange(1);
    pad.there = 1;
    assert_int_equal(arrange(0), 0u);
    assert_int_equal(arrange(0), 0u);
    /* The pad has no slot yet. The multiplexer also opens such a source, to find out whether it is
     * ready. */
    assert_true(pad.asked >= 2);
    assert_int_equal(arrange(1), 3u);
    assert_int_equal(arrange(1), 0u);
    usb.there = 1;
    assert_int_equal(arrange(1), 7u);
}

/* If a player's controller is unplugged during a round, the slot stays reserved for it. The mouse
 * of another player must not get the slot. */
static void test_a_lost_controller_keeps_its_slot_during_the_game(void **state)
{
    (void)state;
    const struct hal_poi *const poi = &hal.poi[0];
    struct poi_sample sample;
    usb.there = 1;
    arrange(1);
    usb.there = 0;
    assert_int_equal(arrange(0), 0u);
    assert_int_equal(poi->ops->poll(poi->self, &sample, 1), HAL_ERR_GONE);
    assert_int_equal(poi->ops->open(poi->self), HAL_ERR_GONE);
    usb.there = 1;
    /* The source was plugged in again, so it gets its slot back at once, even during a round. */
    assert_int_equal(arrange(0), 1u);
    assert_int_equal(arrange(0), 0u);
    assert_int_equal(poi->ops->open(poi->self), HAL_OK);
    usb.there = 0;
    assert_int_equal(arrange(1), 3u);
    assert_int_equal(poi->ops->poll(poi->self, &sample, 1), 1);
    assert_true(mouse.polled > 0);
}

/* A mouse on a cabinet must not count as a second player. The mouse gets a slot only if it is used
 * or if no other controller exists. */
static void test_a_substitute_gets_a_slot_if_no_other_exists_or_once_used(void **state)
{
    (void)state;
    mux.source[2].stands_in = 1;
    mouse.there = 0;
    mouse.lies_about = 1;
    assert_int_equal(arrange(1), 1u);
    pad.there = 1;
    assert_int_equal(arrange(1), 1u);
    const struct hal_poi *const second = &hal.poi[1];
    assert_int_equal(second->ops->open(second->self), HAL_ERR_ABSENT);
    arrange(1);
    /* The mouse is polled without a slot. Otherwise its motion would not be noticed. */
    assert_int_equal(mouse.polled, 1);
    mouse.there = 1;
    assert_int_equal(arrange(1), 2u);
    mouse.there = 0;
    assert_int_equal(arrange(0), 0u);
    assert_int_equal(arrange(1), 2u);
}

/* During a round, a lost controller is replaced only by an unused controller of the same kind, or
 * by the same controller in another port. The mouse or a controller of another player must never
 * replace it. */
static void test_a_lost_controller_is_replaced_in_a_game_by_one_of_its_kind(void **state)
{
    (void)state;
    static struct source second, third;
    second = third = (struct source){ 0 };
    add(&second, INPUT_KIND_USB);
    add(&third, INPUT_KIND_USB);
    usb.there = second.there = 1;
    arrange(1);
    usb.there = 0;
    /* Nothing replaces the lost controller, because the second controller already has a slot and
     * the mouse is of another kind. */
    assert_int_equal(arrange(0), 0u);
    third.there = 1;
    assert_int_equal(arrange(0), 1u);
    const struct hal_poi *const poi = &hal.poi[0];
    struct poi_sample sample;
    poi->ops->poll(poi->self, &sample, 1);
    assert_int_equal(third.polled, 1);
    usb.there = 1;
    assert_int_equal(arrange(0), 0u);
}

/* An unused mouse must still be polled. Otherwise its events would fill SDL's queue. */
static void test_a_source_without_a_slot_is_still_polled(void **state)
{
    (void)state;
    while (mux.source_count < POI_MAX + 1u) {
        add(&pad, INPUT_KIND_GAMEPAD);
    }
    usb.there = pad.there = 1;
    arrange(1);
    assert_int_equal(mouse.polled, 0);
    for (uint32_t i = 0; i < 3; i++) {
        arrange(i % 2 == 0);
    }
    assert_int_equal(mouse.opened, 1);
    assert_int_equal(mouse.polled, 3);
    /* A controller with a slot is polled by the frame loop, so the multiplexer must not poll it
     * too. */
    assert_int_equal(usb.polled, 0);
}

static void test_a_source_that_loses_its_slot_gets_zero_force(void **state)
{
    (void)state;
    const struct hal_poi *const poi = &hal.poi[0];
    const struct poi_force force = { .drag = 1.0f };
    pad.there = 1;
    arrange(1);
    poi->ops->set_force(poi->self, &force);
    assert_true(pad.felt.drag == 1.0f);
    usb.there = 1;
    arrange(1);
    assert_true(pad.felt.drag == 0.0f);
}

static void test_a_source_beyond_the_maximum_is_rejected(void **state)
{
    (void)state;
    while (mux.source_count < INPUT_SOURCE_MAX) {
        add(&pad, INPUT_KIND_GAMEPAD);
    }
    assert_int_equal(input_mux_add(&mux, &mux.source[0]), -1);
    assert_int_equal(mux.source_count, INPUT_SOURCE_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_best_controller_gets_the_first_slot),
        cmocka_unit_test(test_an_assigned_controller_keeps_its_slot_among_its_kind),
        cmocka_unit_test(test_a_fifth_controller_gets_no_slot),
        cmocka_unit_test(test_every_set_of_controllers_is_assigned_correctly),
        cmocka_unit_test_setup(test_a_slot_forwards_calls_to_its_assigned_source, begin),
        cmocka_unit_test_setup(test_a_better_controller_gets_the_slot_only_between_games, begin),
        cmocka_unit_test_setup(test_a_lost_controller_keeps_its_slot_during_the_game, begin),
        cmocka_unit_test_setup(test_a_substitute_gets_a_slot_if_no_other_exists_or_once_used,
                               begin),
        cmocka_unit_test_setup(test_a_lost_controller_is_replaced_in_a_game_by_one_of_its_kind,
                               begin),
        cmocka_unit_test_setup(test_a_source_without_a_slot_is_still_polled, begin),
        cmocka_unit_test_setup(test_a_source_that_loses_its_slot_gets_zero_force, begin),
        cmocka_unit_test_setup(test_a_source_beyond_the_maximum_is_rejected, begin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
