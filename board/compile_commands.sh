#!/bin/bash
# compile_commands.sh -- reads the commands of `make --dry-run` and prints a JSON compilation database
# (https://clang.llvm.org/docs/JSONCompilationDatabase.html) with one entry for each C file.
set -eu
awk -v folder="$PWD" '
    function escaped(text) {
        gsub(/[\\"]/, "\\\\&", text)
        return text
    }
    / -c -o / && $NF ~ /\.c$/ && !($NF in seen) {
        seen[$NF] = 1
        printf "%s\n  { \"directory\": \"%s\", \"file\": \"%s\", \"command\": \"%s\" }",
            count++ ? "," : "[", escaped(folder), escaped($NF), escaped($0)
    }
    END { print count ? "\n]" : "[]" }'
