/* saving.c -- offers data to the store and handles its errors; see saving.h. */
#include "platform/kiosk/saving.h"

#define RETRY_NS 1000000000ull /* Interval between two attempts after a failure. */

/* Returns 1 if the store accepted the data or no store exists, otherwise 0. After a failure, delays
 * the next attempt. */
static int is_settled(struct saving *saving, int result, uint64_t now_ns)
{
    if (hal_is_fault(result)) {
        saving->retry_ns = now_ns + RETRY_NS;
    }
    return result == HAL_OK || result == HAL_ERR_ABSENT;
}

uint32_t saving_put_entries(struct saving *saving, const struct hal_ledger *store,
                            const struct output *output, uint64_t now_ns)
{
    while (!saving_is_done(saving, output) && now_ns >= saving->retry_ns) {
        const uint32_t behind = output->entry_id - saving->accepted_id;
        saving->accepted_id += behind > LEDGER_RING ? behind - LEDGER_RING : 0u;
        const uint32_t place = (saving->accepted_id + 1u) % LEDGER_RING;
        const int result = store->ops->append(store->self, &output->entries[place]);
        if (!is_settled(saving, result, now_ns)) {
            return (uint32_t)hal_is_fault(result);
        }
        saving->accepted_id++;
    }
    return 0;
}

uint32_t saving_put_edit(struct saving *saving, const struct hal_edit_store *edits,
                         const struct output *output, uint64_t now_ns)
{
    if (output->edit.id == saving->accepted_edit_id || now_ns < saving->retry_ns) {
        return 0;
    }
    const int result = edits->ops->store(edits->self, &output->edit);
    if (is_settled(saving, result, now_ns)) {
        saving->accepted_edit_id = output->edit.id;
    }
    return (uint32_t)hal_is_fault(result);
}

uint32_t saving_refused(struct saving *saving, const struct hal_ledger *store)
{
    const uint32_t refused = store->ops->failed_count(store->self);
    const uint32_t fresh = refused - saving->refused_seen;
    saving->refused_seen = refused;
    return fresh;
}
