#!/bin/bash
# test_pages.sh -- pages.sh refuses each breach of form and each broken link in a made-up page. Speaks TAP.
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
    [ "$1" -eq 0 ] && echo "ok $count - $2" || { echo "not ok $count - $2"; sed 's/^/# /' said; }
}
check() { # TEXT: the exit status of pages.sh for a page of this text.
    printf '%b\n' "$1" >page.md
    "$here/pages.sh" page.md >said 2>&1
}
refuses() { # MESSAGE TEXT NAME
    ! check "$2" && grep -qF "$1" said
    ok $? "$3"
}
allows() { # TEXT NAME
    check "$1"
    ok $? "$2"
}
words() { # COUNT: a sentence of so many words.
    printf 'word %.0s' $(seq 2 "$1")
    printf 'last.'
}
wide=$(printf '%161s' '' | tr ' ' x)

refuses 'page.md:1: over 160 columns' "$wide" 'a line may not have 161 characters'
allows "${wide#x}" 'but 160'
allows "$(sed 's/x/魚/g' <<<"${wide#x}")" 'and 160 Japanese characters'
allows "| $wide | $(words 31) |" 'a table may have longer lines and sentences'
allows "\`\`\`sh\n$wide $(words 31)\n\`\`\`" 'and a code block'
allows "Text:\n\n    $wide" 'also an indented one'
refuses 'page.md:1: a sentence of 31 words' "$(words 31)" 'a sentence may not have 31 words'
refuses 'page.md:3: a sentence of 31 words' "Short.\n\n* $(words 16 | tr -d .)\n  $(words 15)" 'nor over two lines'
allows "$(words 30)\n$(words 30)" 'but 30, twice'
allows "* $(words 20 | tr -d .)\n* $(words 20)" 'list items are separate'
allows "\`$(words 31)\`" 'an inline code span is one word'
refuses 'the link gone.md does not resolve' '[gone](gone.md)' 'a link may not name a missing file'
refuses 'the link gone.png does not resolve' '| ![gone](gone.png) |' 'nor may a picture in a table'
refuses 'the link other.md#gone does not resolve' '[gone](other.md#gone)' 'nor may an anchor name a missing heading'
allows '# A page\n[1](other.md) [2](other.md#what-is-kept-where) [3](#a-page) [4](https://example.org)' 'other links are allowed'
refuses 'code.h has no gone()' '| 1 | `here()`, `gone()` in [code.h](code.h) |' 'a function must be in the linked file'
allows '| 1 | `here()` in [code.h](code.h) |' 'a function that is there is allowed'
echo "1..$count"
