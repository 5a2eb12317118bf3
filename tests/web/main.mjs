// SPDX-License-Identifier: MIT
//
// node tests/web/main.mjs BUILD chromium|firefox [PATTERN]
import "./tool_tests.mjs";
import "./live_tests.mjs";
import "./serial_tests.mjs";
import "./face_tests.mjs";
import { runAll } from "./harness.mjs";

await runAll();
