/* poi_hid.c -- takes the reports of a HID port and passes them to the decoder, for the frame
 * loop. */
#include "drivers/hid/poi_hid.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "drivers/hid/poi_report.h"

/* Largest number of reports in one frame: a full queue and the newest report. */
#define FRAME_REPORTS_MAX (HID_REPORTS_MAX + 1u)

void poi_hid_init(struct poi_hid *poi, struct hid_port *port, struct hal_clock clock,
                  struct hid_mapper mapper, const struct view *view)
{
    CORE_ASSERT(port);
    CORE_ASSERT(clock.ops);
    memset(poi, 0, sizeof *poi);
    poi->port = port;
    poi->clock = clock;
    poi->mapper = mapper;
    poi->view = *view;
    snprintf(poi->text, sizeof poi->text, "controller not opened yet");
}

/* ---- Attached controller -------------------------------------------------------------------- */

bool poi_hid_remap(struct poi_hid *poi, const struct hid_mapping *map)
{
    static const char *const sources[] = {
        [HID_MAPPING_NONE] = "cannot be a poi as it is: learn it in the operator's menu",
        [HID_MAPPING_OWN] = "our own poi",
        [HID_MAPPING_KNOWN] = "a known controller",
        [HID_MAPPING_AUTO] = "plays by its report descriptor",
        [HID_MAPPING_LEARNED] = "plays by its learned mapping",
    };
    const struct hid_device_info *face = &poi->face;
    const struct hid_identity *who = &face->identity;
    const char *name = who->name[0] ? who->name : "controller";
    struct hid_mapping chosen;
    if (!poi->is_open) {
        return false;
    }
    if (map) {
        chosen = *map;
    } else {
        /* The memory of poi->decoder.descriptor is used only as scratch memory, because
         * hid_pose_decoder_init() parses the descriptor again. */
        struct hid_descriptor *descriptor = &poi->decoder.descriptor;
        hid_descriptor_read(descriptor, face->descriptor, face->descriptor_size);
        if (poi->mapper.choose) {
            poi->mapper.choose(poi->mapper.self, face, descriptor, &chosen);
        } else {
            hid_mapping_choose(&chosen, who, descriptor);
        }
    }
    CORE_ASSERT(chosen.source <= HID_MAPPING_LEARNED);
    poi->plays = hid_pose_decoder_init(&poi->decoder, face, &chosen, &poi->view) == 0;
    snprintf(poi->text, sizeof poi->text, "%04x:%04x %.*s%s%.24s: %s", who->vendor, who->product,
             (int)printable_fit(name, 40), name, who->port[0] ? " at port " : "", who->port,
             sources[poi->plays ? chosen.source : HID_MAPPING_NONE]);
    return poi->plays;
}

/* Closes the device. Returns `result`, which is the error of the port. */
static int close_device(struct poi_hid *poi, int result)
{
    CORE_ASSERT(result < 0);
    poi->is_open = poi->plays = false;
    snprintf(poi->text, sizeof poi->text, "no controller on USB yet");
    return result;
}

static int poi_hid_open(void *self)
{
    struct poi_hid *poi = self;
    const int result = hid_port_open(poi->port, &poi->face);
    if (result != HAL_OK) {
        return close_device(poi, result);
    }
    poi->is_open = true;
    poi_hid_remap(poi, NULL);
    return HAL_OK;
}

/* ---- Samples of the pose -------------------------------------------------------------------- */

/* Appends the pose at `time_ns` to the `count` samples in `out`. If `out` is full, the pose
 * replaces the last sample, because the newest pose must arrive. Returns the new number of samples,
 * at most `max`. */
static uint32_t add_sample(struct poi_hid *poi, uint64_t time_ns, bool was_stamped,
                           struct poi_sample *out, uint32_t max, uint32_t count)
{
    CORE_ASSERT(count <= max);
    struct poi_sample *sample = &out[count < max ? count : max - 1u];
    if (!hid_pose_decoder_sample(&poi->decoder, time_ns, sample)) {
        return count;
    }
    sample->was_stamped = was_stamped;
    return count < max ? count + 1u : max;
}

/* Decodes all queued reports even if `out` has room for fewer samples, because remaining reports
 * would delay the next frames. Reports that arrived before the controller was unplugged are still
 * returned. The next poll then returns HAL_ERR_GONE. */
static int poi_hid_poll(void *self, struct poi_sample *out, uint32_t max)
{
    CORE_ASSERT(out && max > 0);
    struct poi_hid *poi = self;
    struct hid_raw raw;
    uint32_t count = 0;
    if (!poi->is_open) {
        return HAL_ERR_GONE;
    }
    for (uint32_t taken = 0; taken < FRAME_REPORTS_MAX; taken++) {
        const int result = hid_port_take(poi->port, &raw);
        if (result < 0) {
            close_device(poi, result);
            return count > 0 ? (int)count : HAL_ERR_GONE;
        }
        if (result == 0) {
            break;
        }
        if (poi->watch.report) {
            poi->watch.report(poi->watch.self, &raw);
        }
        if (poi->plays && hid_pose_decoder_report(&poi->decoder, &raw)) {
            count = add_sample(poi, raw.time_ns, true, out, max, count);
        }
    }
    /* The pose of a pointer or a stick also changes between reports. Therefore the pose is sampled
     * in each poll, even if no report has arrived. An absolute pose is sampled only with its
     * reports. */
    if (poi->plays && poi->decoder.map.style != HID_STYLE_POSE) {
        count = add_sample(poi, hal_now_ns(poi->clock), false, out, max, count);
    }
    return (int)count;
}

static int poi_hid_set_force(void *self, const struct poi_force *force)
{
    struct poi_hid *poi = self;
    uint8_t bytes[POI_FORCE_SIZE];
    if (!poi->plays || !poi->decoder.map.feels) {
        return HAL_ERR_ABSENT;
    }
    poi_force_encode(force, poi->feel_sequence, bytes);
    const int result = hid_port_send(poi->port, bytes, sizeof bytes);
    if (result == HAL_OK) {
        poi->feel_sequence++;
    }
    return result;
}

static void poi_hid_set_view(void *self, const struct view *view,
                             const struct display_settings *display_settings, bool scoops)
{
    struct poi_hid *poi = self;
    /* `display_settings` is unused, because the pose refers to the water and not to the screen. */
    (void)display_settings;
    poi->view = *view;
    hid_pose_decoder_set_view(&poi->decoder, view);
    poi->decoder.pointer.dip.scoops = poi->decoder.fly.dip.scoops = scoops;
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
    *out = poi->plays ? hid_pose_decoder_fan(&poi->decoder, hal_now_ns(poi->clock))
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
    if (poi->plays) {
        hid_pose_decoder_buttons(&poi->decoder, out);
    }
    return HAL_OK;
}

static const char *buttons_describe(void *self)
{
    const struct poi_hid *poi = self;
    return poi->plays ? "the controller's own buttons" : "";
}

struct hal_controller_devices poi_hid_devices(struct poi_hid *poi_hid)
{
    static const struct hal_poi_ops poi = {
        .open = poi_hid_open,
        .poll = poi_hid_poll,
        .set_force = poi_hid_set_force,
        .set_view = poi_hid_set_view,
        .describe = poi_hid_describe,
    };
    static const struct hal_fan_ops fan = {
        .open = poi_hid_fan_open,
        .poll = poi_hid_fan_poll,
        .describe = poi_hid_fan_describe,
    };
    static const struct hal_buttons_ops buttons = {
        .poll = poi_hid_buttons_poll,
        .describe = buttons_describe,
    };
    return (struct hal_controller_devices){
        .poi = { &poi, poi_hid },
        .fan = { &fan, poi_hid },
        .buttons = { &buttons, poi_hid },
    };
}
