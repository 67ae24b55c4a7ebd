/* pointer.h -- a simulated pointer (mouse) over the window of the kiosk. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_POINTER_H
#define KINGYO_TESTS_UNIT_SUPPORT_POINTER_H

#include "core/tank/preset.h"
#include "drivers/pointer/pointer_poi.h"

#define MS 1000000ull
#define WIDTH 1280u
#define HEIGHT 720u

/* Returns the camera view of the festival's tank. */
static inline const struct view *festival_view(void)
{
    return &tank_preset(TANK_PRESET_FESTIVAL)->view;
}

/* Returns a pointer report with the time `ms` in milliseconds and a position in pixels. */
static inline struct pointer_report report(uint64_t ms, float x_px, float y_px, uint32_t buttons)
{
    return (struct pointer_report){
        .time_ns = ms * MS,
        .x_px = x_px,
        .y_px = y_px,
        .width_px = WIDTH,
        .height_px = HEIGHT,
        .buttons = buttons,
    };
}

/* Returns the point of the still water surface (y = 0) that is visible at a pixel. */
static inline vec3 on_water(float x_px, float y_px)
{
    return view_point_on_plane(festival_view(), (float)WIDTH / (float)HEIGHT,
                               2.0f * x_px / (float)WIDTH - 1.0f,
                               1.0f - 2.0f * y_px / (float)HEIGHT, 0.0f);
}

#endif
