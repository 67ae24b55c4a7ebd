/* gpio_lines0.c -- the backend for a build without libgpiod. The backend has no operations, so that
 * gpio_backend.c reports every line as missing. */
#include "drivers/gpio/gpio_backend.h"

struct gpio_lines gpio_lines_device(void)
{
    static const struct gpio_backend_ops ops = { 0 };
    static struct gpio_backend backend;
    return gpio_backend_device(&backend, &ops);
}
