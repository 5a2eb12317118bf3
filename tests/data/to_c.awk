# SPDX-License-Identifier: MIT
# Prints tables of position means (mean x y z first) as C arrays named after their files.
BEGIN { FS = "," ; print "/* Made from tests/data by to_c.awk. */" }
FNR == 1 {
    if (NR > 1) print "};"
    name = FILENAME
    sub(/.*\//, "", name); sub(/\.csv$/, "", name)
    printf "static const double %s[][3] = {\n", name
    next
}
{ printf "    {%s, %s, %s},\n", $1, $2, $3 }
END { print "};" }
