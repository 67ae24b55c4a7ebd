/* panic.h -- what the programs do when the core finds itself broken. */
#ifndef KINGYO_PLATFORM_PANIC_H
#define KINGYO_PLATFORM_PANIC_H

/* `last_wish` is called once before the program stops, to bring a recording to its end. */
void panic_prepare(void (*last_wish)(void *self), void *self);

#endif
