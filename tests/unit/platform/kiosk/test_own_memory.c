/* test_own_memory.c -- Tests that Kingyo's own code allocates no memory in any frame. The display,
 * the sound and the store are real.
 *
 * The linker option --wrap redirects the calls of malloc() and similar functions in Kingyo's
 * objects to the __wrap_ functions below, which count them. The allocations of SDL and SQLite are
 * not counted, because both are separate libraries. Only the screenshots of the option --shots may
 * allocate, because no kiosk in service uses this option. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/tank/preset.h"
#include "core/game/lab/lab.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "platform/audio.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/recorder/replayer.h"
#include "platform/os/png.h"
#include "platform/render/display_gl.h"
#include "platform/store/storage.h"
#include "tests/unit/support/newest_record.h"

/* Duration of a frame, 1/30 s. At this low frame rate the test has to draw fewer frames. */
#define STEP_NS 33333333ull
#define REPORT_COUNT 800u

static atomic_uint allocations; /* Number of allocations in all threads. */

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
char *__real_strdup(const char *text);
FILE *__real_fopen(const char *path, const char *mode);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
char *__wrap_strdup(const char *text);
FILE *__wrap_fopen(const char *path, const char *mode);

void *__wrap_malloc(size_t size)
{
    allocations++;
    return __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    allocations++;
    return __real_calloc(count, size);
}

void *__wrap_realloc(void *old, size_t size)
{
    allocations++;
    return __real_realloc(old, size);
}

char *__wrap_strdup(const char *text)
{
    allocations++;
    return __real_strdup(text);
}

FILE *__wrap_fopen(const char *path, const char *mode)
{
    allocations++;
    return __real_fopen(path, mode);
}

static struct {
    char folder[64], recording[96];
    struct clock_sim clock;
    struct display_gl display;
    struct buttons_sim buttons;
    struct pointer_report reports[REPORT_COUNT];
    struct pointer_sim poi;
    struct storage storage;
    struct audio audio;
    struct hal hal;
    struct kiosk kiosk;
    struct recorder recorder;
} rig;

/* Prepares a pointer report for every 20 ms. The pointer moves 200 pixels to the right, jumps back
 * and starts again. The poi dips for one second in every two seconds. */
static void wire_hand(void)
{
    for (uint32_t i = 0; i < REPORT_COUNT; i++) {
        rig.reports[i] = (struct pointer_report){
            .time_ns = i * 20000000ull,
            .x_px = 60.0f + (float)(i % 200u),
            .y_px = 80.0f,
            .width_px = 320,
            .height_px = 180,
            .buttons = i / 50u % 2u ? POINTER_DIP : 0,
        };
    }
    pointer_sim_init(&rig.poi, rig.hal.clock, &tank_preset(TANK_PRESET_FESTIVAL)->view);
    rig.poi.reports = rig.reports;
    rig.poi.feed.count = REPORT_COUNT;
    rig.hal.poi[0] = pointer_sim_devices(&rig.poi).poi;
}

static void wire_devices(void)
{
    static const struct button_event press[] = { { .time_ns = 500000000, .pressed = INPUT_START } };
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.display.config =
        (struct display_gl_config){ .width = 320, .height = 180, .off_screen = true };
    rig.hal.display = display_gl_device(&rig.display);
    rig.buttons = (struct buttons_sim){ .clock = rig.hal.clock, .events = press, .event_count = 1 };
    rig.hal.buttons = sim_buttons_device(&rig.buttons);
    rig.storage.dir = rig.folder;
    rig.hal.storage = storage_device(&rig.storage);
    rig.hal.audio = audio_device(&rig.audio);
    wire_hand();
}

static int open_fixture(void **state)
{
    (void)state;
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    strcpy(rig.folder, "/tmp/kingyo-memory-XXXXXX");
    if (!mkdtemp(rig.folder)) {
        return -1;
    }
    snprintf(rig.recording, sizeof rig.recording, "%s/play.kgr", rig.folder);
    wire_devices();
    const int opened = rig.hal.display.ops->open(rig.hal.display.self) |
                       rig.hal.storage.ledger.ops->open(rig.hal.storage.ledger.self) |
                       rig.hal.audio.ops->open(rig.hal.audio.self);
    const struct kiosk_config config = {
        .core = { .seed = 3, .fish_count = 300, .round_s = 10 },
        .tap = recorder_tap(&rig.recorder),
    };
    return opened != HAL_OK || kiosk_init(&rig.kiosk, &rig.hal, &config) != CORE_OK ||
           recorder_begin(&rig.recorder, rig.recording, &rig.kiosk.core) != 0;
}

static int close_fixture(void **state)
{
    char path[128];
    (void)state;
    rig.hal.audio.ops->close(rig.hal.audio.self);
    kiosk_close_store(&rig.kiosk, &rig.hal);
    rig.hal.display.ops->close(rig.hal.display.self);
    recorder_end(&rig.recorder);
    static const char *const files[] = { "play.kgr",
                                         STORAGE_FILE,
                                         STORAGE_FILE "-wal",
                                         STORAGE_FILE "-shm",
                                         STORAGE_FILE STORAGE_BACKUP_SUFFIX,
                                         STORAGE_FILE STORAGE_MIRROR_SUFFIX };
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        snprintf(path, sizeof path, "%s/%s", rig.folder, files[i]);
        unlink(path);
    }
    return rmdir(rig.folder);
}

static bool is_round_saved(void)
{
    const uint32_t id = newest_record(&rig.kiosk.output)->id;
    return id != 0 && rig.hal.storage.ledger.ops->committed_id(rig.hal.storage.ledger.self) >= id;
}

/* The test runs attract mode and a round with drawing, sound and recording, until the round is
 * stored. */
static void test_kingyo_code_allocates_nothing_from_the_first_frame_to_the_saved_round(void **state)
{
    (void)state;
    const uint32_t before = allocations;
    for (uint32_t i = 0; i < REPORT_COUNT * 20u / 33u; i++) {
        rig.clock.now_ns += STEP_NS;
        kiosk_frame(&rig.kiosk, &rig.hal);
    }
    for (uint32_t i = 0; i < 200 && !is_round_saved(); i++) {
        usleep(20000); /* Waits 20 ms for the store thread, which writes to the disk. */
    }
    const uint32_t during = allocations - before;
    assert_true(is_round_saved());
    assert_true(rig.audio.taken > 0);
    assert_int_equal(rig.kiosk.faults.display, 0);
    assert_int_equal(during, 0);
}

/* The growth lab shows every species in turn, beside its ordinary (linear) morph. The GPU has fewer
 * texture slots than there are species, so textures must be uploaded again and again. Finally an
 * album of caught fish is shown. */
static void test_kingyo_code_allocates_nothing_while_the_lab_and_album_change_species(void **state)
{
    (void)state;
    static struct core core;
    static struct scene scene;
    static struct output output;
    const struct hal_display *const display = &rig.hal.display;
    const struct core_config config = { .seed = 3, .fish_count = 20 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    const uint32_t before = allocations;
    for (uint32_t i = 0; i < 3u * species_table_count; i++) {
        core.game.lab.species = (uint8_t)(i / 3u);
        lab_begin(&core.game, &core.world, &core.config, &output);
        core.game.lab.progress = 0.5f * (float)(i % 3u);
        core.game.lab.compare = 1;
        core_scene(&core, &scene);
        assert_int_equal(display->ops->present(display->self, &scene), HAL_OK);
    }
    assert_int_equal(scene.phase, PHASE_LAB);
    assert_true(rig.display.renderer.specimens.draw_count > 6u * species_table_count);
    for (uint32_t i = 0; i < ALBUM_FISH_MAX; i++) {
        core.world.tank.fish[i].gait = GAIT_BOWL;
        core.world.tank.fish[i].holder = 0;
    }
    album_note(&core.game.album, &core.world, 0, ALBUM_FISH_MAX);
    core.game.phase = PHASE_ALBUM;
    core_scene(&core, &scene);
    assert_int_equal(display->ops->present(display->self, &scene), HAL_OK);
    assert_int_equal(allocations - before, 0);
}

/* png_write(), which writes screenshots, allocates memory. The counter must count these
 * allocations, which proves that the other tests can fail. */
static void test_the_allocation_counter_counts_a_written_screenshot(void **state)
{
    static const uint8_t rgb[3 * 4 * 4];
    char path[128];
    (void)state;
    snprintf(path, sizeof path, "%s/shot.png", rig.folder);
    const uint32_t before = allocations;
    assert_int_equal(png_write(path, rgb, 4, 4), 0);
    unlink(path);
    assert_true(allocations > before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            test_kingyo_code_allocates_nothing_from_the_first_frame_to_the_saved_round),
        cmocka_unit_test(test_kingyo_code_allocates_nothing_while_the_lab_and_album_change_species),
        cmocka_unit_test(test_the_allocation_counter_counts_a_written_screenshot),
    };
    return cmocka_run_group_tests(tests, open_fixture, close_fixture);
}
