/* storage_sim.c -- a card with moods. */
#include "drivers/storage_sim.h"

#include <string.h>

static int storage_sim_open(void *self)
{
    (void)self;
    return HAL_OK;
}

static int storage_sim_best_today(void *self, uint32_t out[MODE_COUNT])
{
    const struct storage_sim *sim = self;
    memcpy(out, sim->best_today, sizeof sim->best_today);
    return HAL_OK;
}

static int storage_sim_save(void *self, const struct round_record *record)
{
    struct storage_sim *sim = self;
    if (sim->busy_left > 0) {
        sim->busy_left--;
        sim->refused_count++;
        return HAL_ERR_BUSY;
    }
    if (sim->fail_left > 0) {
        sim->fail_left--;
        sim->refused_count++;
        return HAL_ERR_IO;
    }
    sim->record = *record;
    sim->accepted_count++;
    sim->polls_since = 0;
    return HAL_OK;
}

static uint32_t storage_sim_saved_id(void *self)
{
    struct storage_sim *sim = self;
    return sim->polls_since++ >= sim->delay_polls ? sim->record.id : 0;
}

/* As busy and as broken as for rounds. */
static int storage_sim_keep_edit(void *self, const struct edit_record *edit)
{
    struct storage_sim *sim = self;
    if (sim->busy_left > 0) {
        sim->busy_left--;
        return HAL_ERR_BUSY;
    }
    sim->edit_failed = sim->fail_left > 0;
    if (sim->edit_failed) {
        sim->fail_left--;
        return HAL_ERR_IO;
    }
    sim->edit = *edit;
    return HAL_OK;
}

static uint32_t storage_sim_kept_edit_id(void *self)
{
    const struct storage_sim *sim = self;
    return sim->edit.id;
}

static int storage_sim_refuses_edits(void *self)
{
    const struct storage_sim *sim = self;
    return sim->edit_failed;
}

static int storage_sim_is_well(void *self)
{
    return !storage_sim_refuses_edits(self);
}

static const char *storage_sim_describe(void *self)
{
    (void)self;
    return "simulated store";
}

static uint32_t storage_sim_refused_count(void *self)
{
    const struct storage_sim *sim = self;
    return sim->write_refused_count;
}

static uint32_t storage_sim_close(void *self)
{
    (void)self;
    return 0;
}

struct hal_storage storage_sim_device(struct storage_sim *sim)
{
    static const struct hal_storage_ops ops = {
        .open = storage_sim_open,
        .best_today = storage_sim_best_today,
        .save = storage_sim_save,
        .saved_id = storage_sim_saved_id,
        .keep_edit = storage_sim_keep_edit,
        .kept_edit_id = storage_sim_kept_edit_id,
        .refuses_edits = storage_sim_refuses_edits,
        .refused_count = storage_sim_refused_count,
        .is_well = storage_sim_is_well,
        .describe = storage_sim_describe,
        .close = storage_sim_close,
    };
    return (struct hal_storage){ .ops = &ops, .self = sim };
}
