/* eye.c -- reads pictures of the kiosk's window and finds fish by their colour, as eye.h
 * declares. */
#include "eye.h"

#include <stdbool.h>
#include <stdlib.h>

#include <X11/Xutil.h>

#define BODY_PX 12 /* Half the side of the square, in pixels, that a small fish fills. */
/* Half the side of a larger square around a fish, in pixels. The fish counts as alone if at least
 * half of the warm pixels in this square belong to it. */
#define ALONE_PX 34
/* Smallest number of warm pixels of a fish that the test tries to scoop. */
#define RED_MIN 60
/* Largest number of warm pixels of a fish that the test tries to scoop. The tail of a larger fish
 * lies on the ring and tears the paper with its slaps. */
#define RED_MAX 450

int eye_open(struct eye *eye, const char *window)
{
    *eye = (struct eye){ .display = XOpenDisplay(NULL) };
    return eye->display != NULL && (eye->window = strtoul(window, NULL, 0)) != 0;
}

/* Returns 1 for a gold, orange or red pixel, as goldfish have. Water, reflections, white and the
 * pink of a ring do not count. */
static bool is_warm(const uint8_t *bgr)
{
    return bgr[2] > 110 && bgr[2] > bgr[1] + 30 && bgr[2] > bgr[0] + 50 && bgr[1] + 15 > bgr[0];
}

/* Reads the rectangle `area` of the window. Pixels outside the window become black. */
int eye_capture(struct eye *eye, struct rect area)
{
    const struct rect r = {
        area.left > 0 ? area.left : 0,
        area.top > 0 ? area.top : 0,
        area.right < SCREEN_WIDTH ? area.right : SCREEN_WIDTH,
        area.bottom < SCREEN_HEIGHT ? area.bottom : SCREEN_HEIGHT,
    };
    XImage *image =
        XGetImage(eye->display, eye->window, r.left, r.top, (unsigned)(r.right - r.left),
                  (unsigned)(r.bottom - r.top), AllPlanes, ZPixmap);
    if (!image || image->bits_per_pixel != 32) {
        return 0;
    }
    eye->seen = r;
    for (int y = r.top; y < r.bottom; y++) {
        const uint8_t *row = (const uint8_t *)image->data + (y - r.top) * image->bytes_per_line;
        for (int x = r.left; x < r.right; x++) {
            eye->warm[y][x] = (uint8_t)is_warm(row + 4 * (x - r.left));
            eye->blue[y][x] = row[4 * (x - r.left)];
        }
    }
    XDestroyImage(image);
    return 1;
}

struct blob eye_blob(const struct eye *eye, float centre_x, float centre_y, int reach_px)
{
    const struct rect *seen = &eye->seen;
    const int left = (int)centre_x - reach_px, top = (int)centre_y - reach_px;
    struct blob blob = { .blue = 255 };
    for (int y = top; y <= top + 2 * reach_px; y++) {
        for (int x = left; x <= left + 2 * reach_px; x++) {
            if (x >= seen->left && x < seen->right && y >= seen->top && y < seen->bottom &&
                eye->warm[y][x]) {
                blob.count++;
                blob.blue = eye->blue[y][x] < blob.blue ? eye->blue[y][x] : blob.blue;
                blob.x += (float)x;
                blob.y += (float)y;
            }
        }
    }
    blob.x = blob.count > 0 ? blob.x / (float)blob.count : centre_x;
    blob.y = blob.count > 0 ? blob.y / (float)blob.count : centre_y;
    return blob;
}

struct blob eye_follow(const struct eye *eye, float x, float y)
{
    struct blob blob = { .x = x, .y = y };
    for (int i = 0; i < 4; i++) {
        blob = eye_blob(eye, blob.x, blob.y, BODY_PX + 4);
    }
    return blob;
}

/* Returns the squared distance from `blob` to the nearest fish in `list`, in square pixels. */
static float nearest(const struct blob *list, int count, const struct blob *blob)
{
    float least = 1e9f;
    for (int i = 0; i < count; i++) {
        const float dx = list[i].x - blob->x, dy = list[i].y - blob->y;
        least = dx * dx + dy * dy < least ? dx * dx + dy * dy : least;
    }
    return least;
}

int eye_find(const struct eye *eye, struct blob *list, int count_max)
{
    const struct rect *seen = &eye->seen;
    int count = 0;
    for (int y = seen->top + ALONE_PX; y < seen->bottom - ALONE_PX; y += 8) {
        for (int x = seen->left + ALONE_PX; x < seen->right - ALONE_PX; x += 8) {
            if (count == count_max || eye_blob(eye, (float)x, (float)y, 5).count < 20) {
                continue;
            }
            struct blob blob = eye_follow(eye, (float)x, (float)y);
            const int around = eye_blob(eye, blob.x, blob.y, ALONE_PX).count - blob.count;
            if (blob.count >= RED_MIN && blob.count <= RED_MAX && around < blob.count &&
                nearest(list, count, &blob) > 400.0f) {
                list[count++] = blob;
            }
        }
    }
    return count;
}
