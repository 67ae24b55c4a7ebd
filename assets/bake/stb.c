/* stb.c -- the only source file that compiles the code of stb_truetype (package libstb-dev, public
 * domain). */
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
