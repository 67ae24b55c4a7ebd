/* panic.c -- one line, the recording, and out. Not through exit(): trust nothing else. */
#include "platform/panic.h"

#include <stdio.h>
#include <stdlib.h>

#include "core/base/panic.h"
#include "platform/say.h"

static void (*wish)(void *self);
static void *wish_self;

void panic_prepare(void (*last_wish)(void *self), void *self)
{
    wish = last_wish;
    wish_self = self;
}

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    say(SAY_CRITICAL, "panic: %s:%d: not so: %s", file, line, condition);
    if (wish) {
        void (*const last_wish)(void *self) = wish;
        wish = NULL; /* A panic in here must not come back. */
        last_wish(wish_self);
    }
    abort();
}
