# SPDX-License-Identifier: MIT
#
# The functions that headers declare, a line each, after the header: "invcal invcal_apply".
# Reads the output of the preprocessor (cc -E), as which are declared depends on the build. A declaration
# begins at the left margin; the name may be on its second line.
/^# [0-9]+ "/ {
    header = ""
    if ($3 ~ /(include\/invcal|src\/.*)\/[a-z_]+\.h"$/) {
        header = $3
        gsub(/.*\/|\.h"$/, "", header)
    }
    next
}
header != "" && /^([a-z_].*[ *])?invcali?_[a-z0-9_]+\(/ && !/^(static|typedef) / {
    match($0, /invcali?_[a-z0-9_]+\(/)
    print header, substr($0, RSTART, RLENGTH - 1)
}
