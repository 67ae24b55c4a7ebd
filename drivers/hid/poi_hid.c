/* poi_hid.c -- decodes the reports of a HID port for the frame loop. */
#include "drivers/hid/poi_hid.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "drivers/hid/poi_report.h"

/* Largest number of reports in one frame: a full queue and the newest report. */
#define HEARD_MAX (HID_REPORTS_MAX + 1u)

void poi_hid_init(struct poi_hid *poi, struct hid_port port, struct hal_clock clock,
                  struct hid_mapper mapper, const struct view *view)
{
    CORE_ASSERT(port.ops);
    CORE_ASSERT(clock.ops);
    memset(poi, 0, sizeof *poi);
    poi->port = port;
    poi->clock = clock;
    poi->mapper = mapper;
    poi->view = *view;
    snprintf(poi->text, sizeof poi->text, "controller not opened yet");
}

void poi_hid_set_observer(struct poi_hid *poi, struct hid_watch watch)
{
    poi->watch = watch;
}

/* ---- Attached controller -------------------------------------------------------------------- */

int poi_hid_remap(struct poi_hid *poi, const struct hid_mapping *map)
{
    static const char *const sources[] = {
        [HID_MAPPING_NONE] = "cannot be a poi as it is: learn it in the operator's menu",
        [HID_MAPPING_OWN] = "our own poi",
        [HID_MAPPING_KNOWN] = "a known controller",
        [HID_MAPPING_AUTO] = "played by what it offers",
        [HID_MAPPING_LEARNED] = "played as learned",
    };
    const struct hid_device_info *face = &poi->face;
    const struct hid_identity *who = &face->identity;
    const char *name = who->name[0] ? who->name : "controller";
    struct hid_mapping chosen;
    if (!poi->is_open) {
        return 0;
    }
    if (map) {
        chosen = *map;
    } else {
        /* The memory of poi->hand.descriptor is used only as scratch memory, because
         * hid_pose_decoder_init() parses the descriptor again. */
        struct hid_descriptor *descriptor = &poi->hand.descriptor;
        const uint32_t size =
            face->descriptor_size < HID_DESCRIPTOR_MAX ? face->descriptor_size : HID_DESCRIPTOR_MAX;
        hid_descriptor_read(descriptor, face->descriptor, size);
        if (poi->mapper.choose) {
            poi->mapper.choose(poi->mapper.self, face, descriptor, &chosen);
        } else {
            hid_mapping_choose(&chosen, who, descriptor);
        }
    }
    CORE_ASSERT(chosen.source <= HID_MAPPING_LEARNED);
    poi->plays = hid_pose_decoder_init(&poi->hand, face, &chosen, &poi->view) == 0;
    snprintf(poi->text, sizeof poi->text, "%04x:%04x %.*s%s%.24s: %s", who->vendor, who->product,
             (int)printable_fit(name, 40), name, who->port[0] ? " at port " : "", who->port,
             sources[poi->plays ? chosen.source : HID_MAPPING_NONE]);
    return poi->plays;
}

static int poi_hid_open(void *self)
{
    struct poi_hid *poi = self;
    const int result = poi->port.ops->open(poi->port.self, &poi->face);
    poi->is_open = result == HAL_OK;
    poi->plays = 0;
    if (!poi->is_open) {
        snprintf(poi->text, sizeof poi->text, "%s", poi->port.ops->describe(poi->port.self));
        return result;
    }
    poi_hid_remap(poi, NULL);
    return HAL_OK;
}

/* ---- Samples of the pose -------------------------------------------------------------------- */

/* The caller's sample buffer for one poll. */
struct basket {
    struct poi_sample *out;
    uint32_t count, max;
};

/* Appends a sample. If the buffer is full, the sample replaces the last sample, because the newest
 * pose must arrive. */
static void poi_hid_add_sample(struct basket *basket, const struct poi_sample *sample)
{
    CORE_ASSERT(basket->max > 0);
    CORE_ASSERT(basket->count <= basket->max);
    basket->count -= basket->count == basket->max;
    basket->out[basket->count++] = *sample;
}

/* Decodes all queued reports even if `out` has room for fewer samples, because remaining reports
 * would delay the next frames. Reports that arrived before the controller was unplugged are still
 * returned; the next poll then returns HAL_ERR_GONE. */
static int poi_hid_poll(void *self, struct poi_sample *out, uint32_t max)
{
    CORE_ASSERT(out || max == 0);
    struct poi_hid *poi = self;
    struct basket basket = { .out = out, .max = max };
    struct poi_sample now;
    struct hid_raw raw;
    if (!poi->is_open) {
        return HAL_ERR_GONE;
    }
    for (uint32_t taken = 0; taken < HEARD_MAX; taken++) {
        const int result = poi->port.ops->take(poi->port.self, &raw);
        if (result == HAL_ERR_GONE) {
            poi->is_open = 0;
            snprintf(poi->text, sizeof poi->text, "%s", poi->port.ops->describe(poi->port.self));
            return basket.count > 0 ? (int)basket.count : HAL_ERR_GONE;
        }
        if (result <= 0) {
            break;
        }
        if (poi->watch.report) {
            poi->watch.report(poi->watch.self, &raw);
        }
        if (poi->plays && hid_pose_decoder_report(&poi->hand, &raw) &&
            hid_pose_decoder_sample(&poi->hand, raw.time_ns, &now)) {
            now.was_stamped = 1;
            poi_hid_add_sample(&basket, &now);
        }
    }
    /* The pose of a pointer or a stick also changes between reports. Therefore it is sampled in
     * each poll, even if no report has arrived. An absolute pose is sampled only with its
     * reports. */
    const int goes_on = poi->plays && poi->hand.map.style != HID_STYLE_POSE;
    if (goes_on && hid_pose_decoder_sample(&poi->hand, hal_now_ns(poi->clock), &now)) {
        poi_hid_add_sample(&basket, &now);
    }
    return (int)basket.count;
}

static int poi_hid_set_force(void *self, const struct poi_force *force)
{
    struct poi_hid *poi = self;
    uint8_t bytes[POI_FEEL_SIZE];
    if (!poi->is_open || !poi->plays || !poi->hand.map.feels) {
        return HAL_ERR_ABSENT;
    }
    poi_feel_encode(force, poi->feel_sequence, bytes);
    const int result = poi->port.ops->send(poi->port.self, bytes, sizeof bytes);
    if (result == HAL_OK) {
        poi->feel_sequence++;
    }
    return result;
}

static void poi_hid_set_view(void *self, const struct view *view,
                             const struct display_settings *display_settings)
{
    struct poi_hid *poi = self;
    (void)display_settings; /* Unused, because the pose refers to the water and not to the
                               screen. */
    poi->view = *view;
    hid_pose_decoder_set_view(&poi->hand, view);
}

static const char *poi_hid_describe(void *self)
{
    const struct poi_hid *poi = self;
    return poi->text;
}

/* ---- Fan and buttons ------------------------------------------------------------------------ */

static int poi_hid_fan_open(void *self)
{
    (void)self;
    return HAL_OK; /* A controller without a fan button never activates the fan. */
}

static int poi_hid_fan_poll(void *self, struct shade_input *out)
{
    struct poi_hid *poi = self;
    *out = poi->is_open && poi->plays ? hid_pose_decoder_fan(&poi->hand, hal_now_ns(poi->clock))
                                      : (struct shade_input){ 0 };
    return HAL_OK;
}

static const char *poi_hid_fan_describe(void *self)
{
    (void)self;
    return "the controller's fan button";
}

static int poi_hid_buttons_poll(void *self, struct button_sample *out)
{
    struct poi_hid *poi = self;
    *out = (struct button_sample){ 0 };
    if (poi->is_open && poi->plays) {
        hid_pose_decoder_buttons(&poi->hand, out);
    }
    return HAL_OK;
}

static const char *buttons_describe(void *self)
{
    const struct poi_hid *poi = self;
    return poi->is_open && poi->plays ? "the controller's own buttons" : "";
}

struct hal_poi poi_hid_device(struct poi_hid *poi)
{
    static const struct hal_poi_ops ops = {
        .open = poi_hid_open,
        .poll = poi_hid_poll,
        .set_force = poi_hid_set_force,
        .set_view = poi_hid_set_view,
        .describe = poi_hid_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = poi };
}

struct hal_fan poi_hid_fan(struct poi_hid *poi)
{
    static const struct hal_fan_ops ops = {
        .open = poi_hid_fan_open,
        .poll = poi_hid_fan_poll,
        .describe = poi_hid_fan_describe,
    };
    return (struct hal_fan){ .ops = &ops, .self = poi };
}

struct hal_buttons poi_hid_buttons(struct poi_hid *poi)
{
    static const struct hal_buttons_ops ops = {
        .poll = poi_hid_buttons_poll,
        .describe = buttons_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = poi };
}
