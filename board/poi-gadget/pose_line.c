/* pose_line.c -- parses and prints a pose line word by word. */
#include "board/poi-gadget/pose_line.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/fmath.h"

#define MM 0.001f

static const struct key_name {
    const char *name;
    uint8_t button;
} keys[] = {
    { "OK", POI_BUTTON_OK },       { "START", POI_BUTTON_START }, { "LEFT", POI_BUTTON_LEFT },
    { "RIGHT", POI_BUTTON_RIGHT }, { "FAN", POI_BUTTON_FAN },
};
#define KEY_COUNT (sizeof keys / sizeof keys[0])

/* Returns the next word and advances `*rest` past the word. Returns null at the end of the line or
 * at a comment. */
static char *next_word(char **rest)
{
    char *word = *rest + strspn(*rest, " \t\r\n");
    if (*word == '\0' || *word == '#') {
        return NULL;
    }
    char *end = word + strcspn(word, " \t\r\n#");
    *rest = *end == '\0' || *end == '#' ? end : end + 1;
    if (*end == '#') {
        *rest = end + strlen(end);
    }
    *end = '\0';
    return word;
}

static int read_number(const char *word, float most, float *out)
{
    char *end;
    const float value = strtof(word, &end);
    if (end == word || *end != '\0' || !f_is_finite(value) || f_abs(value) > most) {
        return 0;
    }
    *out = value;
    return 1;
}

static int read_keys(char **rest, uint8_t *buttons)
{
    for (char *word = next_word(rest); word; word = next_word(rest)) {
        size_t k = 0;
        while (k < KEY_COUNT && strcmp(keys[k].name, word) != 0) {
            k++;
        }
        if (k == KEY_COUNT) {
            return 0;
        }
        *buttons |= keys[k].button;
    }
    return 1;
}

/* Parses the six numbers of a pose. Positions are limited to 1,000 mm and angles to 360 degrees in
 * each direction. */
static int read_pose(struct poi_target *out, char *word, char **rest, const char **why)
{
    const float most[6] = { 1000.0f, 1000.0f, 1000.0f, 360.0f, 360.0f, 360.0f };
    float number[6];
    for (uint32_t i = 0; i < 6; i++, word = i < 6 ? next_word(rest) : NULL) {
        if (!word) {
            *why = "a pose is six numbers: X Y Z in mm, pitch yaw roll in degrees";
            return -1;
        }
        if (!read_number(word, most[i], &number[i])) {
            *why = i < 3 ? "a place is a number of mm within +-1000"
                         : "an angle is a number of degrees within +-360";
            return -1;
        }
    }
    out->position_m = v3_scale(v3(number[0], number[1], number[2]), MM);
    out->angles = (struct angles){ .pitch_rad = f_wrap_angle(number[3] * F_DEG),
                                   .yaw_rad = f_wrap_angle(number[4] * F_DEG),
                                   .roll_rad = f_wrap_angle(number[5] * F_DEG) };
    return 1;
}

int pose_line_read(struct pose_line *out, const char *text, const char **why)
{
    char copy[POSE_LINE_SIZE];
    struct pose_line line = { 0 };
    if (strlen(text) >= sizeof copy) {
        *why = "the line is longer than 127 bytes";
        return -1;
    }
    strcpy(copy, text);
    char *rest = copy, *word = next_word(&rest);
    if (!word) {
        return 0;
    }
    if (word[0] == '+') {
        float glide_ms;
        if (!read_number(word + 1, POSE_LINE_GLIDE_S * 1000.0f, &glide_ms) || glide_ms < 0.0f) {
            *why = "a glide is + and a number of ms, 0 .. 600000";
            return -1;
        }
        line.glide_s = glide_ms / 1000.0f;
        word = next_word(&rest);
    }
    line.lost = word && strcmp(word, "lost") == 0;
    if (!line.lost && read_pose(&line.target, word, &rest, why) < 0) {
        return -1;
    }
    if (!read_keys(&rest, &line.buttons)) {
        *why = "a key is OK, START, LEFT, RIGHT or FAN";
        return -1;
    }
    *out = line;
    return 1;
}

void pose_line_write(const struct poi_report *report, char text[POSE_LINE_SIZE])
{
    const vec3 place_m = report->target.position_m;
    const struct angles angles = report->target.angles;
    int length = v3_is_finite(place_m)
                     ? snprintf(text, POSE_LINE_SIZE, "%.2f %.2f %.2f  %.2f %.2f %.2f",
                                (double)(place_m.x / MM), (double)(place_m.y / MM),
                                (double)(place_m.z / MM), (double)(angles.pitch_rad / F_DEG),
                                (double)(angles.yaw_rad / F_DEG), (double)(angles.roll_rad / F_DEG))
                     : snprintf(text, POSE_LINE_SIZE, "lost");
    for (size_t k = 0; k < KEY_COUNT && length > 0 && (uint32_t)length < POSE_LINE_SIZE; k++) {
        if (report->buttons & keys[k].button) {
            length +=
                snprintf(text + length, POSE_LINE_SIZE - (uint32_t)length, " %s", keys[k].name);
        }
    }
}
