#!/bin/bash
# test_pages.sh -- pages.sh rejects each breach of form and each broken link in a generated page.
# Speaks TAP.
set -u
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=0
cd "$work" || exit 1
printf '# One page\n\n## What is kept, where\n' >other.md
echo 'int here(void);' >code.h

ok() { # STATUS TEXT
    count=$((count + 1))
    [ "$1" -eq 0 ] && echo "ok $count - $2" || { echo "not ok $count - $2"; sed 's/^/# /' output; }
}
check() { # TEXT: Returns the exit status of pages.sh for a page with this text.
    printf '%b\n' "$1" >page.md
    "$here/pages.sh" page.md >output 2>&1
}
refuses() { # MESSAGE TEXT NAME
    ! check "$2" && grep -qF "$1" output
    ok $? "$3"
}
allows() { # TEXT NAME
    check "$1"
    ok $? "$2"
}
words() { # COUNT: Prints a sentence of COUNT words.
    printf 'word %.0s' $(seq 2 "$1")
    printf 'last.'
}
wide=$(printf '%161s' '' | tr ' ' x)

refuses 'page.md:1: over 160 columns' "$wide" 'a line may not have 161 characters'
allows "${wide#x}" 'a line may have 160 characters'
allows "$(sed 's/x/魚/g' <<<"${wide#x}")" 'a line may have 160 Japanese characters'
allows "| $wide | $(words 31) |" 'a table may have longer lines and sentences'
allows "\`\`\`sh\n$wide $(words 31)\n\`\`\`" 'a code block may have longer lines and sentences'
allows "Text:\n\n    $wide" 'an indented code block may have longer lines'
refuses 'page.md:1: a sentence of 31 words' "$(words 31)" 'a sentence may not have 31 words'
refuses 'page.md:3: a sentence of 31 words' "Short.\n\n* $(words 16 | tr -d .)\n  $(words 15)" 'a sentence over two lines may not have 31 words'
allows "$(words 30)\n$(words 30)" 'two sentences of 30 words are allowed'
allows "* $(words 20 | tr -d .)\n* $(words 20)" 'list items are separate sentences'
allows "\`$(words 31)\`" 'an inline code span is one word'
refuses 'the link gone.md does not resolve' '[gone](gone.md)' 'a link may not name a missing file'
refuses 'the link gone.png does not resolve' '| ![gone](gone.png) |' 'a picture in a table may not name a missing file'
refuses 'the link other.md#gone does not resolve' '[gone](other.md#gone)' 'an anchor may not name a missing heading'
allows '# A page\n[1](other.md) [2](other.md#what-is-kept-where) [3](#a-page) [4](https://example.org)' 'valid links are allowed'
refuses 'code.h has no gone()' '| 1 | `here()`, `gone()` in [code.h](code.h) |' 'a function must be in the linked file'
allows '| 1 | `here()` in [code.h](code.h) |' 'a function that the linked file has is allowed'
echo "1..$count"
