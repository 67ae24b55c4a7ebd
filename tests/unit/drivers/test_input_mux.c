/* test_input_mux.c -- who sits where, as controllers come and go. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/tank/preset.h"
#include "drivers/input_mux.h"

/* ---- The rule ------------------------------------------------------------------------------- */

enum { USB0, USB1, USB2, USB3, PAD0, PAD1, PAD2, PAD3, MOUSE, COUNT };
#define NOBODY SLOT_NONE
#define BIT(who) (1u << (who))

static const uint8_t kinds[COUNT] = { INPUT_KIND_USB,     INPUT_KIND_USB,     INPUT_KIND_USB,
                                      INPUT_KIND_USB,     INPUT_KIND_GAMEPAD, INPUT_KIND_GAMEPAD,
                                      INPUT_KIND_GAMEPAD, INPUT_KIND_GAMEPAD, INPUT_KIND_POINTER };

static void assert_share(uint8_t seat[POI_MAX], uint32_t there, const uint8_t wanted[POI_MAX])
{
    input_mux_assign(seat, kinds, COUNT, there);
    assert_memory_equal(seat, wanted, POI_MAX);
}

static void test_the_best_takes_the_first_seat(void **state)
{
    (void)state;
    uint8_t seat[POI_MAX] = { NOBODY, NOBODY, NOBODY, NOBODY };
    assert_share(seat, 0, (uint8_t[]){ NOBODY, NOBODY, NOBODY, NOBODY });
    assert_share(seat, BIT(MOUSE), (uint8_t[]){ MOUSE, NOBODY, NOBODY, NOBODY });
    assert_share(seat, BIT(MOUSE) | BIT(PAD2), (uint8_t[]){ PAD2, MOUSE, NOBODY, NOBODY });
    assert_share(seat, BIT(MOUSE) | BIT(PAD2) | BIT(USB1),
                 (uint8_t[]){ USB1, PAD2, MOUSE, NOBODY });
    assert_share(seat, BIT(MOUSE), (uint8_t[]){ MOUSE, NOBODY, NOBODY, NOBODY });
}

static void test_who_sits_keeps_his_place_among_his_kind(void **state)
{
    (void)state;
    uint8_t seat[POI_MAX] = { NOBODY, NOBODY, NOBODY, NOBODY };
    assert_share(seat, BIT(USB2), (uint8_t[]){ USB2, NOBODY, NOBODY, NOBODY });
    assert_share(seat, BIT(USB2) | BIT(USB0), (uint8_t[]){ USB2, USB0, NOBODY, NOBODY });
    assert_share(seat, BIT(USB2) | BIT(USB0) | BIT(USB3), (uint8_t[]){ USB2, USB0, USB3, NOBODY });
    assert_share(seat, BIT(USB0) | BIT(USB3), (uint8_t[]){ USB3, USB0, NOBODY, NOBODY });
}

static void test_no_seat_is_left_for_the_fifth(void **state)
{
    (void)state;
    uint8_t seat[POI_MAX] = { NOBODY, NOBODY, NOBODY, NOBODY };
    assert_share(seat, BIT(PAD0) | BIT(PAD1) | BIT(PAD2) | BIT(PAD3) | BIT(MOUSE),
                 (uint8_t[]){ PAD0, PAD1, PAD2, PAD3 });
    assert_share(seat, BIT(USB0) | BIT(PAD0) | BIT(PAD1) | BIT(PAD2) | BIT(PAD3) | BIT(MOUSE),
                 (uint8_t[]){ USB0, PAD1, PAD2, PAD0 });
}

/* Whatever came before: the seats hold as many as can sit, each once, better kinds in front, and
 * asking again moves nobody. */
static void test_any_company_is_seated_well(void **state)
{
    (void)state;
    uint8_t seat[POI_MAX] = { NOBODY, NOBODY, NOBODY, NOBODY };
    for (uint32_t turn = 0; turn < 20000; turn++) {
        const uint32_t there =
            rng_u32((struct rng_key){ 6, turn, 0, RNG_TEST }) & (BIT(COUNT) - 1u);
        const uint32_t guests = (uint32_t)__builtin_popcount(there);
        uint32_t seen = 0;
        input_mux_assign(seat, kinds, COUNT, there);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            assert_int_equal(seat[i] != NOBODY, i < guests);
            if (seat[i] != NOBODY) {
                assert_true(there & BIT(seat[i]));
                assert_false(seen & BIT(seat[i]));
                assert_true(i == 0 || kinds[seat[i - 1]] <= kinds[seat[i]]);
                seen |= BIT(seat[i]);
            }
        }
        const uint8_t before[POI_MAX] = { seat[0], seat[1], seat[2], seat[3] };
        assert_share(seat, there, before);
    }
}

/* ---- The seats ------------------------------------------------------------------------------ */

struct source {
    int there;
    int lies_about; /* It can be opened, although nobody has it in hand. */
    uint32_t opened, polled, looked, asked;
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

static void source_look(void *self, const struct view *view,
                        const struct display_settings *display_settings)
{
    struct source *source = self;
    (void)view;
    (void)display_settings;
    source->looked++;
}

static const char *source_describe(void *self)
{
    (void)self;
    return "a source";
}

static int source_is_there(void *self)
{
    struct source *source = self;
    source->asked++;
    return source->there;
}

static struct input_mux seats;
static struct source usb, pad, mouse;

static void add(struct source *source, enum input_kind kind)
{
    static const struct hal_poi_ops ops = {
        .open = source_open,
        .poll = source_poll,
        .set_force = source_feel,
        .set_view = source_look,
        .describe = source_describe,
    };
    const struct input_source one = {
        .poi = { .ops = &ops, .self = source },
        .is_there = source_is_there,
        .self = source,
        .kind = (uint8_t)kind,
    };
    assert_int_equal(input_mux_add(&seats, &one), 0);
}

static int begin(void **state)
{
    (void)state;
    usb = pad = (struct source){ 0 };
    mouse = (struct source){ .there = 1 };
    input_mux_init(&seats, "plug one in");
    add(&usb, INPUT_KIND_USB);
    add(&pad, INPUT_KIND_GAMEPAD);
    add(&mouse, INPUT_KIND_POINTER);
    return 0;
}

static uint32_t arrange(int may_move)
{
    const struct hal_seats device = input_mux_device(&seats);
    return device.ops->arrange(device.self, may_move);
}

static void test_a_seat_passes_on_to_whoever_sits_there(void **state)
{
    (void)state;
    const struct hal_poi poi = input_mux_poi(&seats, 0);
    struct poi_sample sample;
    assert_int_equal(poi.ops->open(poi.self), HAL_ERR_ABSENT);
    assert_int_equal(poi.ops->poll(poi.self, &sample, 1), HAL_ERR_ABSENT);
    assert_string_equal(poi.ops->describe(poi.self), "plug one in");
    assert_int_equal(arrange(1), 1u);
    assert_int_equal(poi.ops->open(poi.self), HAL_OK);
    assert_int_equal(poi.ops->poll(poi.self, &sample, 1), 1);
    assert_int_equal(mouse.polled, 1);
    assert_string_equal(poi.ops->describe(poi.self), "a source");
    const struct hal_poi second = input_mux_poi(&seats, 1);
    assert_string_equal(second.ops->describe(second.self), "");
}

static void test_a_better_one_gets_the_seat_between_games_only(void **state)
{
    (void)state;
    arrange(1);
    pad.there = 1;
    assert_int_equal(arrange(0), 0u);
    assert_int_equal(arrange(0), 0u);
    assert_true(pad.asked >= 2); /* It is looked for all the same. */
    assert_int_equal(arrange(1), 3u);
    assert_int_equal(arrange(1), 0u);
    usb.there = 1;
    assert_int_equal(arrange(1), 7u);
}

/* Whoever pulls the cable in mid-round comes back to his own round, not to someone else's mouse. */
static void test_a_lost_one_keeps_its_seat_while_the_game_lasts(void **state)
{
    (void)state;
    const struct hal_poi poi = input_mux_poi(&seats, 0);
    struct poi_sample sample;
    usb.there = 1;
    arrange(1);
    usb.there = 0;
    assert_int_equal(arrange(0), 0u);
    assert_int_equal(poi.ops->poll(poi.self, &sample, 1), HAL_ERR_GONE);
    assert_int_equal(poi.ops->open(poi.self), HAL_ERR_GONE);
    usb.there = 1;
    assert_int_equal(arrange(0), 1u); /* Back at once, also in a round. */
    assert_int_equal(arrange(0), 0u);
    assert_int_equal(poi.ops->open(poi.self), HAL_OK);
    usb.there = 0;
    assert_int_equal(arrange(1), 3u);
    assert_int_equal(poi.ops->poll(poi.self, &sample, 1), 1);
    assert_true(mouse.polled > 0);
}

/* A mouse that lies about in a cabinet is no second player, but the first where nobody else is. */
static void test_one_that_stands_in_sits_where_nobody_else_does_or_once_it_is_used(void **state)
{
    (void)state;
    seats.source[2].stands_in = 1;
    mouse.there = 0;
    mouse.lies_about = 1;
    assert_int_equal(arrange(1), 1u);
    pad.there = 1;
    assert_int_equal(arrange(1), 1u);
    const struct hal_poi second = input_mux_poi(&seats, 1);
    assert_int_equal(second.ops->open(second.self), HAL_ERR_ABSENT);
    arrange(1);
    assert_int_equal(mouse.polled, 1); /* Without a seat, lest nobody sees that it is moved. */
    mouse.there = 1;
    assert_int_equal(arrange(1), 2u);
    mouse.there = 0;
    assert_int_equal(arrange(0), 0u);
    assert_int_equal(arrange(1), 2u);
}

/* His own without a serial number, plugged in elsewhere, or the one that lies ready: but never the
 * mouse, and never somebody else's. */
static void test_who_lost_his_in_a_game_takes_up_another_of_its_kind(void **state)
{
    (void)state;
    static struct source second, third;
    second = third = (struct source){ 0 };
    add(&second, INPUT_KIND_USB);
    add(&third, INPUT_KIND_USB);
    usb.there = second.there = 1;
    arrange(1);
    usb.there = 0;
    assert_int_equal(arrange(0), 0u); /* The second has a seat, the mouse is no poi. */
    third.there = 1;
    assert_int_equal(arrange(0), 1u);
    const struct hal_poi poi = input_mux_poi(&seats, 0);
    struct poi_sample sample;
    poi.ops->poll(poi.self, &sample, 1);
    assert_int_equal(third.polled, 1);
    usb.there = 1;
    assert_int_equal(arrange(0), 0u);
}

/* Else SDL's queue would fill with what a mouse says that nobody plays with. */
static void test_who_has_no_seat_is_listened_to(void **state)
{
    (void)state;
    while (seats.source_count < POI_MAX + 1u) {
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
    assert_int_equal(usb.polled, 0); /* The frame loop does, since it sits. */
}

static void test_who_sits_down_is_told_the_view(void **state)
{
    (void)state;
    const struct hal_poi poi = input_mux_poi(&seats, 0);
    poi.ops->set_view(poi.self, &tank_preset(TANK_PRESET_FESTIVAL)->view,
                      &(struct display_settings){ .light = 1.0f });
    arrange(1);
    assert_int_equal(mouse.looked, 0);
    poi.ops->open(poi.self);
    assert_int_equal(mouse.looked, 1);
}

static void test_a_hand_that_stands_up_feels_nothing_more(void **state)
{
    (void)state;
    const struct hal_poi poi = input_mux_poi(&seats, 0);
    const struct poi_force force = { .drag = 1.0f };
    pad.there = 1;
    arrange(1);
    poi.ops->set_force(poi.self, &force);
    assert_true(pad.felt.drag == 1.0f);
    usb.there = 1;
    arrange(1);
    assert_true(pad.felt.drag == 0.0f);
}

static void test_one_source_too_many_is_refused(void **state)
{
    (void)state;
    while (seats.source_count < INPUT_SOURCE_MAX) {
        add(&pad, INPUT_KIND_GAMEPAD);
    }
    assert_int_equal(input_mux_add(&seats, &seats.source[0]), -1);
    assert_int_equal(seats.source_count, INPUT_SOURCE_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_best_takes_the_first_seat),
        cmocka_unit_test(test_who_sits_keeps_his_place_among_his_kind),
        cmocka_unit_test(test_no_seat_is_left_for_the_fifth),
        cmocka_unit_test(test_any_company_is_seated_well),
        cmocka_unit_test_setup(test_a_seat_passes_on_to_whoever_sits_there, begin),
        cmocka_unit_test_setup(test_a_better_one_gets_the_seat_between_games_only, begin),
        cmocka_unit_test_setup(test_a_lost_one_keeps_its_seat_while_the_game_lasts, begin),
        cmocka_unit_test_setup(
            test_one_that_stands_in_sits_where_nobody_else_does_or_once_it_is_used, begin),
        cmocka_unit_test_setup(test_who_lost_his_in_a_game_takes_up_another_of_its_kind, begin),
        cmocka_unit_test_setup(test_who_has_no_seat_is_listened_to, begin),
        cmocka_unit_test_setup(test_who_sits_down_is_told_the_view, begin),
        cmocka_unit_test_setup(test_a_hand_that_stands_up_feels_nothing_more, begin),
        cmocka_unit_test_setup(test_one_source_too_many_is_refused, begin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
