/* output_lines.c -- sends changed outputs to the driver. A busy driver is retried in the next
 * frame, and a failed driver after one second. An output that the cabinet does not have counts as
 * set. */
#include "platform/kiosk/output_lines.h"

#define RETRY_NS 1000000000ull

/* Returns 1 if the driver accepted the request or has no such output, otherwise 0. After a fault,
 * delays the next attempt. */
static int is_settled(struct output_lines *switches, enum hal_switch which, int result,
                      uint64_t now_ns)
{
    if (hal_is_fault(result)) {
        switches->retry_ns[which] = now_ns + RETRY_NS;
    }
    return result >= 0 || result == HAL_ERR_ABSENT;
}

static uint32_t output_lines_set(struct output_lines *switches, const struct hal_switches *device,
                                 enum hal_switch which, uint8_t active, uint64_t now_ns)
{
    const uint32_t bit = 1u << which;
    if (!(switches->active & bit) == !active || now_ns < switches->retry_ns[which]) {
        return 0;
    }
    const int result = device->ops->set(device->self, which, active != 0);
    if (is_settled(switches, which, result, now_ns)) {
        switches->active ^= bit;
    }
    return (uint32_t)hal_is_fault(result);
}

/* Sends one pulse for each increase of `wanted` by 1 since the last accepted request. Returns 1 on
 * a fault, otherwise 0. */
static uint32_t pulse(struct output_lines *switches, const struct hal_switches *device,
                      enum hal_switch which, uint32_t wanted, uint64_t now_ns)
{
    const uint32_t count = wanted - switches->given[which];
    if (count == 0 || now_ns < switches->retry_ns[which]) {
        return 0;
    }
    const int result = device->ops->pulse(device->self, which, count);
    if (is_settled(switches, which, result, now_ns)) {
        switches->given[which] = wanted;
    }
    return (uint32_t)hal_is_fault(result);
}

uint32_t output_lines_put(struct output_lines *switches, const struct hal_switches *device,
                          const struct output *output, uint64_t now_ns)
{
    return output_lines_set(switches, device, HAL_START_LAMP, output->start_lamp, now_ns) +
           output_lines_set(switches, device, HAL_COIN_LOCKOUT, output->coin_lockout, now_ns) +
           pulse(switches, device, HAL_COIN_COUNTER, output->coins_counted, now_ns) +
           pulse(switches, device, HAL_TICKET, output->tickets, now_ns);
}

uint32_t output_lines_are_done(const struct output_lines *switches,
                               const struct hal_switches *device, enum hal_switch which)
{
    return switches->given[which] - device->ops->pending(device->self, which);
}
