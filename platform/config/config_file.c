/* config_file.c -- parses the sections and keys of kingyo.conf and reports errors. */
#include "platform/config/config_file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/os/file.h"
#include "platform/setting_text.h"

#define WHY_MAX 320u

/* Sections in the order of the example file. The first five sections are the groups of settings. */
static const char *const section_names[] = { "money",    "game",    "sound", "picture",
                                             "operator", "devices", "files" };
#define SECTION_COUNT (sizeof section_names / sizeof section_names[0])

/* State of the reader of one file. */
struct reading {
    struct options *options;
    const char *path;
    void (*warn)(const char *line); /* Callback for each invalid line. May be null. */
    /* Name of the section of the current line, one of section_names. "" means that the line is
     * before the first section. Null means that the name of the section is unknown. */
    const char *section;
    /* Position in the file, counted from 1, of the current line (`line`) and of the line that set
     * the number of fish (`fish_line`). */
    unsigned line, fish_line;
    unsigned warning_count;
};

/* Reports that the current line is invalid. Only the first CONFIG_WARNINGS_MAX warnings are passed
 * to the callback. */
__attribute__((format(printf, 2, 3))) static void object(struct reading *reading,
                                                         const char *format, ...)
{
    char why[WHY_MAX], text[OPTIONS_PATH_MAX + WHY_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    if (++reading->warning_count <= CONFIG_WARNINGS_MAX && reading->warn) {
        snprintf(text, sizeof text, "%.200s:%u: %s", reading->path, reading->line, why);
        printable(text);
        reading->warn(text);
    }
}

/* ---- Sections ------------------------------------------------------------------------------ */

static void begin_section(struct reading *reading, char *text)
{
    char *end = strchr(text, ']');
    reading->section = NULL;
    if (!end || end[1] != '\0') {
        object(reading, "a section line must be [NAME]; the lines of the section are ignored");
        return;
    }
    *end = '\0';
    const char *name = file_trim(text + 1);
    for (size_t i = 0; i < SECTION_COUNT; i++) {
        if (strcmp(section_names[i], name) == 0) {
            reading->section = section_names[i];
            return;
        }
    }
    object(reading,
           "unknown section [%.40s]; expected money, game, sound, picture, operator, devices or "
           "files; the lines of the section are ignored",
           name);
}

/* Returns true if the option or setting `key` may be on the current line, because its section
 * `section` is the current section or because the line is before the first section. Otherwise
 * reports the line and returns false. */
static bool is_here(struct reading *reading, const char *key, const char *section)
{
    CORE_ASSERT(key && section);
    if (reading->section[0] == '\0' || strcmp(reading->section, section) == 0) {
        return true;
    }
    if (section[0] == '\0') {
        object(reading,
               "'%s' is an option of the command line; 'kingyoctl config defaults' lists the keys "
               "that replace it",
               key);
    } else {
        object(reading, "'%s' belongs to [%s]", key, section);
    }
    return false;
}

/* ---- Keys ---------------------------------------------------------------------------------- */

static void read_setting(struct reading *reading, uint32_t id, const char *key, const char *value)
{
    CORE_ASSERT(id < SETTING_COUNT);
    char range[SETTING_RANGE_MAX];
    struct options_query_result *file = &reading->options->file;
    /* In configuration files of older versions, the settings SET_DIP and SET_REACH are in the
     * section [devices]. This section is still accepted for these two settings. */
    const bool was_device = id == SET_DIP || id == SET_REACH;
    const char *own = setting_section(settings_entry(id)->group);
    const bool is_old = was_device && strcmp(reading->section, "devices") == 0;
    if (!is_here(reading, key, is_old ? reading->section : own)) {
        return;
    }
    if (!setting_parse(id, value, &file->value[id])) {
        setting_range(id, range);
        object(reading, "%s: wrong value '%.60s'; expected %s", key, value, range);
        return;
    }
    file->is_set[id] = true;
    reading->fish_line = id == SET_FISH ? reading->line : reading->fish_line;
}

static void read_option(struct reading *reading, const struct option *option, const char *value)
{
    char text[OPTION_TEXT_MAX];
    struct options tried = *reading->options;
    if (!is_here(reading, option->name, option->section)) {
        return;
    }
    if (!option_parse(option, &tried, value, text)) {
        if (text[0]) {
            object(reading, "%s: %s", option->name, text);
        } else {
            object(reading, "%s: wrong value '%.60s'; expected %s", option->name, value,
                   option_expects(option, text));
        }
    } else if (options_wires_clash(&tried, text)) {
        object(reading, "%s", text);
    } else {
        *reading->options = tried;
    }
}

static void config_file_read_line(struct reading *reading, char *line)
{
    char *key = file_trim_comment(line);
    if (*key == '[') {
        begin_section(reading, key);
        return;
    }
    if (*key == '\0' || !reading->section) {
        /* The unknown name of this section was already reported, therefore the lines of the section
         * are skipped without further reports. */
        return;
    }
    const char *value = file_cut_value(key);
    if (!value) {
        object(reading, "no '='; expected KEY = VALUE");
        return;
    }
    const uint32_t id = setting_find(key, strlen(key));
    const struct option *option = option_table_find(&options_table, key, strlen(key));
    if (id < SETTING_COUNT) {
        read_setting(reading, id, key, value);
    } else if (option && option->section) {
        read_option(reading, option, value);
    } else {
        object(reading, "unknown key '%.40s'; 'kingyoctl config defaults' lists all", key);
    }
}

/* ---- Files --------------------------------------------------------------------------------- */

static void config_file_read_lines(struct reading *reading, FILE *file)
{
    char line[CONFIG_LINE_MAX], reason[OPTION_TEXT_MAX], text[OPTIONS_PATH_MAX];
    enum file_line result;
    while ((result = file_read_line(file, line, sizeof line)) != FILE_LINE_END) {
        reading->line++;
        if (result == FILE_LINE_BAD) {
            object(reading, "the line is too long or has a zero byte, and is ignored");
        } else {
            config_file_read_line(reading, reading->line == 1 ? file_skip_mark(line) : line);
        }
    }
    /* The number of fish is checked at the end of the file, because the line that sets the tank
     * preset may be anywhere in the file. */
    if (options_too_many_fish(reading->options, reason)) {
        reading->line = reading->fish_line;
        object(reading, "fish: %s", reason);
        reading->options->file.is_set[SET_FISH] = false;
    }
    if (reading->warning_count > CONFIG_WARNINGS_MAX && reading->warn) {
        snprintf(text, sizeof text,
                 "%.200s: %u more invalid lines; check that the file is a configuration file",
                 reading->path, reading->warning_count - CONFIG_WARNINGS_MAX);
        reading->warn(text);
    }
}

/* Reads the complete file into `bytes`. Returns the number of bytes or a negative errno. */
static int read_all(const char *path, char bytes[CONFIG_SIZE_MAX])
{
    FILE *file = file_open(path, CONFIG_SIZE_MAX);
    if (!file) {
        return -errno;
    }
    errno = 0;
    const size_t size = fread(bytes, 1, CONFIG_SIZE_MAX, file);
    /* A file in /proc may have more bytes than its size, so the end of the file is read too. */
    const int more = size == CONFIG_SIZE_MAX ? fgetc(file) : EOF;
    const int error = ferror(file) ? (errno ? -errno : -EIO) : more != EOF ? -EFBIG : 0;
    fclose(file);
    return error != 0 ? error : (int)size;
}

/* The file is read completely before its first line is validated, so that a file that cannot be
 * read gives one error and no warnings. */
int config_file_read(struct options *options, const char *path, void (*warn)(const char *line))
{
    struct reading reading = { .options = options, .path = path, .warn = warn, .section = "" };
    char *bytes = malloc(CONFIG_SIZE_MAX);
    const int size = bytes ? read_all(path, bytes) : -ENOMEM;
    FILE *file = size >= 0 ? fmemopen(bytes, (size_t)size, "r") : NULL;
    const int error = size < 0 ? size : !file ? -errno : 0;
    if (file) {
        options->is_file = true;
        config_file_read_lines(&reading, file);
        options->is_file = false;
        fclose(file);
    }
    free(bytes);
    return error;
}

/* ---- Example file -------------------------------------------------------------------------- */

static void print_section(FILE *out, const char *section)
{
    char range[SETTING_RANGE_MAX], value[SETTING_TEXT_MAX], expects[OPTION_TEXT_MAX];
    fprintf(out, "\n[%s]\n", section);
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
    fputs(
        "# kingyo.conf -- the settings and devices of the kiosk; see kingyo.conf(5).\n"
        "#\n"
        "# All lines are comments that show the defaults. Remove the '#' before a key to change\n"
        "# its value. Settings that the operator's menu has saved override this file, and the\n"
        "# command line overrides both. 'kingyoctl config check' reads a file as the kiosk does.\n",
        out);
    for (size_t i = 0; i < SECTION_COUNT; i++) {
        print_section(out, section_names[i]);
    }
}
