/* ask_to_close.c -- requests that a window closes, as a window manager does when the user clicks
 * the close button.
 *
 * Usage: ask_to_close WINDOW. WINDOW is a window number, as xdotool prints it, on the screen of
 * DISPLAY. */
#include <stdio.h>
#include <stdlib.h>

#include <X11/Xlib.h>

int main(int argc, char **argv)
{
    Display *display = XOpenDisplay(NULL);
    if (argc != 2 || !display) {
        fprintf(stderr, "usage: ask_to_close WINDOW, with a DISPLAY\n");
        return 2;
    }
    XEvent event = { .xclient = {
                         .type = ClientMessage,
                         .window = strtoul(argv[1], NULL, 0),
                         .message_type = XInternAtom(display, "WM_PROTOCOLS", False),
                         .format = 32,
                     } };
    event.xclient.data.l[0] = (long)XInternAtom(display, "WM_DELETE_WINDOW", False);
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(display, event.xclient.window, False, NoEventMask, &event);
    XCloseDisplay(display);
    return 0;
}
