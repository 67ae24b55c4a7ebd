# sql.awk -- prints the sections of .sql files as C strings. With header=1, it prints their declarations.
#
# A section begins with a line "--- NAME" and becomes the string sql_NAME. The lines of a section are joined with one
# space, or with nothing after a semicolon. Blank lines, the spaces at the start of a line, and comments, which begin
# with "-- ", are removed.

function print_section()
{
    if (name != "" && header) print "extern const char sql_" name "[];"
    if (name != "" && !header) print "const char sql_" name "[] =\n    \"" text "\";"
    text = ""
}

/^--- [a-z0-9_]+$/ { print_section(); name = $2; next }

{
    sub(/(^| +)--( .*)?$/, "")
    sub(/^ +/, "")
    gsub(/[\\"]/, "\\\\&")
    if ($0 != "") text = text (text == "" || text ~ /;$/ ? "" : " ") $0
}

END { print_section() }
