/* test_sound_causes.c -- checks that each sound follows its cause: how often the sound is played,
 * that a stronger cause makes a louder sound, and that the sound comes from the side of its cause.
 *
 * The sounds of a poi are tested with a scripted poi. The sounds of the game are tested with the
 * whole core. */
#include "tests/unit/support/core_fixture.h"
#include "tests/unit/support/poi_fixture.h"

#define ASIDE_M 0.20f /* Distance of the poi from the middle of the tank, to either side. */

static struct poi_fixture fixture;
static struct {
    uint32_t count;
    float gain, pan; /* Gain of the loudest sound, and place of the last sound. */
} heard[SOUND_COUNT];

static void collect(void)
{
    for (uint32_t i = 0; i < fixture.output.sound_count; i++) {
        const struct sound_event *const event = &fixture.output.sounds[i];
        heard[event->sound].count++;
        heard[event->sound].gain = f_max(heard[event->sound].gain, event->gain);
        heard[event->sound].pan = event->pan;
    }
}

/* Runs one tick of the scripted poi and collects its sounds. */
static void listen(void)
{
    fixture_tick(&fixture);
    collect();
}

/* Forgets the sounds up to now, and listens for a second in which the poi moves with
 * `velocity_m_s` and turns with `roll_rad_s`, both for at most 0.5 s. */
static void move(vec3 velocity_m_s, float roll_rad_s)
{
    memset(heard, 0, sizeof heard);
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        if (i < CORE_TICK_HZ / 2u) {
            fixture.hand.position_m = v3_muladd(fixture.hand.position_m, velocity_m_s, CORE_TICK_S);
            fixture.hand.angles.roll_rad += roll_rad_s * CORE_TICK_S;
        }
        listen();
    }
}

/* Puts a new poi at the height `y_m`, `x_m` beside the middle of the tank. */
static void begin(float x_m, float y_m, uint8_t grade)
{
    fixture_init(&fixture, grade, 1);
    fixture.hand.position_m = v3(x_m, y_m, -0.1f);
    poi_init(&fixture.poi, grade, fixture.hand.position_m, 1);
    fixture.poi.link = POI_SOURCE_LIVE;
    fixture.has_wrist = 1;
}

/* ---- Causes, whose strength is `strength` ---------------------------------------------------- */

/* Dips the poi with the speed `strength` in m/s. */
static void dip_fast(float x_m, float strength)
{
    begin(x_m, 0.05f, 4);
    move(v3(0.0f, -strength, 0.0f), 0.0f);
}

/* Dips paper of which the share `strength` is dry. */
static void dip_dry(float x_m, float strength)
{
    begin(x_m, 0.05f, 4);
    fixture_plain_paper(&fixture.poi.sheet, 1.0f - strength);
    move(v3(0.0f, -0.25f, 0.0f), 0.0f);
}

/* Lifts a poi with the speed `strength` in m/s. */
static void lift_fast(float x_m, float strength)
{
    begin(x_m, -0.06f, 4);
    fixture_wait(&fixture, 2.0f);
    move(v3(0.0f, strength, 0.0f), 0.0f);
}

/* Lifts a poi whose paper is missing (`strength` 0) or carries water (1). */
static void lift_full(float x_m, float strength)
{
    begin(x_m, -0.06f, 4);
    if (strength <= 0.0f) {
        fixture_tear_hole(&fixture, 0.0f, 0.0f, 1.0f);
    }
    fixture_wait(&fixture, 2.0f);
    move(v3(0.0f, 0.3f, 0.0f), 0.0f);
}

/* Turns a lifted poi with `strength` in rad/s, so that its water runs off. */
static void pour_fast(float x_m, float strength)
{
    begin(x_m, -0.06f, 4);
    fixture_wait(&fixture, 2.0f);
    move(v3(0.0f, 0.3f, 0.0f), 0.0f);
    move(v3(0.0f, 0.0f, 0.0f), strength);
}

/* Damages the paper within 4 mm of its middle, which then is about to tear. */
static void weaken_the_middle(void)
{
    struct sheet *const sheet = &fixture.poi.sheet;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        const float x = sheet_line_m(sheet, i % SHEET_SIDE),
                    z = sheet_line_m(sheet, i / SHEET_SIDE);
        if (sheet->state[i] == CELL_PAPER && x * x + z * z < 0.004f * 0.004f) {
            sheet->damage[i] = 0.9999f;
        }
    }
}

/* Runs one tick in which `strength` cells tear. */
static void tear_cells(float x_m, float strength)
{
    const struct stall stall = { &fixture.tank, &fixture.bowl, 1, false };
    struct catch_result caught[POI_MAX] = { 0 };
    begin(x_m, 0.05f, 5);
    memset(heard, 0, sizeof heard);
    fixture.poi.strain.cells_torn = (uint32_t)strength;
    catch_tick(&fixture.poi, 0, &stall, 1, &fixture.output, caught);
    collect();
}

/* Lets a fish with the vigour `strength` slap on the paper for a second. */
static void slap_hard(float x_m, float strength)
{
    begin(x_m, 0.06f, 4);
    fixture_wait(&fixture, 0.2f);
    struct carried_fish *const carried = fixture_place_fish(&fixture, 0.045f, 0.0f, 0.0f, 0.0f);
    fixture_wait(&fixture, 0.2f);
    carried->rest_s = 0.0f;
    carried->vigour = strength;
    move(v3(0.0f, 0.0f, 0.0f), 0.0f);
}

static const struct cause {
    const char *name;
    void (*act)(float x_m, float strength);
    enum sound sound;
    float weak, strong;
    uint32_t count_min, count_max; /* Number of sounds of the strong cause. */
} causes[] = {
    { "slow and fast dip", dip_fast, SOUND_DIP, 0.15f, 0.5f, 1, 1 },
    { "partly wet and dry paper", dip_dry, SOUND_WET, 0.3f, 1.0f, 1, 1 },
    { "slow and fast lift", lift_fast, SOUND_LIFT, 0.2f, 0.5f, 1, 1 },
    { "lift without and with water", lift_full, SOUND_LIFT, 0.0f, 1.0f, 1, 1 },
    { "level and tilted wet paper", pour_fast, SOUND_DRIP, 0.1f, 2.4f, 5, 120 },
    { "few and many torn cells", tear_cells, SOUND_TEAR, 2.0f, 20.0f, 1, 1 },
    { "weak and strong slap", slap_hard, SOUND_SLAP, 0.3f, 1.0f, 2, 10 },
};

static void test_a_stronger_cause_makes_a_louder_sound_on_its_side(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < sizeof causes / sizeof causes[0]; i++) {
        const struct cause *const cause = &causes[i];
        for (int32_t side = -1; side <= 1; side += 2) {
            const float x_m = (float)side * ASIDE_M;
            cause->act(x_m, cause->weak);
            const float weak = heard[cause->sound].gain;
            const uint32_t weak_count = heard[cause->sound].count;
            cause->act(x_m, cause->strong);
            const float strong = heard[cause->sound].gain;
            const uint32_t count = heard[cause->sound].count;
            print_message("%s: %u of gain %.2f, %u of gain %.2f\n", cause->name, weak_count,
                          (double)weak, count, (double)strong);
            assert_true(weak_count > 0 && weak > 0.0f);
            assert_true(strong > weak + 0.05f && strong <= 1.0f);
            assert_in_range(count, cause->count_min, cause->count_max);
            assert_float_equal(heard[cause->sound].pan, 2.0f * x_m / fixture.tank.size_m.x, 0.05f);
        }
    }
}

/* A fast sweep tears one cell at first, and a quarter of the paper in the next tick. The loud tear
 * must be heard although a quiet tear was played just before. */
static void test_a_tear_that_grows_is_heard_in_its_full_strength(void **state)
{
    (void)state;
    begin(ASIDE_M, -0.12f, 5);
    fixture_wait(&fixture, 2.0f);
    weaken_the_middle();
    uint32_t first = 0;
    memset(heard, 0, sizeof heard);
    for (uint32_t i = 0; i < CORE_TICK_HZ / 2u; i++) {
        fixture.hand.position_m.y += 0.7f * CORE_TICK_S;
        listen();
        first = first > 0 ? first : fixture.poi.strain.cells_torn;
    }
    print_message("%u cells tear first, %u sounds up to a gain of %.2f\n", first,
                  heard[SOUND_TEAR].count, (double)heard[SOUND_TEAR].gain);
    assert_in_range(first, 1, 10);
    assert_float_equal(heard[SOUND_TEAR].gain, 1.0f, 1e-6f);
    assert_in_range(heard[SOUND_TEAR].count, 2, 3);
}

static void test_a_sound_without_its_cause_is_not_played(void **state)
{
    (void)state;
    dip_dry(ASIDE_M, 0.0f); /* The paper is wet already. */
    assert_int_equal(heard[SOUND_DIP].count, 1);
    assert_int_equal(heard[SOUND_WET].count, 0);
    begin(ASIDE_M, 0.06f, 4); /* A dry poi in the air. */
    move(v3(0.0f, 0.2f, 0.0f), 2.0f);
    assert_int_equal(heard[SOUND_DRIP].count + heard[SOUND_LIFT].count, 0);
    assert_int_equal(heard[SOUND_TEAR].count + heard[SOUND_SLAP].count, 0);
    slap_hard(ASIDE_M, 0.0f); /* A fish without strength. */
    assert_int_equal(heard[SOUND_SLAP].count, 0);
}

/* ---- Sounds of the game ---------------------------------------------------------------------- */

/* Starts a round of one player. */
static void play(void)
{
    const struct core_config config = { .seed = 7, .fish_count = 12, .round_s = 60 };
    open_core(&config);
    hold(0, v3(0.0f, ABOVE_M, 0.0f));
    press(INPUT_START);
}

static void test_the_keeper_calls_once_as_the_round_starts(void **state)
{
    (void)state;
    play();
    assert_int_equal(sounds[SOUND_START], 1);
    for (uint32_t i = 0; i < 10u * CORE_TICK_HZ && core.game.phase != PHASE_ROUND; i++) {
        assert_int_equal(sounds[SOUND_WELCOME], 0);
        tick();
    }
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(sounds[SOUND_WELCOME], 1);
    assert_int_equal(sounds[SOUND_START], 2);
    for (uint32_t i = 0; i < output.sound_count; i++) {
        assert_true(output.sounds[i].pan == 0.0f);
    }
    ticks(2u * CORE_TICK_HZ);
    assert_int_equal(sounds[SOUND_WELCOME], 1);
}

/* Lets fish number 0 fall into the water, after it lay on the lifted paper for `clear_ticks`.
 * Returns the number of near misses that are announced. */
static uint32_t misses_after(uint16_t clear_ticks)
{
    struct fish *const fish = &core.world.tank.fish[0];
    struct poi *const poi = &core.world.poi[0];
    play();
    wait_for_phase(PHASE_ROUND, 10u * CORE_TICK_HZ);
    ticks(30);
    fish->gait = GAIT_HELD;
    fish->holder = 0;
    fish->position_m = v3(0.1f, 0.01f, 0.0f);
    poi->carried_fish[poi->carried_count++] =
        (struct carried_fish){ .state = CARRIED_FALLING, .clear_ticks = (uint8_t)clear_ticks };
    ticks(CORE_TICK_HZ);
    assert_int_equal(sounds[SOUND_PLOP], 1);
    return sounds[SOUND_MISS];
}

static void test_only_a_fish_that_was_lifted_is_a_near_miss(void **state)
{
    (void)state;
    assert_int_equal(misses_after(CARRIED_CLEAR_TICKS), 1);
    assert_int_equal(misses_after(0), 0);
}

static void test_each_step_in_the_menu_taps_once(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 7, .fish_count = 12 };
    open_core(&config);
    press(INPUT_TEST);
    ticks(CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(sounds[SOUND_KEY], 0);
    for (uint32_t i = 1; i <= 3u; i++) {
        press(INPUT_SERVICE);
        assert_int_equal(output.sound_count, 1);
        assert_true(output.sounds[0].pan == 0.0f);
        ticks(CORE_TICK_HZ / 4u);
        assert_int_equal(sounds[SOUND_KEY], i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_stronger_cause_makes_a_louder_sound_on_its_side),
        cmocka_unit_test(test_a_tear_that_grows_is_heard_in_its_full_strength),
        cmocka_unit_test(test_a_sound_without_its_cause_is_not_played),
        cmocka_unit_test(test_the_keeper_calls_once_as_the_round_starts),
        cmocka_unit_test(test_only_a_fish_that_was_lifted_is_a_near_miss),
        cmocka_unit_test(test_each_step_in_the_menu_taps_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
