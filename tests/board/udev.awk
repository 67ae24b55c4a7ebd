# udev.awk -- what udev would do with one device: awk -v device='SUBSYSTEM=usb;ATTRS{idVendor}=054c;...' -f udev.awk RULES
#
# Knows what our rules use: matches == and != with | and shell patterns, assignments, GOTO and LABEL. Prints the
# assignments in order, sorted out by key: `GROUP=kingyo`. Anything it does not know is an error, exit 2.
function fail(what) { print FILENAME ":" FNR ": " what >"/dev/stderr"; failed = 1; exit 2 }
function pattern(text) {
    gsub(/[.+^$(){}]/, "\\\\&", text)
    gsub(/\*/, ".*", text)
    gsub(/\?/, ".", text)
    return "^(" text ")$"
}
BEGIN {
    count = split(device, pairs, ";")
    for (i = 1; i <= count; i++) {
        at = index(pairs[i], "=")
        has[substr(pairs[i], 1, at - 1)] = substr(pairs[i], at + 1)
    }
}
/^[ \t]*(#|$)/ { next }
{
    rest = $0
    parts = 0
    while (match(rest, /^[ \t]*[A-Z]+(\{[A-Za-z_\/]+\})?[ \t]*(==|!=|=)[ \t]*"[^"]*"[ \t]*(,|$)/)) {
        token = substr(rest, 1, RLENGTH)
        rest = substr(rest, RLENGTH + 1)
        parts++
        match(token, /[A-Z]+(\{[A-Za-z_\/]+\})?/)
        key[parts] = substr(token, RSTART, RLENGTH)
        match(token, /==|!=|=/)
        operator[parts] = substr(token, RSTART, RLENGTH)
        match(token, /"[^"]*"/)
        value[parts] = substr(token, RSTART + 1, RLENGTH - 2)
    }
    if (rest != "" || parts == 0) fail("not a rule: " rest)
    if (label != "") {
        if (key[1] == "LABEL" && value[1] == label) label = ""
        else next
    }
    for (i = 1; i <= parts; i++) {
        if (key[i] !~ /^(ACTION|SUBSYSTEM|KERNEL|GOTO|LABEL|GROUP|MODE|TEST|ENV\{DEVTYPE\}|ATTRS\{id(Vendor|Product)\}|ATTR\{power\/control\})$/)
            fail("a key that is not among ours: " key[i])
        if (operator[i] == "=") continue
        if (key[i] == "TEST" ? !(value[i] in has) : (has[key[i]] ~ pattern(value[i])) != (operator[i] == "==")) next
    }
    for (i = 1; i <= parts; i++) {
        if (operator[i] != "=") continue
        if (key[i] == "GOTO") label = value[i]
        else if (key[i] != "LABEL") print key[i] "=" value[i]
    }
}
END { if (!failed && label != "") { print FILENAME ": no label " label >"/dev/stderr"; exit 2 } }
