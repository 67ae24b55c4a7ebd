/* fan_sampler.c -- converts one fan report per frame to one fan position per tick; see
 * fan_sampler.h. */
#include "platform/kiosk/fan_sampler.h"

#include "core/base/panic.h"

#define RETRY_NS 1000000000ull
#define RANGE_MAX_M 1000.0f

uint32_t fan_sampler_open(struct fan_sampler *hand, const struct hal_fan *device, uint64_t now_ns)
{
    const int result = device->ops->open(device->self);
    hand->retry_ns = now_ns + RETRY_NS;
    hand->link = result == HAL_OK           ? POI_SOURCE_LIVE
                 : result == HAL_ERR_ABSENT ? POI_SOURCE_ABSENT
                                            : POI_SOURCE_LOST;
    return hand->link == POI_SOURCE_LOST;
}

/* Returns 1 if all values are in range, otherwise 0. A comparison with NaN is false, so that NaN is
 * out of range. */
static int is_sane(const struct shade_input *shade)
{
    return f_abs(shade->x_m) <= RANGE_MAX_M && f_abs(shade->z_m) <= RANGE_MAX_M &&
           f_abs(shade->radius_m) <= RANGE_MAX_M;
}

uint32_t fan_sampler_sample(struct fan_sampler *hand, const struct hal_fan *device, uint64_t now_ns)
{
    struct shade_input reading = { 0 };
    uint32_t faults = 0;
    if (hand->link == POI_SOURCE_LOST && now_ns >= hand->retry_ns) {
        faults += fan_sampler_open(hand, device, now_ns);
    }
    if (hand->link != POI_SOURCE_LIVE) {
        return faults;
    }
    const int result = device->ops->poll(device->self, &reading);
    if (result == HAL_OK && is_sane(&reading)) {
        hand->to = reading;
        return faults;
    }
    if (result == HAL_ERR_GONE) {
        hand->link = POI_SOURCE_LOST;
        hand->retry_ns = now_ns + RETRY_NS;
        hand->to = (struct shade_input){ 0 };
    }
    return faults + (result != HAL_ERR_BUSY && result != HAL_ERR_ABSENT);
}

struct shade_input fan_sampler_at(const struct fan_sampler *hand, uint32_t index,
                                  uint32_t tick_count)
{
    CORE_ASSERT(index < tick_count);
    struct shade_input at = hand->to;
    const float t = (float)(index + 1) / (float)tick_count;
    if (at.present && hand->from.present && index + 1 < tick_count) {
        at.x_m = f_lerp(hand->from.x_m, at.x_m, t);
        at.z_m = f_lerp(hand->from.z_m, at.z_m, t);
        at.radius_m = f_lerp(hand->from.radius_m, at.radius_m, t);
    }
    return at;
}

void fan_sampler_end(struct fan_sampler *hand)
{
    hand->from = hand->to;
}
