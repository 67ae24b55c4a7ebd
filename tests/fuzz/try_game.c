/* try_game.c -- implementation of try_game.h: starts a game for a fuzz target. */
#include "tests/fuzz/try_game.h"

#include "core/base/panic.h"
#include "tests/fuzz/trap.h"

#include <stdio.h>
#include <string.h>

struct core try_game_core;

/* Ends the process after a failed assertion of the core, so that the fuzzer reports a crash. */
_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "panic: %s:%d: %s\n", file, line, condition);
    __builtin_trap();
}

int try_game(const struct core_config *config, uint32_t ticks)
{
    static struct output output;
    static struct scene scene;
    const struct input input = { 0 };
    memset(&output, 0, sizeof output);
    if (core_init(&try_game_core, config) != CORE_OK) {
        return 0;
    }
    for (uint32_t i = 0; i < ticks; i++) {
        output.sound_count = 0;
        core_tick(&try_game_core, &input, &output);
    }
    core_scene(&try_game_core, &scene);
    return 1;
}

void try_game_persistent(const struct persistent_state *memory, uint32_t ticks)
{
    static struct core_config config;
    memset(&config, 0, sizeof config);
    config.persistent = *memory;
    /* Uses one fish, because these targets test stored data, and simulating more fish would take
     * longer. */
    config.fish_count = 1;
    settings_sanitize(&config.persistent.settings);
    HOLD(try_game(&config, ticks));
}
