/* shades.c -- converts one report a frame to one position a tick. */
#include "platform/kiosk/shades.h"

#include "core/base/panic.h"

#define RETRY_NS 1000000000ull
#define RANGE_MAX_M 1000.0f

uint32_t shade_hand_open(struct shade_hand *hand, const struct hal_shade *device, uint64_t now_ns)
{
    const int result = device->ops->open(device->self);
    hand->retry_ns = now_ns + RETRY_NS;
    hand->link = result == HAL_OK ? POI_LINK_LIVE
                 : result == HAL_ERR_NONE ? POI_LINK_ABSENT
                                          : POI_LINK_LOST;
    return hand->link == POI_LINK_LOST;
}

/* Returns 1 if the position is in range. NaN compares false and is therefore out of range. */
static int is_sane(const struct shade_input *shade)
{
    return f_abs(shade->x_m) <= RANGE_MAX_M && f_abs(shade->z_m) <= RANGE_MAX_M &&
           f_abs(shade->radius_m) <= RANGE_MAX_M;
}

uint32_t shade_hand_sample(struct shade_hand *hand, const struct hal_shade *device,
                           uint64_t now_ns)
{
    struct shade_input reading = { 0 };
    uint32_t faults = 0;
    if (hand->link == POI_LINK_LOST && now_ns >= hand->retry_ns) {
        faults += shade_hand_open(hand, device, now_ns);
    }
    if (hand->link != POI_LINK_LIVE) {
        return faults;
    }
    const int result = device->ops->poll(device->self, &reading);
    if (result == HAL_OK && is_sane(&reading)) {
        hand->to = reading;
        return faults;
    }
    if (result == HAL_ERR_GONE) {
        hand->link = POI_LINK_LOST;
        hand->retry_ns = now_ns + RETRY_NS;
        hand->to = (struct shade_input){ 0 };
    }
    return faults + (result != HAL_ERR_BUSY && result != HAL_ERR_NONE);
}

struct shade_input shade_hand_at(const struct shade_hand *hand, uint32_t index,
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

void shade_hand_end(struct shade_hand *hand)
{
    hand->from = hand->to;
}
