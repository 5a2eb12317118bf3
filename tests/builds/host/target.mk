# SPDX-License-Identifier: MIT
# This machine.
BOARD := port/hosted/board.c
LINK  := -lm
RUN   := env
