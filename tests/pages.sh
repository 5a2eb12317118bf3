#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Looks at pages and pictures in headless Chromium, at phone, desktop and print sizes, light and
# dark: nothing is cut off, overlapping or unreadable, nothing is loaded, and a screen reader can
# read it out.
#
#     sh tests/pages.sh BUILD PAGE.html|PICTURE.svg ...
#     sh tests/pages.sh --self-test BUILD      each planted fault must turn its check red
#
# Screenshots and printed sheets stay in BUILD/pages for people to look at.
here=$(dirname "$0")/pages

if [ "$1" = --self-test ]; then
    set -- "${2:?folder to build in}" --self-test
fi
if [ $# -lt 2 ]; then
    echo 'usage: sh tests/pages.sh BUILD PAGE.html|PICTURE.svg ... | --self-test BUILD' >&2
    exit 2
fi
for command in python3 chromium pdftotext pdftoppm; do
    if ! command -v "$command" > /dev/null; then
        echo "pages: $command is not installed: make deps: FAIL"
        echo "0 passed, 1 failed"
        exit 1
    fi
done
# Descriptors 3 and 4 are Chromium's pipes: opened here, so that nothing else gets these numbers.
PYTHONDONTWRITEBYTECODE=1 python3 "$here/pages.py" "$@" 3< /dev/null 4< /dev/null
