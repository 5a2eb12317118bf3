# SPDX-License-Identifier: MIT
#
# The public functions that headers declare, one to a line, each behind its room: "solution
# invcal_solve". A declaration begins at the left margin; the name may stand on its second line.
FNR == 1 {
    room = FILENAME
    sub(/.*\//, "", room)
    sub(/\.h$/, "", room)
}
/^([a-z].*[ *])?invcal_[a-z0-9_]+\(/ && !/^(static|typedef) / {
    match($0, /invcal_[a-z0-9_]+\(/)
    print room, substr($0, RSTART, RLENGTH - 1)
}
