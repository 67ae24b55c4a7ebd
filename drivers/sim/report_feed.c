/* report_feed.c -- selects the next report of a simulated device and determines the faults of this
 * report. */
#include "drivers/sim/report_feed.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/base/rng.h"

struct report_feed report_feed_begin(struct hal_clock clock)
{
    CORE_ASSERT(clock.ops);
    return (struct report_feed){
        .clock = clock,
        .unplug_at = REPORT_FEED_NEVER,
        .jump_at = REPORT_FEED_NEVER,
    };
}

int report_feed_open(struct report_feed *feed)
{
    feed->open_count++;
    if (!feed->gone) {
        return 0;
    }
    if (hal_now_ns(feed->clock) < feed->replug_ns) {
        return HAL_ERR_GONE;
    }
    feed->gone = false;
    feed->unplug_at = REPORT_FEED_NEVER;
    return 1;
}

int report_feed_take(struct report_feed *feed, const void *reports, size_t size,
                     struct report_fault *out)
{
    const uint32_t index = feed->next;
    const uint64_t now_ns = hal_now_ns(feed->clock);
    uint64_t time_ns;
    CORE_ASSERT(index <= feed->count && (reports || feed->count == 0));
    if (!feed->gone && now_ns >= feed->silent_from_ns && now_ns < feed->silent_to_ns) {
        return HAL_ERR_BUSY;
    }
    if (feed->gone || index == feed->count) {
        return feed->gone ? HAL_ERR_GONE : 0;
    }
    memcpy(&time_ns, (const uint8_t *)reports + index * size, sizeof time_ns);
    if (time_ns > now_ns) {
        return 0;
    }
    if (index >= feed->unplug_at) {
        feed->gone = true;
        return HAL_ERR_GONE;
    }
    *out = (struct report_fault){
        .index = index,
        .copies = feed->double_every > 0 && index % feed->double_every == 0 ? 2u : 1u,
        .jumps = index == feed->jump_at,
        .is_random = index >= feed->random_from && index < feed->random_to,
    };
    feed->next++;
    return 1;
}

uint32_t report_feed_random(uint32_t stream, uint32_t index, uint32_t what)
{
    return rng_u32((struct rng_key){ stream, index, what, RNG_TEST });
}

float report_feed_random_float(uint32_t stream, uint32_t index, uint32_t what)
{
    const uint32_t bits = report_feed_random(stream, index, what);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

int report_feed_fan_open(void *self)
{
    const struct report_feed *feed = self;
    return feed->gone ? HAL_ERR_GONE : HAL_OK;
}
