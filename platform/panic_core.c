/* panic_core.c -- defines core_panic(), which a failed assertion calls. The function has a file of
 * its own, because unit tests link another version of the function. */
#include <stdlib.h>

#include "core/base/panic.h"
#include "platform/os/panic.h"

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    struct panic_text text = { 0 };
    panic_put(&text, file);
    panic_put(&text, ":");
    panic_put_number(&text, (uint32_t)line);
    panic_put(&text, ": assertion failed: ");
    panic_put(&text, condition);
    panic_report(text.out);
    abort();
}
