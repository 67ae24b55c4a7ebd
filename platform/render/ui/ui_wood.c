/* ui_wood.c -- draws the wooden parts that hang in a festival stall: a bamboo pole, red cords, and
 * tags of cedar. */
#include "platform/render/ui/ui_primitives.h"

#define CEDAR 0xd9a667ffu
#define CEDAR_DIM 0xa77d50ffu

void ui_pole(const struct ui_frame *frame, float x, float y, float width)
{
    const float u = frame->unit;
    const struct ui_box box = { x - 0.5f * width, y - 8.0f * u, width, 15.0f * u };
    ui_shape(frame->batch, &(struct ui_shape){ .box = box,
                                               .kind = UI_WASHI,
                                               .fill = 0x8a5a34ffu,
                                               .line = 0x3a2214ffu,
                                               .shape = { 0, 0, 7.0f * u, 2.0f * u } });
}

void ui_cords(const struct ui_frame *frame, struct ui_box box, float pole_y)
{
    const float u = frame->unit;
    for (uint32_t i = 0; i < 2u; i++) {
        const float x = box.x + box.width * (i == 0 ? 0.2f : 0.8f);
        const struct ui_box cord = { x - 2.5f * u, pole_y, 5.0f * u, box.y + 12.0f * u - pole_y };
        ui_shape(frame->batch, &(struct ui_shape){ .box = cord,
                                                   .kind = UI_PANEL,
                                                   .fill = 0xb83a26ffu,
                                                   .line = 0x641a12ffu,
                                                   .shape = { 0, 0, 2.5f * u, u } });
    }
}

void ui_wooden_tag(const struct ui_frame *frame, struct ui_box box, int pointed)
{
    const float u = frame->unit;
    if (pointed) {
        const struct ui_box halo = { box.x - 60.0f * u, box.y - 50.0f * u, box.width + 120.0f * u,
                                     box.height + 110.0f * u };
        ui_shape(frame->batch,
                 &(struct ui_shape){
                     .box = halo,
                     .kind = UI_GLOW,
                     .shape = { 0, 0, 1.0f },
                     .fill = ui_fade(0xffb050ffu, 0.75f + 0.25f * ui_pulse(frame->time_s, 2.4f)) });
    }
    const struct ui_box shade = { box.x + 5.0f * u, box.y + 12.0f * u, box.width, box.height };
    ui_shape(frame->batch, &(struct ui_shape){ .box = shade,
                                               .kind = UI_PANEL,
                                               .fill = 0x05061c70u,
                                               .shape = { 0, 0, 12.0f * u } });
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = box,
                                 .kind = UI_WOOD,
                                 .fill = pointed ? CEDAR : CEDAR_DIM,
                                 .line = pointed ? 0xc8341fffu : 0x5a3a20ffu,
                                 .shape = { 0, 0, 10.0f * u, (pointed ? 5.0f : 2.0f) * u } });
}
