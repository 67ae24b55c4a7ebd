/* coin_mech.c -- implements coin detection: measures the width of a pulse, and classifies the pulse
 * after the gap. */
#include "drivers/gpio/coin_mech.h"

struct coin_mech coin_mech_begin(uint64_t width_min_ns, uint64_t width_max_ns, bool active,
                                 uint64_t now_ns)
{
    return (struct coin_mech){
        .width_min_ns = width_min_ns,
        .width_max_ns = width_max_ns,
        .begin_ns = now_ns,
        .state = active ? COIN_FALLS : COIN_IDLE,
        .spoilt = active,
    };
}

static void coin_mech_classify(struct coin_mech *mech)
{
    const uint64_t width_ns = mech->end_ns - mech->begin_ns;
    if (!mech->spoilt && !mech->sticks) {
        if (width_ns < mech->width_min_ns) {
            mech->too_short++;
        } else {
            mech->coins++;
            mech->width_ns = width_ns;
        }
    }
    mech->state = COIN_IDLE;
    mech->spoilt = mech->sticks = false;
}

uint64_t coin_mech_due_ns(const struct coin_mech *mech)
{
    switch (mech->state) {
    case COIN_FALLS:
        return mech->sticks ? UINT64_MAX : mech->begin_ns + mech->width_max_ns + 1u;
    case COIN_FELL:
        return mech->end_ns + COIN_GAP_NS;
    default:
        return UINT64_MAX;
    }
}

void coin_mech_settle(struct coin_mech *mech, uint64_t now_ns)
{
    if (now_ns < coin_mech_due_ns(mech)) {
        return;
    }
    if (mech->state == COIN_FELL) {
        coin_mech_classify(mech);
    } else {
        mech->sticks = true;
        mech->stuck++;
    }
}

void coin_mech_edge(struct coin_mech *mech, uint64_t time_ns, bool active)
{
    coin_mech_settle(mech, time_ns);
    if (active && mech->state == COIN_IDLE) {
        mech->begin_ns = time_ns;
    }
    if (active) {
        mech->state = COIN_FALLS; /* The previous pulse continues if its end is less than
                                     COIN_GAP_NS ago. */
    } else if (mech->state == COIN_FALLS) {
        mech->state = COIN_FELL;
        mech->end_ns = time_ns;
    }
}

void coin_mech_lose(struct coin_mech *mech)
{
    if (mech->state == COIN_FELL) {
        coin_mech_classify(mech);
        return;
    }
    mech->cut += mech->state == COIN_FALLS && !mech->spoilt && !mech->sticks;
    mech->state = COIN_IDLE;
    mech->spoilt = mech->sticks = false;
}
