/* SPDX-License-Identifier: MIT */
#include "calibrate/deliver.h"

#include "cli/command.h"
#include "cli/message.h"
#include "cli/output.h"
#include "report/report.h"
#include "result/refusal.h"
#include "text/json_write.h"
#include "text/plain.h"

static calibrate_invocation invocation_of(const request *r)
{
    return (calibrate_invocation){
        .nominal_name = r->value[OPT_NOMINAL_NAME] ? r->value[OPT_NOMINAL_NAME] : "nominal",
        .saved = r->value[OPT_OUT],
        .report = r->value[OPT_REPORT],
        .command = r->command,
        .log = r->file,
    };
}

static int print(const request *r, const calibrate_result *result)
{
    const calibrate_invocation invocation = invocation_of(r);

    if (r->value[OPT_JSON]) {
        calibrate_json(stdout, result);
    } else if (!r->value[OPT_QUIET]) {
        calibrate_print(stdout, result, &invocation);
    }
    return output_flush();
}

/* Writes a file, if its path is given, under a temporary name. */
typedef int file_writer(FILE *file, const request *r, const calibrate_result *result);

static int begin_file(output *out, const char *path, file_writer *write, const request *r,
                      const calibrate_result *result)
{
    if (!path) {
        return EXIT_GOOD;
    }
    int failure = output_begin(out, path);
    failure = failure ? failure : write(out->file, r, result);
    return failure ? failure : output_finish(out);
}

static int write_calibration(FILE *file, const request *r, const calibrate_result *result)
{
    (void)r;
    calibrate_json(file, result);
    return EXIT_GOOD;
}

static int write_report(FILE *file, const request *r, const calibrate_result *result)
{
    const calibrate_invocation invocation = invocation_of(r);

    return report_write(file, result, &invocation);
}

static int write_refusal(FILE *file, const request *r, const calibrate_result *result)
{
    const calibrate_invocation invocation = invocation_of(r);

    return report_refusal(file, result, &invocation);
}

int deliver_refusal(const request *r, const calibrate_result *result)
{
    const refusal *why = &result->refused;
    char text[REFUSAL_TEXT_MAX];
    output page = {0};
    int failure = begin_file(&page, r->value[OPT_REPORT], write_refusal, r, result);

    if (!failure && r->value[OPT_JSON]) {
        refusal_json(stdout, result);
    } else if (!failure && r->value[OPT_REPORT] && !r->value[OPT_QUIET]) {
        printf("Report in %s.\n", r->value[OPT_REPORT]);
    }
    failure = failure ? failure : output_flush();
    failure = output_end(&page, 1, failure);
    if (why->is_of_position) {
        message("%s:%lu: %s", result->data->name, result->data->origin[why->position].line,
                refusal_text(result, text));
    } else {
        message("%s: %s", result->data->name, refusal_text(result, text));
    }
    return failure ? failure : EXIT_DATA;
}

void deliver_unreadable(void)
{
    json_writer w;

    json_begin(&w, stdout);
    json_text(&w, "error", "unreadable");
    json_text(&w, "reason", message_last());
    json_parameters(&w, "undetermined", (1u << INVCAL_PARAMETERS) - 1);
    json_end(&w);
}

int deliver(const request *r, const calibrate_result *result)
{
    output files[2] = {{0}};
    int failure = begin_file(&files[0], r->value[OPT_OUT], write_calibration, r, result);

    failure =
        failure ? failure : begin_file(&files[1], r->value[OPT_REPORT], write_report, r, result);
    failure = failure ? failure : print(r, result);
    return output_end(files, 2, failure);
}
