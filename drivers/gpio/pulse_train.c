/* pulse_train.c -- implements the sequence of pulses and pauses. */
#include "drivers/gpio/pulse_train.h"

void pulse_train_add(struct pulse_train *train, uint32_t count)
{
    const uint32_t room = UINT32_MAX - train->left;
    train->left += count < room ? count : room;
}

uint64_t pulse_train_due_ns(const struct pulse_train *train)
{
    return train->on || train->left > 0 ? train->until_ns : UINT64_MAX;
}

bool pulse_train_at(struct pulse_train *train, uint64_t now_ns)
{
    if (now_ns < pulse_train_due_ns(train)) {
        return train->on;
    }
    train->on = !train->on;
    train->left -= train->on;
    train->until_ns = now_ns + (train->on ? train->on_ns : train->off_ns);
    return train->on;
}
