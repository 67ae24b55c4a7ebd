/* doctor_findings.c -- stores the findings, and prints the findings as text or JSON. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "platform/ctl/doctor/doctor.h"
#include "platform/os/json_char.h"
#include "platform/os/print.h"

static const char *const level_words[] = { "fine", "look", "WRONG" };

struct doctor_finding *doctor_find(struct doctor *doctor, const char *part, enum doctor_level level,
                                   const char *what, ...)
{
    static struct doctor_finding spare; /* Scratch finding that is returned when the list is full.
                                           Its content is never printed. */
    const bool has_room = doctor->count < DOCTOR_FINDINGS_MAX;
    struct doctor_finding *finding = has_room ? &doctor->finding[doctor->count++] : &spare;
    doctor->more += !has_room;
    *finding = (struct doctor_finding){ .part = part, .level = (uint8_t)level };
    va_list arguments;
    va_start(arguments, what);
    vsnprintf(finding->what, sizeof finding->what, what, arguments);
    va_end(arguments);
    return finding;
}

void doctor_state(struct doctor_finding *finding, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->state, sizeof finding->state, format, arguments);
    va_end(arguments);
}

void doctor_todo(struct doctor_finding *finding, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->todo, sizeof finding->todo, format, arguments);
    va_end(arguments);
}

uint32_t doctor_count(const struct doctor *doctor, enum doctor_level level)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < doctor->count; i++) {
        count += doctor->finding[i].level == level;
    }
    return count;
}

/* ---- Output as text -------------------------------------------------------------------------- */

void doctor_report_text(const struct doctor *doctor)
{
    for (uint32_t i = 0; i < doctor->count; i++) {
        const struct doctor_finding *finding = &doctor->finding[i];
        print_line(stdout, "%-5s  %-10s  %s: %s", level_words[finding->level], finding->part,
                   finding->what, finding->state);
        if (finding->todo[0]) {
            print_line(stdout, "       %-10s  -> %s", "", finding->todo);
        }
    }
    if (doctor->more > 0) {
        printf("and %u more that there was no room for\n", doctor->more);
    }
    printf("%u fine, %u to look at, %u wrong\n", doctor_count(doctor, DOCTOR_FINE),
           doctor_count(doctor, DOCTOR_LOOK), doctor_count(doctor, DOCTOR_WRONG));
}

/* ---- Output as JSON -------------------------------------------------------------------------- */

/* Prints a JSON key and a string value. Device texts are already printable (doctor_line()), but a
 * path may contain any character and must be escaped. */
static void put_string(const char *key, const char *text)
{
    printf("\"%s\":", key);
    json_print(text);
}

void doctor_report_json(const struct doctor *doctor)
{
    static const char *const keys[] = { "fine", "look", "wrong" };
    fputs("{\"findings\":[", stdout);
    for (uint32_t i = 0; i < doctor->count; i++) {
        const struct doctor_finding *finding = &doctor->finding[i];
        fputs(i > 0 ? ",\n{" : "\n{", stdout);
        put_string("part", finding->part);
        putchar(',');
        put_string("level", keys[finding->level]);
        putchar(',');
        put_string("what", finding->what);
        putchar(',');
        put_string("state", finding->state);
        putchar(',');
        put_string("todo", finding->todo);
        putchar('}');
    }
    printf("\n],\"more\":%u,\"fine\":%u,\"look\":%u,\"wrong\":%u}\n", doctor->more,
           doctor_count(doctor, DOCTOR_FINE), doctor_count(doctor, DOCTOR_LOOK),
           doctor_count(doctor, DOCTOR_WRONG));
}
