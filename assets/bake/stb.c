/* stb.c -- the only object that contains stb_truetype's code (libstb-dev, public domain). */
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
