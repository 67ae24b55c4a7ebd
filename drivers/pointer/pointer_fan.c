/* pointer_fan.c -- moves the fan over the water and back. */
#include "drivers/pointer/pointer_fan.h"

/* Vertical position of the idle fan in normalized device coordinates: below the window's lower
 * edge, in front of the player. */
#define REST_NDC_Y (-2.2f)

void pointer_fan_init(struct pointer_fan *fan, const struct view *view)
{
    *fan = (struct pointer_fan){ .view = *view, .aspect = 16.0f / 9.0f };
}

static void swing_to_time(struct pointer_fan *fan, uint64_t time_ns)
{
    if (time_ns <= fan->time_ns) {
        return;
    }
    const float dt_s = fan->time_ns > 0 ? (float)(time_ns - fan->time_ns) * 1e-9f : 0.0f;
    const float step = dt_s / POINTER_FAN_SWING_S;
    fan->swing = f_clamp(fan->swing + (fan->held ? step : -step), 0.0f, 1.0f);
    fan->time_ns = time_ns;
}

int pointer_fan_report(struct pointer_fan *fan, const struct pointer_report *report)
{
    if (!pointer_report_is_usable(report)) {
        return 0;
    }
    swing_to_time(fan, report->time_ns);
    fan->held = (report->buttons & POINTER_FAN) != 0;
    if (fan->held) {
        const float width = (float)report->width_px;
        const float height = (float)report->height_px;
        fan->aspect = width / height;
        fan->ndc_x = f_clamp(2.0f * report->x_px / width - 1.0f, -1.0f, 1.0f);
        fan->ndc_y = f_clamp(1.0f - 2.0f * report->y_px / height, -1.0f, 1.0f);
    }
    return 1;
}

struct shade_input pointer_fan_shade(struct pointer_fan *fan, uint64_t time_ns)
{
    swing_to_time(fan, time_ns);
    const float share = f_smoothstep(0.0f, 1.0f, fan->swing);
    const vec3 there_m = view_point_on_plane(&fan->view, fan->aspect, fan->ndc_x, fan->ndc_y, 0.0f);
    const vec3 rest_m =
        view_point_on_plane(&fan->view, fan->aspect, 0.6f * fan->ndc_x, REST_NDC_Y, 0.0f);
    const vec3 at_m = v3_lerp(rest_m, there_m, share);
    return (struct shade_input){
        .present = fan->swing > 0.0f,
        .x_m = at_m.x,
        .z_m = at_m.z,
        .radius_m = POINTER_FAN_RADIUS_M,
    };
}
