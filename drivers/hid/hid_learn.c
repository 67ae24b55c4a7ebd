/* hid_learn.c -- records the lowest and the highest value of every field in every learning step. */
#include "drivers/hid/hid_learn.h"

#include <string.h>

#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "drivers/hid/hid_mapping_auto.h"

/* Minimum duration of the learning step LEARN_REST, measured from the first report. The progress of
 * the step reaches its maximum when REST_NS have passed and REST_REPORTS reports have arrived. */
#define REST_NS 1000000000ull
/* Minimum number of reports in the learning step LEARN_REST. */
#define REST_REPORTS 8u

/* ---- Fields of the controller --------------------------------------------------------------- */

static void begin_step(struct hid_learn *learn, enum learn_step step)
{
    CORE_ASSERT(step >= LEARN_REST && step <= LEARN_DIP);
    CORE_ASSERT(learn->field_count <= LEARN_FIELD_MAX);
    learn->step = (uint8_t)step;
    learn->report_count = 0;
    for (uint32_t i = 0; i < learn->field_count; i++) {
        struct learn_field *field = &learn->field[i];
        if (hid_mapping_infer_is_relative(hid_mapping_infer_group(learn, field))) {
            field->now = 0;
        }
        field->low[step] = field->high[step] = field->now;
    }
}

void hid_learn_begin(struct hid_learn *learn, const struct hid_device_info *face)
{
    CORE_ASSERT(face->descriptor_size <= HID_DESCRIPTOR_MAX);
    memset(learn, 0, sizeof *learn);
    learn->step = LEARN_FAILED;
    if (hid_descriptor_read(&learn->descriptor, face->descriptor, face->descriptor_size) !=
            HID_OK ||
        hid_mapping_has_keyboard(&learn->descriptor)) {
        return;
    }
    hid_mapping_choose(&learn->offered, &face->identity, &learn->descriptor);
    for (uint32_t i = 0; i < learn->descriptor.group_count; i++) {
        const struct hid_group *group = &learn->descriptor.group[i];
        const bool is_usable = !(group->flags & HID_CONSTANT) && (group->flags & HID_VARIABLE) &&
                               group->bit_size <= 32u &&
                               hid_mapping_auto_high(group) > group->logical_min;
        for (uint32_t j = 0; is_usable && j < group->count && learn->field_count < LEARN_FIELD_MAX;
             j++) {
            learn->field[learn->field_count++] =
                (struct learn_field){ .group = (uint16_t)i, .index = (uint16_t)j };
        }
    }
    if (learn->field_count > 0) {
        begin_step(learn, LEARN_REST);
    }
}

/* ---- Recording ------------------------------------------------------------------------------ */

static void record_field(struct hid_learn *learn, struct learn_field *field,
                         struct hid_report report)
{
    CORE_ASSERT(learn->step >= LEARN_REST);
    CORE_ASSERT(learn->step <= LEARN_DIP);
    const struct hid_group *group = hid_mapping_infer_group(learn, field);
    const int64_t value = hid_field_value(&learn->descriptor, group, field->index, report);
    const bool relative = hid_mapping_infer_is_relative(group);
    field->now = relative ? field->now + value : value;
    /* If a field was not reported before, its first value is taken as its rest value, because some
     * controllers report a field only when it changes. */
    if (!field->reported) {
        field->reported = true;
        field->rest_low = field->rest_high = relative ? 0 : value;
        field->low[learn->step] = field->high[learn->step] = field->rest_low;
    }
    if (learn->step == LEARN_REST && !relative) {
        field->rest_low = !field->rested || value < field->rest_low ? value : field->rest_low;
        field->rest_high = !field->rested || value > field->rest_high ? value : field->rest_high;
        field->rested = true;
    }
    int64_t *low = &field->low[learn->step], *high = &field->high[learn->step];
    *low = field->now < *low ? field->now : *low;
    *high = field->now > *high ? field->now : *high;
    CORE_ASSERT(*low <= *high);
}

static void record_key(struct hid_learn *learn, uint32_t group_index, hid_usage usage)
{
    CORE_ASSERT(group_index < learn->descriptor.group_count);
    const bool rested = learn->step != LEARN_DIP;
    CORE_ASSERT(learn->key_count <= LEARN_KEY_MAX);
    for (uint32_t i = 0; i < learn->key_count; i++) {
        if (learn->key[i].group == group_index && learn->key[i].usage == usage) {
            learn->key[i].rested |= rested;
            return;
        }
    }
    if (learn->key_count < LEARN_KEY_MAX) {
        learn->key[learn->key_count++] =
            (struct learn_key){ .group = (uint16_t)group_index, .rested = rested, .usage = usage };
    }
}

static void record_arrays(struct hid_learn *learn, int report_id, struct hid_report report)
{
    CORE_ASSERT(report_id >= 0 && report_id <= 255);
    const struct hid_descriptor *descriptor = &learn->descriptor;
    for (uint32_t i = 0; i < descriptor->group_count; i++) {
        const struct hid_group *group = &descriptor->group[i];
        if ((group->flags & (HID_VARIABLE | HID_CONSTANT)) || group->report_id != report_id ||
            group->bit_size > 32u || group->count > HID_ARRAY_MAX) {
            continue;
        }
        for (uint32_t j = 0; j < group->count; j++) {
            const hid_usage usage =
                hid_selected(descriptor, group, hid_field_value(descriptor, group, j, report));
            if (usage & 0xffffu) { /* Usage id 0 on any usage page means that no key is pressed. */
                record_key(learn, i, usage);
            }
        }
    }
}

void hid_learn_report(struct hid_learn *learn, const struct hid_raw *raw)
{
    const struct hid_report report = { .bytes = raw->bytes, .size = raw->size };
    if (learn->step < LEARN_REST || learn->step > LEARN_DIP || raw->size == 0 ||
        raw->size > HID_REPORT_MAX || !hid_report_is_whole(&learn->descriptor, report)) {
        return;
    }
    const int id = hid_report_id(&learn->descriptor, report);
    learn->begun_ns = learn->report_count == 0 ? raw->time_ns : learn->begun_ns;
    learn->now_ns = raw->time_ns;
    learn->report_count++;
    for (uint32_t i = 0; i < learn->field_count; i++) {
        if (hid_mapping_infer_group(learn, &learn->field[i])->report_id == id) {
            record_field(learn, &learn->field[i], report);
        }
    }
    record_arrays(learn, id, report);
}

/* ---- Steps of learning ---------------------------------------------------------------------- */

void hid_learn_next(struct hid_learn *learn)
{
    CORE_ASSERT(learn->field_count <= LEARN_FIELD_MAX);
    if (learn->step < LEARN_REST || learn->step > LEARN_DIP) {
        return;
    }
    for (uint32_t i = 0; i < learn->field_count; i++) {
        learn->field[i].end[learn->step] = learn->field[i].now;
    }
    if (learn->step < LEARN_DIP) {
        begin_step(learn, (enum learn_step)(learn->step + 1));
        return;
    }
    learn->step = hid_mapping_infer_map(learn) ? LEARN_TRY : LEARN_FAILED;
}

/* ---- Progress of the current step ----------------------------------------------------------- */

uint8_t hid_learn_progress(const struct hid_learn *learn)
{
    if (learn->step == LEARN_REST) {
        const float seconds = (float)(learn->now_ns - learn->begun_ns) / (float)REST_NS;
        const float reports = (float)learn->report_count / (float)REST_REPORTS;
        const float share = f_min(1.0f, f_min(seconds, reports));
        return learn->report_count == 0 ? 0 : (uint8_t)(255.0f * share);
    }
    return learn->step > LEARN_REST && learn->step <= LEARN_DIP
               ? (uint8_t)(255.0f * hid_mapping_infer_clarity(learn))
               : 0;
}
