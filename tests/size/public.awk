# SPDX-License-Identifier: MIT
#
# The functions that headers declare, one to a line, each behind its header: "invcal invcal_apply".
# Reads what the preprocessor makes of them (cc -E), as some names hold what a build has chosen. A
# declaration begins at the left margin; the name may stand on its second line.
/^# [0-9]+ "/ {
    header = ""
    if ($3 ~ /(include\/invcal|src)\/[a-z_]+\.h"$/) {
        header = $3
        gsub(/.*\/|\.h"$/, "", header)
    }
    next
}
header != "" && /^([a-z].*[ *])?invcal_[a-z0-9_]+\(/ && !/^(static|typedef) / {
    match($0, /invcal_[a-z0-9_]+\(/)
    print header, substr($0, RSTART, RLENGTH - 1)
}
