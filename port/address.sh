#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/address.sh: prints the project's address on the web.
# It is not set yet: example.org is the name that RFC 2606 reserves for examples. Set it here before publication:
# packages and the .pc files take it from here, and dist.sh warns while it is the example.
echo https://example.org/invcal
