/* mutate.c -- lists, draws and applies mutations of C files, each of which changes a small piece of
 * the text.
 *
 * Usage: `mutate draw COUNT SEED FILE...` prints COUNT different lines "FILE SITE", drawn at random
 * with SEED. `mutate apply FILE SITE` writes the mutated FILE to standard output, and "LINE KIND"
 * to standard error.
 *
 * A site is a place in the code together with one mutation of this place. Sites are numbered from 0
 * in the order of the text. The program relies on this project's format: binary operators have a
 * space on both sides, and unary operators do not. Assertions are not mutated, because a correct
 * program never makes them fail. */
#include <ctype.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Largest size of a source file in bytes. */
#define TEXT_MAX (1u << 20)
/* Largest number of mutation sites in all files together. With more sites, the program ends with an
 * error. */
#define SITES_MAX 65536u

/* Describes a mutation. The text from `begin` to `end` is replaced by the string `before`, the old
 * text (only if `keep` is 1) and the string `after`. */
struct site {
    size_t begin, end;
    const char *kind, *before, *after;
    int keep;
};

struct scan {
    /* `text` is the text of the file. `code` is a copy of the text in which comments, strings and
     * assertions are replaced by spaces. */
    char text[TEXT_MAX];
    char code[TEXT_MAX];
    size_t size;
    uint32_t site_count;
    /* Number of the site to find. The scan copies this site to `found`. */
    uint32_t target;
    struct site found;
};

static struct scan scan;

static void add(struct site site)
{
    if (scan.site_count == scan.target) {
        scan.found = site;
    }
    scan.site_count++;
}

static bool is_word(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

static void blank(size_t from, size_t to)
{
    for (size_t i = from; i < to && i < scan.size; i++) {
        scan.code[i] = scan.code[i] == '\n' ? '\n' : ' ';
    }
}

static size_t comment_end(size_t at)
{
    const char *end =
        scan.code[at + 1] == '*' ? strstr(scan.code + at + 2, "*/") : strchr(scan.code + at, '\n');
    return end ? (size_t)(end - scan.code) + (*end == '*' ? 2u : 0u) : scan.size;
}

static size_t literal_end(size_t at)
{
    const char quote = scan.code[at];
    for (at++; at < scan.size && scan.code[at] != quote; at++) {
        at += scan.code[at] == '\\';
    }
    return at + 1;
}

/* Returns the length of the name of an assertion macro that begins at `at`, or 0 if no such name
 * begins there. */
static size_t assertion_at(size_t at)
{
    static const char *const names[] = { "CORE_ASSERT", "_Static_assert", "assert" };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const size_t length = strlen(names[i]);
        if (strncmp(scan.code + at, names[i], length) == 0 && scan.code[at + length] == '(' &&
            (at == 0 || !is_word(scan.code[at - 1]))) {
            return length;
        }
    }
    return 0;
}

/* Returns the position after the parenthesis that closes the parenthesis at `at`. */
static size_t past_closing(size_t at)
{
    int depth = 0;
    for (; at < scan.size; at++) {
        depth += (scan.code[at] == '(') - (scan.code[at] == ')');
        if (depth == 0) {
            return at + 1;
        }
    }
    return scan.size;
}

static size_t directive_end(size_t at)
{
    while (at < scan.size && scan.code[at] != '\n') {
        at += 1u + (scan.code[at] == '\\');
    }
    return at;
}

/* Replaces a preprocessor directive by spaces. Keeps the value of `#define NAME value`, because
 * this value is code that can be mutated. */
static size_t blank_directive(size_t at)
{
    const size_t end = directive_end(at);
    size_t from = end;
    if (strncmp(scan.code + at, "#define ", 8) == 0) {
        for (from = at + 8u; is_word(scan.code[from]); from++) {
        }
        from = scan.code[from] == '(' ? end : from;
    }
    blank(at, from);
    return end;
}

static void blank_what_is_no_code(void)
{
    memcpy(scan.code, scan.text, scan.size + 1u);
    for (size_t at = 0; at < scan.size;) {
        const char c = scan.code[at];
        const size_t from = at;
        if (c == '/' && (scan.code[at + 1] == '*' || scan.code[at + 1] == '/')) {
            at = comment_end(at);
            blank(from, at);
        } else if (c == '"' || c == '\'') {
            at = literal_end(at);
            blank(from, at);
            /* Keeps the opening quote, so that the scan recognizes the string as an operand. */
            scan.code[from] = '"';
        } else {
            at++;
        }
    }
    for (size_t at = 0; at < scan.size; at++) {
        const size_t name = assertion_at(at);
        if (name > 0) {
            blank(at, past_closing(at + name));
        } else if (scan.code[at] == '#' && (at == 0 || scan.code[at - 1] == '\n')) {
            at = blank_directive(at);
        }
    }
}

static int try_operator(size_t at)
{
    static const char *const swaps[][2] = {
        { " < ", " <= " },  { " <= ", " < " },  { " > ", " >= " },  { " >= ", " > " },
        { " == ", " != " }, { " != ", " == " }, { " && ", " || " }, { " || ", " && " },
        { " + ", " - " },   { " - ", " + " },   { " * ", " / " },   { " / ", " * " },
        { " % ", " * " },   { " & ", " | " },   { " | ", " & " },   { " ^ ", " & " },
        { " << ", " >> " }, { " >> ", " << " }, { " += ", " -= " }, { " -= ", " += " },
        { " *= ", " /= " }, { " |= ", " &= " }, { " &= ", " |= " }, { "++", "--" },
        { "--", "++" },
    };
    for (size_t i = 0; i < sizeof swaps / sizeof *swaps; i++) {
        const size_t length = strlen(swaps[i][0]);
        const char last = scan.code[at + length - 1];
        const int matches =
            strncmp(scan.code + at, swaps[i][0], length - 1) == 0 &&
            (last == swaps[i][0][length - 1] || (last == '\n' && swaps[i][0][length - 1] == ' '));
        if (matches) {
            const size_t end = last == '\n' ? at + length - 1 : at + length;
            add((struct site){ at, end, "operator", swaps[i][1], "", 0 });
            return 1;
        }
    }
    return 0;
}

/* Adds a site that changes the constant at `at` by 1. Sites with an even number decrease the
 * constant, and sites with an odd number increase it. The constant 0 is always increased. */
static size_t try_constant(size_t at)
{
    size_t end = at;
    while (is_word(scan.code[end]) || scan.code[end] == '.' ||
           ((scan.code[end] == '-' || scan.code[end] == '+') && end > at &&
            scan.code[at + 1] != 'x' && tolower((unsigned char)scan.code[end - 1]) == 'e')) {
        end++;
    }
    const int is_up = (scan.site_count & 1u) || (end == at + 1 && scan.code[at] == '0');
    add((struct site){ at, end, "constant", "(", is_up ? " + 1)" : " - 1)", 1 });
    return end;
}

static int starts_with_word(size_t at, const char *word)
{
    const size_t length = strlen(word);
    return strncmp(scan.code + at, word, length) == 0 && !is_word(scan.code[at + length]);
}

static bool is_keyword(size_t at)
{
    static const char *const words[] = {
        "if",     "for",     "while",  "do",      "switch", "case",     "default",
        "else",   "return",  "static", "const",   "struct", "enum",     "union",
        "int",    "char",    "float",  "double",  "void",   "unsigned", "goto",
        "extern", "typedef", "long",   "uint8_t", "size_t", "int16_t",  "sqlite3",
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (starts_with_word(at, words[i])) {
            return true;
        }
    }
    return false;
}

/* If the statement that begins at `at` is a call or an assignment, adds a site that deletes it up
 * to its semicolon. Declarations, returns and control statements are never deleted. */
static void try_statement(size_t at)
{
    size_t end = at;
    int depth = 0;
    if (is_keyword(at)) {
        return;
    }
    while (end < scan.size && scan.code[end] != ';' && scan.code[end] != '{' &&
           scan.code[end] != '}' && depth >= 0) {
        depth += (scan.code[end] == '(') - (scan.code[end] == ')');
        end++;
    }
    if (scan.code[end] != ';' || depth != 0) {
        return;
    }
    size_t word = at + (scan.code[at] == '*');
    while (is_word(scan.code[word])) {
        word++;
    }
    const int is_declared =
        scan.code[word] == ' ' && (is_word(scan.code[word + 1]) ||
                                   (scan.code[word + 1] == '*' && scan.code[word + 2] != ' '));
    const int is_label = scan.code[word] == ':' || scan.code[word] == ',';
    if (word > at && !is_declared && !is_label) {
        add((struct site){ at, end, "statement removed", "", "", 0 });
    }
}

static void try_condition(size_t at, size_t word)
{
    const size_t open = at + word;
    const size_t end = past_closing(open);
    add((struct site){ open, end, "condition negated", "(!", ")", 1 });
}

static int begins_statement(size_t at)
{
    while (at > 0 && isspace((unsigned char)scan.code[at - 1])) {
        at--;
    }
    return at > 0 && strchr("{};", scan.code[at - 1]) != NULL;
}

static void find_sites(void)
{
    int depth = 0, parentheses = 0;
    scan.site_count = 0;
    for (size_t at = 0; at < scan.size; at++) {
        const char c = scan.code[at];
        const int is_first = at == 0 || !is_word(scan.code[at - 1]);
        depth += (c == '{') - (c == '}');
        parentheses += (c == '(') - (c == ')');
        const int may_begin = is_first && (is_word(c) || c == '*');
        if (parentheses == 0 && depth > 0 && may_begin && begins_statement(at)) {
            try_statement(at);
        }
        if (starts_with_word(at, "if") && is_first) {
            try_condition(at, 3);
        } else if (starts_with_word(at, "while") && is_first) {
            try_condition(at, 6);
        }
        if (isdigit((unsigned char)c) && is_first && (at == 0 || scan.code[at - 1] != '.')) {
            at = try_constant(at) - 1u;
        } else if (c == ' ' || c == '+' || c == '-') {
            const int is_step = c != ' ' && scan.code[at + 1] == c;
            at += (size_t)(((depth > 0 && c == ' ') || is_step) && try_operator(at) && is_step);
        }
    }
}

static void read_file(const char *path)
{
    FILE *file = fopen(path, "r");
    if (!file) {
        fprintf(stderr, "mutate: %s cannot be opened\n", path);
        exit(1);
    }
    scan.size = fread(scan.text, 1, TEXT_MAX - 8u, file);
    memset(scan.text + scan.size, 0, 8u);
    fclose(file);
    blank_what_is_no_code();
    find_sites();
}

/* Returns the next random number by the SplitMix64 algorithm, which gives the same numbers on every
 * machine. */
static uint64_t next_random(uint64_t *seed)
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static int draw(uint32_t count, uint64_t seed, int file_count, char **files)
{
    static uint32_t order[SITES_MAX], first[SITES_MAX];
    uint32_t total = 0;
    scan.target = UINT32_MAX;
    for (int f = 0; f < file_count; f++) {
        first[f] = total;
        read_file(files[f]);
        total += scan.site_count;
        if (total > SITES_MAX) {
            fprintf(stderr, "mutate: more than %u sites\n", SITES_MAX);
            return 1;
        }
    }
    for (uint32_t i = 0; i < total; i++) {
        order[i] = i;
    }
    for (uint32_t i = 0; i < count && i < total; i++) {
        const uint32_t other = i + (uint32_t)(next_random(&seed) % (total - i));
        const uint32_t site = order[other];
        order[other] = order[i];
        int f = file_count - 1;
        while (first[f] > site) {
            f--;
        }
        printf("%s %u\n", files[f], site - first[f]);
    }
    return 0;
}

static int apply(const char *path, uint32_t index)
{
    scan.target = index;
    read_file(path);
    if (index >= scan.site_count) {
        fprintf(stderr, "mutate: %s has %u sites\n", path, scan.site_count);
        return 1;
    }
    const struct site *site = &scan.found;
    uint32_t line = 1;
    for (size_t i = 0; i < site->begin; i++) {
        line += scan.text[i] == '\n';
    }
    fwrite(scan.text, 1, site->begin, stdout);
    fputs(site->before, stdout);
    for (size_t i = site->begin; i < site->end; i++) {
        if (site->keep || scan.text[i] == '\n') {
            /* Keeps the line breaks of the replaced text, so that line numbers do not change. */
            putchar(scan.text[i]);
        }
    }
    fputs(site->after, stdout);
    fwrite(scan.text + site->end, 1, scan.size - site->end, stdout);
    fprintf(stderr, "%u %s\n", line, site->kind);
    return 0;
}

int main(int count, char **arguments)
{
    if (count > 4 && strcmp(arguments[1], "draw") == 0) {
        return draw((uint32_t)strtoul(arguments[2], NULL, 10), strtoull(arguments[3], NULL, 10),
                    count - 4, arguments + 4);
    }
    if (count == 4 && strcmp(arguments[1], "apply") == 0) {
        return apply(arguments[2], (uint32_t)strtoul(arguments[3], NULL, 10));
    }
    fputs("usage: mutate draw COUNT SEED FILE... | mutate apply FILE SITE\n", stderr);
    return 2;
}
