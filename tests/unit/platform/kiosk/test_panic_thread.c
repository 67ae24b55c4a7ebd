/* test_panic_thread.c -- Tests that a stack overflow in any thread is handled as a panic, which
 * leaves a recording as evidence. */
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/audio.h"
#include "platform/cpu.h"
#include "platform/kiosk/recorder/panic_recovery.h"
#include "platform/os/panic.h"
#include "platform/os/thread.h"

/* Number of ticks that the kiosk records before the panic. */
#define TICKS 30u

static struct core core;
static struct session_recorder sessions;
static struct evidence evidence;
static struct replay_reader reader;

static void write_evidence(void *self, const char *reason)
{
    panic_evidence_write(self, reason);
}

static void record_ticks(void)
{
    static struct output output;
    const struct input input = { .pressed = 0 };
    struct core_config config = { .seed = 11, .lanes = cpu_lanes() };
    settings_reset(&config.persistent.settings);
    if (core_init(&core, &config) != CORE_OK) {
        _exit(1);
    }
    session_recorder_begin(&sessions, &core);
    for (uint32_t i = 0; i < TICKS; i++) {
        session_recorder_before(&sessions, &input);
        core_tick(&core, &input, &output);
        session_recorder_tick(&sessions, &input, &core, &output);
    }
}

/* Recurses until the thread's stack overflows and the guard page causes SIGSEGV. The volatile array
 * and the addition after the call prevent the compiler from replacing the recursion by a loop. */
static uint32_t overflow(uint32_t depth)
{
    volatile uint8_t page[4096];
    page[0] = (uint8_t)depth;
    return depth == UINT32_MAX ? 0 : overflow(depth + 1u) + page[0];
}

static void *overflow_thread(void *self)
{
    (void)self;
    overflow(0);
    return NULL;
}

/* Replaces the mixer. A played sound overflows the stack of SDL's audio thread. */
void mixer_init(struct mixer *mixer, uint32_t seed)
{
    (void)mixer, (void)seed;
}

void mixer_set_levels(struct mixer *mixer, const struct sound_levels *levels)
{
    (void)mixer, (void)levels;
}

void mixer_play(struct mixer *mixer, const struct sound_event *event)
{
    (void)mixer, (void)event;
    overflow(0);
}

void mixer_render(struct mixer *mixer, int16_t *stereo, uint32_t frame_count)
{
    (void)mixer, (void)stereo, (void)frame_count;
}

static void *play_sound(void *self)
{
    static struct audio audio;
    static const struct sound_event event = { .sound = SOUND_CATCH, .gain = 1.0f };
    const struct hal_audio device = audio_device(&audio);
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    if (device.ops->open(device.self) == HAL_OK) {
        device.ops->play(device.self, &event);
        sleep(20); /* The audio thread ends the process before this sleep ends. */
    }
    return self;
}

/* Simulates a kiosk that records some ticks and then overflows the stack of one thread. The thread
 * is the caller if `run` is null, otherwise a new thread that runs `run`. The function does not
 * return. */
static void run_kiosk(const char *folder, void *(*run)(void *self))
{
    const struct rlimit no_core_file = { 0 };
    pthread_t thread;
    setrlimit(RLIMIT_CORE, &no_core_file);
    record_ticks();
    panic_evidence_open(&evidence, folder, &sessions, &core);
    panic_prepare(write_evidence, &evidence);
    if (!run) {
        overflow(0);
    } else if (thread_start(&thread, run, NULL) == 0) {
        pthread_join(thread, NULL);
    }
    _exit(1);
}

static void assert_evidence(void *(*run)(void *self))
{
    char folder[] = "/tmp/kingyo-overflow-XXXXXX", file[64], command[64];
    struct replay_totals totals;
    int status = 0;
    assert_non_null(mkdtemp(folder));
    const pid_t child = fork();
    if (child == 0) {
        run_kiosk(folder, run);
    }
    assert_true(child > 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), SIGSEGV);
    snprintf(file, sizeof file, "%s/panic-0.kgr", folder);
    const int error = replay_scan(&reader, file, &totals);
    snprintf(command, sizeof command, "rm -rf %s", folder);
    assert_int_equal(system(command), 0);
    assert_int_equal(error, 0);
    assert_int_equal(totals.ticks, TICKS);
}

static void test_a_stack_overflow_of_the_main_thread_leaves_a_replay(void **state)
{
    (void)state;
    assert_evidence(NULL);
}

static void test_a_stack_overflow_of_another_thread_leaves_a_replay(void **state)
{
    (void)state;
    assert_evidence(overflow_thread);
}

static void test_a_stack_overflow_of_the_audio_thread_leaves_a_replay(void **state)
{
    (void)state;
    assert_evidence(play_sound);
}

static void *read_signal_stack(void *self)
{
    sigaltstack(NULL, self);
    return NULL;
}

static void test_each_thread_has_its_own_signal_stack(void **state)
{
    (void)state;
    pthread_t thread;
    stack_t main_stack, thread_stack = { 0 };
    panic_prepare(NULL, NULL);
    sigaltstack(NULL, &main_stack);
    assert_int_equal(thread_start(&thread, read_signal_stack, &thread_stack), 0);
    pthread_join(thread, NULL);
    assert_int_equal(thread_stack.ss_flags & SS_DISABLE, 0);
    assert_int_equal(thread_stack.ss_size, PANIC_STACK_SIZE);
    assert_int_equal(main_stack.ss_size, PANIC_STACK_SIZE);
    assert_ptr_not_equal(thread_stack.ss_sp, main_stack.ss_sp);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_stack_overflow_of_the_main_thread_leaves_a_replay),
        cmocka_unit_test(test_a_stack_overflow_of_another_thread_leaves_a_replay),
        cmocka_unit_test(test_a_stack_overflow_of_the_audio_thread_leaves_a_replay),
        cmocka_unit_test(test_each_thread_has_its_own_signal_stack),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
