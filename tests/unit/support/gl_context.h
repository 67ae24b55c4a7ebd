/* gl_context.h -- creates an OpenGL ES context for tests. The software renderer draws in it off
 * screen. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_GL_CONTEXT_H
#define KINGYO_TESTS_UNIT_SUPPORT_GL_CONTEXT_H

#include <SDL.h>

/* Creates a context and makes it current. On any error, the test fails. The test must include
 * cmocka.h first and call SDL_Quit() at its end. */
static inline void open_gl_context(const char *title)
{
    SDL_setenv("SDL_VIDEODRIVER", "offscreen", 0);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    assert_int_equal(SDL_Init(SDL_INIT_VIDEO), 0);
    SDL_Window *const window = SDL_CreateWindow(title, 0, 0, 64, 64, SDL_WINDOW_OPENGL);
    assert_non_null(window);
    assert_non_null(SDL_GL_CreateContext(window));
}

#endif
