/* SPDX-License-Identifier: MIT */
#include "read/signature.h"

#include <string.h>

const char *signature_find(const char *bytes, size_t length)
{
    static const struct {
        const char *bytes;
        size_t length;
        const char *what;
    } signatures[] = {
        {"ULog\x01\x12\x35", 7, "a PX4 ulog: convert it with ulog2csv, and take its sensor_accel"},
        {"H Product:Blackbox", 18,
         "a Betaflight or INAV blackbox log: convert it with blackbox_decode"},
        {"\xa3\x95\x80", 3,
         "an ArduPilot dataflash log: convert it with mavlogdump.py --format csv --types IMU"},
        {"FMT, 128, 89", 12,
         "an ArduPilot text log: convert the .bin with mavlogdump.py --format csv --types IMU"},
        {"LabVIEW Measurement", 19,
         "a LabVIEW measurement file: delete the lines above the one that begins with X_Value"},
        {"#ROSBAG", 7, "a ROS bag: convert its IMU topic with rostopic echo -p"},
        {"PK\x03\x04", 4, "a ZIP file or an Excel workbook: unpack it, or save the sheet as CSV"},
        {"\xd0\xcf\x11\xe0", 4, "an old Excel workbook: save the sheet as CSV"},
        {"\x1f\x8b", 2, "a gzip file: unpack it with gunzip"},
        {"\xff\xfe", 2, "UTF-16 text: save it as UTF-8"},
        {"\xfe\xff", 2, "UTF-16 text: save it as UTF-8"},
    };

    for (size_t i = 0; i < sizeof signatures / sizeof signatures[0]; i++) {
        if (length >= signatures[i].length &&
            memcmp(bytes, signatures[i].bytes, signatures[i].length) == 0) {
            return signatures[i].what;
        }
    }
    return NULL;
}
