# help.awk -- prints the tasks of `make help` by group, from comment lines of the form
# "## group/target: what it does" in the Makefile and its fragments.
BEGIN { group_count = split("play build test measure picture package", group) }
/^## [a-z]+\/[a-z0-9_.-]+: / {
    split($2, part, "/")
    name = substr(part[2], 1, length(part[2]) - 1)
    text = substr($0, length("## " $2) + 2)
    line[part[1]] = line[part[1]] sprintf("  make %-20s %s\n", name, text)
}
END {
    for (i = 1; i <= group_count; i++) {
        printf "\n%s\n", toupper(substr(group[i], 1, 1)) substr(group[i], 2)
        printf "%s", line[group[i]] | "LC_ALL=C sort"
        close("LC_ALL=C sort")
    }
}
