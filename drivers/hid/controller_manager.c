/* controller_manager.c -- executes the operator's controller commands and reports the device
 * list. */
#include "drivers/hid/controller_manager.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"

/* ---- Learning of a mapping ------------------------------------------------------------------ */

static struct poi_hid *learning_poi(const struct controller_manager *manager)
{
    CORE_ASSERT(manager->learn_slot <= POI_MAX);
    return manager->learn_slot < POI_MAX ? manager->poi[manager->learn_slot] : NULL;
}

static void record_report(void *self, const struct hid_raw *raw)
{
    struct controller_manager *manager = self;
    hid_learn_report(&manager->learn, raw);
}

static void reset_learning_slot(struct controller_manager *manager)
{
    CORE_ASSERT(manager->learn_slot <= POI_MAX);
    struct poi_hid *poi = learning_poi(manager);
    if (poi) {
        poi->watch.report = NULL;
    }
    manager->learn_slot = POI_MAX;
    manager->learn_waits = manager->keeps = manager->writes = false;
}

static void fail_learning(struct controller_manager *manager)
{
    reset_learning_slot(manager);
    manager->learn.step = LEARN_FAILED;
}

/* Selects the controller of `row` to play, or releases it if `plays` is false. Returns the result
 * of the device list's function choose() (hid_device_list.h). */
static int choose_row(struct controller_manager *manager, uint32_t row, bool plays)
{
    return manager->device_list.ops->choose(manager->device_list.self, row, plays);
}

static bool is_same_device(const struct hid_identity *one, const struct hid_identity *other)
{
    return one->vendor == other->vendor && one->product == other->product &&
           strcmp(one->serial, other->serial) == 0;
}

/* Releases a controller that was selected only for learning and whose mapping was not kept. If the
 * device list is busy, `releases_at_end` stays true and the next poll retries. */
static void release_learned_controller(struct controller_manager *manager)
{
    const struct hid_row *row = &manager->row[manager->learn_row];
    CORE_ASSERT(manager->learn_row < CONTROLLER_MAX);
    manager->releases_at_end = manager->releases_at_end &&
                               is_same_device(&row->identity, &manager->learn_identity) &&
                               choose_row(manager, manager->learn_row, false) == HAL_ERR_BUSY;
}

/* Ends learning. The controller continues to play with `map`. If `map` is null, the controller
 * plays with the mapping that it has without learning. */
static void stop_learning(struct controller_manager *manager, const struct hid_mapping *map)
{
    struct poi_hid *poi = learning_poi(manager);
    if (poi) {
        poi_hid_remap(poi, map);
    }
    reset_learning_slot(manager);
    manager->learn.step = LEARN_NONE;
}

static void end_learning(struct controller_manager *manager)
{
    const bool plays_on = manager->learn.step == LEARN_NOT_SAVED || manager->writes;
    stop_learning(manager, plays_on ? &manager->learn.map : NULL);
    release_learned_controller(manager);
}

static int begin_learning(struct controller_manager *manager, uint32_t row)
{
    /* A learning procedure that is in progress ends. If learning restarts with the same row,
     * `releases_at_end` keeps its value. */
    const bool again = manager->learn.step != LEARN_NONE && manager->learn_row == row;
    if (again) {
        stop_learning(manager, NULL);
    } else if (manager->learn.step != LEARN_NONE) {
        end_learning(manager);
    }
    CORE_ASSERT(row < CONTROLLER_MAX);
    manager->releases_at_end =
        manager->row[row].state == CONTROLLER_FREE || (again && manager->releases_at_end);
    manager->learn_row = (uint8_t)row;
    manager->learn_identity = manager->row[row].identity;
    const int result =
        manager->row[row].state == CONTROLLER_ACTIVE ? HAL_OK : choose_row(manager, row, true);
    if (result != HAL_OK) {
        manager->releases_at_end = false;
        fail_learning(manager);
        return result;
    }
    /* The menu shows "keep still" until the controller is attached. */
    manager->learn.step = LEARN_REST;
    manager->learn.report_count = 0;
    manager->learn_waits = true;
    return HAL_OK;
}

/* Starts recording when the frame loop has opened the controller's port. Opening takes up to one
 * second. */
static void begin_recording(struct controller_manager *manager)
{
    const struct hid_row *row = &manager->row[manager->learn_row];
    CORE_ASSERT(manager->learn_waits);
    CORE_ASSERT(manager->learn_slot == POI_MAX);
    struct poi_hid *poi = row->slot < POI_MAX ? manager->poi[row->slot] : NULL;
    if (row->state == CONTROLLER_DENIED || row->state == CONTROLLER_UNSUPPORTED ||
        row->state == CONTROLLER_NONE) {
        fail_learning(manager);
        return;
    }
    if (!poi || !poi->is_open || !is_same_device(&poi->face.identity, &row->identity) ||
        strcmp(poi->face.identity.port, row->identity.port) != 0) {
        return;
    }
    manager->learn_waits = false;
    manager->learn_slot = row->slot;
    /* The identity is copied again, because some devices report their serial number only after they
     * are opened. */
    manager->learn_identity = row->identity;
    hid_learn_begin(&manager->learn, &poi->face);
    if (manager->learn.step == LEARN_FAILED) {
        reset_learning_slot(manager);
        return;
    }
    poi->watch = (struct hid_watch){ .report = record_report, .self = manager };
}

static void next_step(struct controller_manager *manager)
{
    struct poi_hid *poi = learning_poi(manager);
    if (!poi) {
        return; /* The controller is not attached to a slot yet. Therefore there is no learning step
                   to finish. */
    }
    hid_learn_next(&manager->learn);
    if (manager->learn.step == LEARN_TRY) {
        poi->watch.report = NULL;
        if (!poi_hid_remap(poi, &manager->learn.map)) {
            poi_hid_remap(poi, NULL);
            fail_learning(manager);
        }
    } else if (manager->learn.step == LEARN_FAILED) {
        reset_learning_slot(manager);
    }
}

/* Ends learning only after the mapping file is on the memory card, so that the operator may then
 * switch off the kiosk without losing the mapping. */
static void watch_writing(struct controller_manager *manager)
{
    CORE_ASSERT(manager->writes);
    const int result = hid_mapping_store_result(manager->store);
    if (result == HAL_OK) {
        stop_learning(manager, &manager->learn.map);
    } else if (result != HAL_ERR_BUSY) {
        manager->writes = false;
        manager->learn.step = LEARN_NOT_SAVED;
    }
}

static int controller_manager_save_mapping(struct controller_manager *manager)
{
    CORE_ASSERT(manager->store);
    const struct poi_hid *poi = learning_poi(manager);
    if (!poi || (manager->learn.step != LEARN_TRY && manager->learn.step != LEARN_NOT_SAVED)) {
        return HAL_ERR_IO;
    }
    const int result =
        hid_mapping_store_put(manager->store, &poi->face.identity, &manager->learn.map);
    manager->learn.step = result == HAL_OK || result == HAL_ERR_BUSY ? LEARN_TRY : LEARN_NOT_SAVED;
    manager->releases_at_end = false;
    manager->keeps = result == HAL_ERR_BUSY;
    manager->writes = result == HAL_OK;
    if (manager->writes) {
        watch_writing(manager);
    }
    return result == HAL_ERR_BUSY ? HAL_OK : result;
}

/* ---- Commands ------------------------------------------------------------------------------- */

static int controller_manager_release(struct controller_manager *manager, uint32_t row)
{
    CORE_ASSERT(row < CONTROLLER_MAX);
    if (manager->learn.step != LEARN_NONE && manager->learn_row == row) {
        stop_learning(manager, NULL);
        manager->releases_at_end =
            /* release_learned_controller() need not release this row later, because choose_row()
             * releases it below. */
            false;
    }
    if (manager->row[row].state != CONTROLLER_NONE) {
        manager->forget_identity = manager->row[row].identity;
        manager->forgets =
            hid_mapping_store_forget(manager->store, &manager->forget_identity) == HAL_ERR_BUSY;
    }
    return choose_row(manager, row, false);
}

static int execute_command(void *self, const struct controller_command *order)
{
    struct controller_manager *manager = self;
    if (order->row >= CONTROLLER_MAX) {
        return HAL_ERR_ABSENT;
    }
    switch (order->kind) {
    case COMMAND_CHOOSE:
        manager->releases_at_end &= order->row != manager->learn_row;
        return choose_row(manager, order->row, true);
    case COMMAND_RELEASE:
        return controller_manager_release(manager, order->row);
    case COMMAND_LEARN:
        return begin_learning(manager, order->row);
    case COMMAND_LEARN_NEXT:
        next_step(manager);
        return HAL_OK;
    case COMMAND_LEARN_KEEP:
        return controller_manager_save_mapping(manager);
    case COMMAND_LEARN_END:
        end_learning(manager);
        return HAL_OK;
    default:
        return HAL_OK;
    }
}

/* ---- Polling of the device list ------------------------------------------------------------- */

/* Advances the learning of a mapping by one poll. Learning fails if the controller is unplugged,
 * because an incomplete recording cannot be used. */
static void watch_learning(struct controller_manager *manager)
{
    const struct poi_hid *poi = learning_poi(manager);
    CORE_ASSERT(!(manager->keeps && manager->writes));
    if (manager->learn_waits) {
        begin_recording(manager);
    } else if (poi && !poi->is_open && !manager->writes) {
        fail_learning(manager);
    }
    if (manager->keeps) {
        controller_manager_save_mapping(manager);
    } else if (manager->writes) {
        watch_writing(manager);
    }
    if (manager->releases_at_end && manager->learn.step == LEARN_NONE) {
        release_learned_controller(manager);
    }
}

static int poll_controllers(void *self, struct controller_status *out)
{
    struct controller_manager *manager = self;
    manager->device_list.ops->rows(manager->device_list.self, manager->row);
    watch_learning(manager);
    if (manager->forgets) {
        manager->forgets =
            hid_mapping_store_forget(manager->store, &manager->forget_identity) == HAL_ERR_BUSY;
    }
    memset(out, 0, sizeof *out);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        out->state[i] = manager->row[i].state;
    }
    out->learn_step = manager->learn.step;
    out->learn_row = manager->learn.step == LEARN_NONE ? 0u : manager->learn_row;
    out->learn_progress = manager->learn_waits ? 0u : hid_learn_progress(&manager->learn);
    return HAL_OK;
}

static const char *name_controller(void *self, uint32_t row)
{
    struct controller_manager *manager = self;
    if (row >= CONTROLLER_MAX || manager->row[row].state == CONTROLLER_NONE) {
        return "";
    }
    const struct hid_identity *who = &manager->row[row].identity;
    snprintf(manager->name, sizeof manager->name, "%04x:%04x %.*s%s%.9s", who->vendor, who->product,
             (int)printable_fit(who->name, 24), who->name, who->port[0] ? ", " : "", who->port);
    return manager->name;
}

static const char *describe_controllers(void *self)
{
    const struct controller_manager *manager = self;
    return manager->device_list.ops->describe(manager->device_list.self);
}

struct hal_controllers controller_manager_init(struct controller_manager *manager,
                                               struct hid_device_list device_list,
                                               struct hid_mapping_store *store,
                                               struct poi_hid *const pois[POI_MAX])
{
    static const struct hal_controllers_ops ops = {
        .poll = poll_controllers,
        .name = name_controller,
        .command = execute_command,
        .describe = describe_controllers,
    };
    CORE_ASSERT(device_list.ops);
    memset(manager, 0, sizeof *manager);
    manager->device_list = device_list;
    manager->store = store;
    manager->learn_slot = POI_MAX;
    memcpy(manager->poi, pois, sizeof manager->poi);
    return (struct hal_controllers){ .ops = &ops, .self = manager };
}
