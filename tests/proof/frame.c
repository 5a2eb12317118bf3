/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/frame.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 12 -eva-slevel 50 -eva-split-return full

void main(void)
{
    invcal_frame frame;
    invcal_frame_quality quality;
    invcal_calibration calibration;
    invcal_real raw[3];
    invcal_real up[3];
    invcal_rotation rotation;

    invcal_frame_init(&frame);
    ANY(calibration);
    ANY(raw);
    ANY(up);
    (void)invcal_frame_add(&frame, &calibration, raw, up);
    ANY(frame);
    (void)invcal_frame_add(&frame, &calibration, raw, up);
    ANY(frame);
    (void)invcal_frame_solve(&frame, &rotation, &quality);
    (void)invcal_frame_solve(&frame, &rotation, 0);
    (void)invcal_frame_level(&frame, up, &rotation);
    ANY(rotation);
    invcal_rotate(&calibration, &rotation);
}
