# SPDX-License-Identifier: MIT
#
# Doxygen's layout, with the navigation of the index page: awk -f layout.awk README.md DEFAULT, that of `doxygen -l`.
# A heading of the index is a group, an item of its lists a page.
NR == FNR {
    if (sub(/^## /, "")) {
        tabs = tabs group "    <tab type=\"usergroup\" visible=\"yes\" title=\"" $0 "\">\n"
        group = "    </tab>\n"
    } else if (group != "" && match($0, /^- \[[^]]*\]\([^)]*\)/)) {
        hash = index($0, "](")
        tabs = tabs "      <tab type=\"user\" visible=\"yes\" url=\"" address(substr($0, hash + 2, RLENGTH - hash - 2)) \
            "\" title=\"" substr($0, 4, hash - 4) "\"/>\n"
    }
    next
}

/<navindex>/ {
    print
    printf "    <tab type=\"mainpage\" visible=\"yes\" title=\"The manual\"/>\n%s%s", tabs, group
    skipped = 1
}
/<\/navindex>/ { skipped = 0 }
!skipped

# The file of a page or header, as Doxygen names it.
function address(target) {
    if (sub(/^\.\.\/\.\.\/include\/invcal\//, "", target)) {
        sub(/\.h$/, "_8h.html", target)
        return target
    }
    target = "port/manual/" target
    while (sub(/[^\/]+\/\.\.\//, "", target)) {
    }
    gsub(/[\/-]/, "_", target)
    sub(/\.md$/, ".html", target)
    return "md_" target
}
