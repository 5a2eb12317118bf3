#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/pkg-config/pc.sh invcal|invcal-double PREFIX CHOICES
# Prints the .pc file of a library that was installed under PREFIX, compiled with the options CHOICES.
cd "$(dirname "$0")/../.." || exit 1
version=$(sh port/version.sh) && address=$(sh port/address.sh) || exit 1
case $1 in
invcal-double) type=double is_double=1 library=invcal_double ;;
*) type=float is_double=0 library=invcal ;;
esac
case $2 in
*"\${"*)
    # shellcheck disable=SC2016
    echo 'PREFIX: contains ${, where pkg-config would insert a variable' >&2
    exit 1
    ;;
esac
# pkg-config splits what it makes of it like a shell; # begins a comment.
prefix=$(printf '%s\n' "$2" | sed 's/[][ \\"`&;|<>(){}*?!~#'\'']/\\&/g')
cat << END
# SPDX-License-Identifier: MIT
prefix=$prefix

Name: $1
Description: Accelerometers, gyroscopes and magnetometers calibrate themselves on the device, in $type
URL: $address
Version: $version
Cflags: -I\${prefix}/include -DINVCAL_DOUBLE=$is_double${3:+ $3}
Libs: -L\${prefix}/lib -l$library -lm
END
