/* SPDX-License-Identifier: MIT */
#include "read/signature.h"

#include <string.h>

#define PICTURE(kind) "a picture (" kind "): readings are needed, as CSV"
#define MARKUP "a web page or XML: download or export the table itself, as CSV"

const char *signature_find(const char *bytes, size_t length)
{
    static const struct {
        const char *bytes;
        size_t length;
        const char *what;
    } signatures[] = {
        {"ULog\x01\x12\x35", 7,
         "a PX4 ulog: convert it with ulog2csv, and use its sensor_accel file"},
        {"H Product:Blackbox", 18,
         "a Betaflight or INAV blackbox log: convert it with blackbox_decode"},
        {"\xa3\x95\x80", 3,
         "an ArduPilot dataflash log: convert it with mavlogdump.py --format csv --types IMU"},
        {"FMT, 128, 89", 12,
         "an ArduPilot text log: convert the .bin with mavlogdump.py --format csv --types IMU"},
        {"LabVIEW Measurement", 19,
         "a LabVIEW measurement file: delete the lines before the one that begins with X_Value"},
        {"#ROSBAG", 7, "a ROS bag: convert its IMU topic with rostopic echo -p"},
        {"SQLite format 3", 15,
         "an SQLite database, such as a ROS 2 bag: export the table of the accelerometer as CSV"},
        {"\x89MCAP0", 6, "an MCAP recording: export the topic of the accelerometer as CSV"},
        {"MATLAB 5.0 MAT-file", 19, "a MATLAB file: save the table there with writematrix, as CSV"},
        {"\x89HDF", 4, "an HDF5 or MATLAB file: export the readings there as CSV"},
        {"\x93NUMPY", 6, "a NumPy array: save it with numpy.savetxt"},
        {"PK\x03\x04", 4, "a ZIP file or an Excel workbook: unpack it, or save the sheet as CSV"},
        {"\xd0\xcf\x11\xe0", 4, "an old Excel workbook: save the sheet as CSV"},
        {"\x1f\x8b", 2, "a gzip file: unpack it with gunzip"},
        {"BZh", 3, "a bzip2 file: unpack it with bunzip2"},
        {"\xfd"
         "7zXZ",
         5, "an xz file: unpack it with unxz"},
        {"(\xb5/\xfd", 4, "a Zstandard file: unpack it with unzstd"},
        {"7z\xbc\xaf\x27\x1c", 6, "a 7-Zip file: unpack it"},
        {"Rar!\x1a", 5, "a RAR file: unpack it"},
        {"\x89PNG", 4, PICTURE("PNG")},
        {"\xff\xd8\xff", 3, PICTURE("JPEG")},
        {"GIF8", 4, PICTURE("GIF")},
        {"II*", 3, PICTURE("TIFF")},
        {"MM\0*", 4, PICTURE("TIFF")},
        {"%PDF-", 5, "a PDF document: export the readings as CSV where they were recorded"},
        {"{\\rtf", 5, "an RTF document: save it as plain text"},
        {"<!DOCTYPE", 9, MARKUP},
        {"<html", 5, MARKUP},
        {"<?xml", 5, MARKUP},
        {"<svg", 4, PICTURE("SVG")},
        {"{", 1, "JSON: a table with one sample per line is needed; write x, y, z of each as CSV"},
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
