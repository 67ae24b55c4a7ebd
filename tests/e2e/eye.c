/* eye.c -- finds a goldfish that keeps still, in two looks at the screen.
 *
 * eye LEFT TOP RIGHT BOTTOM  reads two pictures of 1280x720 RGB bytes from standard input, one after the
 * other, and prints the pixel `x y` inside the rectangle that is red in both and has the least red farther
 * round it: a small fish, alone, that the paper can carry. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define WIDTH 1280
#define HEIGHT 720
#define BODY 6   /* Half the side of a square that a small fish's body fills, in pixels ... */
#define REACH 24 /* ... and of one that it does not fill, but a large one or two would. */

static uint8_t picture[2][HEIGHT][WIDTH][3];

static int is_red(const uint8_t *pixel)
{
    return pixel[0] > 140 && pixel[1] < 120 && pixel[2] < 100 && pixel[0] > pixel[1] + 50;
}

static int still_red(int x, int y)
{
    return is_red(picture[0][y][x]) && is_red(picture[1][y][x]);
}

static int redness(int centre_x, int centre_y, int reach)
{
    int sum = 0;
    for (int y = centre_y - reach; y <= centre_y + reach; y++) {
        for (int x = centre_x - reach; x <= centre_x + reach; x++) {
            sum += still_red(x, y);
        }
    }
    return sum;
}

static int clamp(int value, int low, int high)
{
    return value < low ? low : value > high ? high : value;
}

int main(int argc, char **argv)
{
    if (argc != 5 || fread(picture, sizeof picture, 1, stdin) != 1) {
        fprintf(stderr, "usage: eye LEFT TOP RIGHT BOTTOM, with two pictures on standard input\n");
        return 2;
    }
    const int left = clamp(atoi(argv[1]), REACH, WIDTH), top = clamp(atoi(argv[2]), REACH, HEIGHT);
    const int right = clamp(atoi(argv[3]), 0, WIDTH - REACH - 1);
    const int bottom = clamp(atoi(argv[4]), 0, HEIGHT - REACH - 1);
    int best = -REACH * REACH * 4, best_x = 0, best_y = 0;
    for (int y = top; y <= bottom; y += 3) {
        for (int x = left; x <= right; x += 3) {
            const int here = 4 * redness(x, y, BODY) - redness(x, y, REACH);
            if (here > best) {
                best = here;
                best_x = x;
                best_y = y;
            }
        }
    }
    printf("%d %d\n", best_x, best_y);
    return 0;
}
