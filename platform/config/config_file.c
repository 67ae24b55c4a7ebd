/* config_file.c -- parses the sections and keys of kingyo.conf and reports errors. */
#include "platform/config/config_file.h"

#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <string.h>

#include "core/base/printable.h"
#include "platform/os/file.h"
#include "platform/setting_text.h"

#define WHY_MAX 320u

/* Sections in the order of the example file. The first five sections are the groups of settings. */
static const char *const section_names[] = { "money",    "game",    "sound", "picture",
                                             "operator", "devices", "files" };
#define SECTION_COUNT (sizeof section_names / sizeof section_names[0])

struct reading {
    struct options *options;
    const char *section; /* Current section, one of section_names. "" means before the first
                            section; null means an unknown section. */
    char why[WHY_MAX];   /* Reason why the line is invalid. */
};

__attribute__((format(printf, 2, 3))) static int object(struct reading *reading, const char *format,
                                                        ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(reading->why, sizeof reading->why, format, arguments);
    va_end(arguments);
    return -1;
}

/* ---- Lines of a file ----------------------------------------------------------------------- */

/* Removes leading and trailing white space from `text`, in place. Returns the start of the trimmed
 * text. */
static char *config_file_trim(char *text)
{
    while (isspace((unsigned char)*text)) {
        text++;
    }
    size_t length = strlen(text);
    while (length > 0 && isspace((unsigned char)text[length - 1])) {
        text[--length] = '\0';
    }
    return text;
}

/* Removes the comment from `line`. A '#' starts a comment only at the start of the line or after
 * white space, because a path may contain '#'. */
static void cut_comment(char *line)
{
    for (char *hash = strchr(line, '#'); hash; hash = strchr(hash + 1, '#')) {
        if (hash == line || isspace((unsigned char)hash[-1])) {
            *hash = '\0';
            return;
        }
    }
}

/* ---- Sections ------------------------------------------------------------------------------ */

static int begin_section(struct reading *reading, char *text)
{
    char *end = strchr(text, ']');
    reading->section = NULL;
    if (!end || end[1] != '\0') {
        return object(reading, "a section is [NAME] and nothing else; its lines are passed over");
    }
    *end = '\0';
    const char *name = config_file_trim(text + 1);
    for (size_t i = 0; i < SECTION_COUNT; i++) {
        if (strcmp(section_names[i], name) == 0) {
            reading->section = section_names[i];
            return 0;
        }
    }
    return object(reading,
                  "unknown section [%.40s]; expected money, game, sound, picture, "
                  "operator, devices or files; its lines are passed over",
                  name);
}

/* Returns 1 if the option or setting `key` belongs to the current section. Before the first section
 * every key is accepted. Otherwise returns 0 and writes the reason. */
static int is_here(struct reading *reading, const char *key, const char *section)
{
    assert(key && section);
    if (reading->section[0] == '\0' || strcmp(reading->section, section) == 0) {
        return 1;
    }
    if (section[0] == '\0') {
        return object(reading,
                      "'%s' is an option of the command line; 'kingyoctl config defaults' "
                      "lists what took its place",
                      key),
               0;
    }
    return object(reading, "'%s' belongs to [%s]", key, section), 0;
}

/* ---- Keys ---------------------------------------------------------------------------------- */

static int read_setting(struct reading *reading, uint32_t id, const char *key, const char *value)
{
    assert(id < SETTING_COUNT);
    char range[SETTING_RANGE_MAX];
    struct options_query_result *file = &reading->options->file;
    if (!is_here(reading, key, setting_section(settings_entry(id)->group))) {
        return -1;
    }
    if (!setting_parse(id, value, &file->value[id])) {
        setting_range(id, range);
        return object(reading, "%s: wrong value '%.60s'; expected %s", key, value, range);
    }
    file->is_set[id] = 1;
    return 0;
}

static int read_option(struct reading *reading, const struct option *option, const char *value)
{
    char text[OPTION_TEXT_MAX];
    struct options tried = *reading->options;
    if (!is_here(reading, option->name, option->section)) {
        return -1;
    }
    if (!option_parse(option, &tried, value, text)) {
        return text[0] ? object(reading, "%s: %s", option->name, text)
                       : object(reading, "%s: wrong value '%.60s'; expected %s", option->name,
                                value, option_expects(option, text));
    }
    if (options_wires_clash(&tried, text)) {
        return object(reading, "%s", text);
    }
    *reading->options = tried;
    return 0;
}

static int read_key(struct reading *reading, const char *key, const char *value)
{
    const uint32_t id = setting_find(key, strlen(key));
    const struct option *option = option_table_find(&options_table, key, strlen(key));
    if (id < SETTING_COUNT) {
        return read_setting(reading, id, key, value);
    }
    if (option && option->section) {
        return read_option(reading, option, value);
    }
    return object(reading, "unknown key '%.40s'; 'kingyoctl config defaults' lists all", key);
}

/* Parses one line. Returns 0, or -1 and writes the reason to reading->why. */
static int config_file_read_line(struct reading *reading, char *line)
{
    cut_comment(line);
    char *text = config_file_trim(line);
    if (*text == '\0') {
        return 0;
    }
    if (*text == '[') {
        return begin_section(reading, text);
    }
    if (!reading->section) {
        return 0; /* The unknown section name was already reported, therefore its lines are skipped
                     without another report. */
    }
    char *equals = strchr(text, '=');
    if (!equals) {
        return object(reading, "no '='; expected KEY = VALUE");
    }
    *equals = '\0';
    return read_key(reading, config_file_trim(text), config_file_trim(equals + 1));
}

/* ---- Files --------------------------------------------------------------------------------- */

struct warnings {
    const char *path;
    void (*warn)(const char *line);
    unsigned count;
};

static void config_file_add_warning(struct warnings *warnings, unsigned line, const char *why)
{
    char text[OPTIONS_PATH_MAX + WHY_MAX];
    if (++warnings->count <= CONFIG_WARNINGS_MAX && warnings->warn) {
        snprintf(text, sizeof text, "%.200s:%u: %s", warnings->path, line, why);
        printable(text);
        warnings->warn(text);
    }
}

static void tell_rest(const struct warnings *warnings)
{
    char text[OPTIONS_PATH_MAX + WHY_MAX];
    if (warnings->count > CONFIG_WARNINGS_MAX && warnings->warn) {
        snprintf(text, sizeof text, "%.200s: and %u more; is this a configuration file at all?",
                 warnings->path, warnings->count - CONFIG_WARNINGS_MAX);
        warnings->warn(text);
    }
}

/* Checks the number of fish at the end of the file, because only then is the tank preset known.
 * `line` is the number of the line that set the number of fish. */
static void check_fish(struct reading *reading, unsigned line, struct warnings *warnings)
{
    char says[OPTION_TEXT_MAX], why[WHY_MAX];
    if (options_too_many_fish(reading->options, says)) {
        snprintf(why, sizeof why, "fish: %s", says);
        config_file_add_warning(warnings, line, why);
        reading->options->file.is_set[SET_FISH] = 0;
    }
}

static void config_file_read_lines(struct reading *reading, FILE *file, struct warnings *warnings)
{
    char line[CONFIG_LINE_MAX];
    unsigned fish_line = 0;
    enum file_line result;
    for (unsigned number = 1; (result = file_read_line(file, line, sizeof line)) != FILE_LINE_END;
         number++) {
        const size_t mark = number == 1 && strncmp(line, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
        const uint8_t had_fish = reading->options->file.is_set[SET_FISH];
        const int32_t fish = reading->options->file.value[SET_FISH];
        if (result == FILE_LINE_BAD) {
            config_file_add_warning(warnings, number,
                                    "the line is too long or has a zero byte, and is ignored");
        } else if (config_file_read_line(reading, line + mark)) {
            config_file_add_warning(warnings, number, reading->why);
        }
        if (reading->options->file.is_set[SET_FISH] != had_fish ||
            reading->options->file.value[SET_FISH] != fish) {
            fish_line = number;
        }
    }
    check_fish(reading, fish_line, warnings);
    tell_rest(warnings);
}

int config_file_read(struct options *options, const char *path, void (*warn)(const char *line))
{
    struct reading reading = { .options = options, .section = "" };
    struct warnings warnings = { .path = path, .warn = warn };
    FILE *file = file_open(path, CONFIG_SIZE_MAX);
    if (!file) {
        return -errno;
    }
    errno = 0;
    options->is_file = 1;
    config_file_read_lines(&reading, file, &warnings);
    options->is_file = 0;
    const int error = ferror(file) ? (errno ? -errno : -EIO) : 0;
    fclose(file);
    return error;
}

/* ---- Example file -------------------------------------------------------------------------- */

static void print_settings(FILE *out, const char *section)
{
    char range[SETTING_RANGE_MAX], value[SETTING_TEXT_MAX];
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const struct setting *setting = settings_entry(id);
        const char *own = setting_section(setting->group);
        if (own && strcmp(own, section) == 0) {
            setting_range(id, range);
            setting_print(id, setting->standard, value);
            fprintf(out, "\n# %s\n# Expects %s.\n#%s = %s\n", setting_help(id), range,
                    setting->name, value);
        }
    }
}

static void print_options(FILE *out, const char *section)
{
    char expects[OPTION_TEXT_MAX];
    for (uint32_t i = 0; i < options_table.count; i++) {
        const struct option *option = &options_table.options[i];
        if (option->section && strcmp(option->section, section) == 0) {
            fprintf(out, "\n# As --%s: %s.\n# Expects %s.\n#%s =\n", option->name, option->help,
                    option_expects(option, expects), option->name);
        }
    }
}

void config_file_print_defaults(FILE *out)
{
    fputs("# kingyo.conf -- the stall's settings and devices; kingyo.conf(5) explains.\n"
          "#\n"
          "# All of it is comment: what stands here is what holds without a word. Take the '#'\n"
          "# off a key to change it. What the operator's menu has saved wins over this file, and\n"
          "# the command line over both. 'kingyoctl config check' reads it as the stall does.\n",
          out);
    for (size_t i = 0; i < SECTION_COUNT; i++) {
        fprintf(out, "\n[%s]\n", section_names[i]);
        print_settings(out, section_names[i]);
        print_options(out, section_names[i]);
    }
}
