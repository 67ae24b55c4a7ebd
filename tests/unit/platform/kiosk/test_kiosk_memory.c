/* test_kiosk_memory.c -- Tests that the running frame loop allocates no memory. The test program
 * replaces malloc() with a function that counts its calls.
 *
 * Sanitizers also replace malloc(), so the test is skipped in builds with a sanitizer. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/tank/preset.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/recorder/replayer.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAS_TRAP 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ||                         \
    __has_feature(memory_sanitizer)
#define HAS_TRAP 0
#endif
#endif
#if !defined(HAS_TRAP) && defined(__GLIBC__)
#define HAS_TRAP 1
#elif !defined(HAS_TRAP)
#define HAS_TRAP 0
#endif

static uint32_t allocations;

#if HAS_TRAP
/* glibc's own names of the allocation functions. The replacements below call these functions. */
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);

void *malloc(size_t size)
{
    allocations++;
    return __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    allocations++;
    return __libc_calloc(count, size);
}

void *realloc(void *old, size_t size)
{
    allocations++;
    return __libc_realloc(old, size);
}
#endif

static struct {
    struct clock_sim clock;
    struct display_sim display;
    struct buttons_sim buttons;
    struct pointer_sim poi;
    struct storage_sim storage;
    struct audio_sim audio;
    struct hal hal;
    struct kiosk kiosk;
    struct recorder recorder;
} rig;

#define STEP_NS 16666667ull

static void open_rig(const char *record_path)
{
    static const struct button_event press[] = { { .time_ns = 500000000, .pressed = INPUT_START } };
    static struct pointer_report reports[3000];
    for (uint32_t i = 0; i < 3000; i++) {
        reports[i] = (struct pointer_report){
            .time_ns = i * 8000000ull,
            .x_px = 200.0f + (float)(i % 800u),
            .y_px = 300.0f,
            .width_px = 1280,
            .height_px = 720,
            .buttons = i / 100u % 2u ? POINTER_DIP : 0,
            .wheel_notches = i % 300u == 0 ? 1.0f : 0.0f,
        };
    }
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.hal.display = sim_display_device(&rig.display);
    rig.buttons = (struct buttons_sim){ .clock = rig.hal.clock, .events = press, .event_count = 1 };
    rig.hal.buttons = sim_buttons_device(&rig.buttons);
    pointer_sim_init(&rig.poi, rig.hal.clock, &tank_preset(TANK_PRESET_FESTIVAL)->view);
    rig.poi.reports = reports;
    rig.poi.feed.count = 3000;
    rig.hal.poi[0] = pointer_sim_devices(&rig.poi).poi;
    rig.hal.storage = storage_sim_device(&rig.storage);
    rig.hal.audio = sim_audio_device(&rig.audio);
    const struct kiosk_config config = {
        .core = { .seed = 3, .fish_count = 60, .round_s = 10 },
        .tap = recorder_tap(&rig.recorder),
    };
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    assert_int_equal(recorder_begin(&rig.recorder, record_path, &rig.kiosk.core), 0);
}

/* The test runs attract mode, a whole round with dips and a recording, and the result. The poi is
 * unplugged and plugged in again. */
static void test_the_running_frame_loop_allocates_nothing(void **state)
{
    char path[] = "/tmp/kingyo-memory-XXXXXX";
    (void)state;
#if !HAS_TRAP
    skip();
#endif
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    open_rig(path);
    rig.poi.feed.unplug_at = 1200;
    rig.poi.feed.replug_ns = 10500000000ull;
    const uint32_t before = allocations;
    for (uint32_t i = 0; i < 1200; i++) {
        rig.clock.now_ns += STEP_NS;
        kiosk_frame(&rig.kiosk, &rig.hal);
    }
    const uint32_t during = allocations - before;
    assert_int_equal(recorder_end(&rig.recorder), 0);
    unlink(path);
    assert_int_equal(rig.kiosk.core.game.tick, 2400);
    assert_int_equal(rig.storage.record.id, 2); /* The store has accepted the record of the first
                                                   round and the entry with which the second round
                                                   begins. */
    assert_int_equal(rig.storage.entry.kind, LEDGER_BEGIN);
    assert_int_equal(during, 0);
}

static void test_the_allocation_counter_counts_an_allocation(void **state)
{
    (void)state;
#if !HAS_TRAP
    skip();
#endif
    const uint32_t before = allocations;
    void *volatile bytes = malloc(16);
    free(bytes);
    assert_int_equal(allocations - before, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_allocation_counter_counts_an_allocation),
        cmocka_unit_test(test_the_running_frame_loop_allocates_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
