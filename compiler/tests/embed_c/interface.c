/* Tests every function of the C interface, with valid and invalid arguments and two models in one
   program. The program prints nothing and returns 0 on success. Without an argument it skips the
   slow part: the analysis of the spur pair. */

#include "small.h"
#include "spur_pair.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const calyx_model foreign_model;

/* Reports a condition that is false with its line, and ends the program. */
#define HOLDS(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                                            \
            exit(EXIT_FAILURE);                                                                                        \
        }                                                                                                              \
    } while (0)

static void take_line(const char *line, void *user)
{
    strcat((char *)user, line);
    strcat((char *)user, "\n");
}

static void null_pointers(void)
{
    calyx_instance *small = NULL;
    calyx_problem problem;
    double value = 7;

    HOLDS(calyx_create(NULL, &small) == CALYX_NULL && small == NULL);
    HOLDS(calyx_create(&small_model, NULL) == CALYX_NULL);
    HOLDS(calyx_create_like(NULL, &small) == CALYX_NULL && small == NULL);
    calyx_free(NULL);
    HOLDS(calyx_step(NULL) == CALYX_NULL && calyx_stop(NULL) == CALYX_NULL && calyx_cancel(NULL) == CALYX_NULL);
    HOLDS(calyx_set(NULL, "x", 1) == CALYX_NULL && calyx_get(NULL, "x", &value) == CALYX_NULL);
    HOLDS(calyx_error(NULL, &problem) == CALYX_NULL);
    HOLDS(calyx_param_count(NULL) == 0 && calyx_output_count(NULL) == 0);

    HOLDS(calyx_create(&small_model, &small) == CALYX_OK);
    HOLDS(calyx_error(small, NULL) == CALYX_NULL);
    HOLDS(calyx_error(small, &problem) == CALYX_OK && problem.status == CALYX_OK && problem.report[0] == '\0');
    HOLDS(calyx_set(small, NULL, 1) == CALYX_INVALID_INPUT);
    HOLDS(calyx_error(small, &problem) == CALYX_OK && problem.status == CALYX_INVALID_INPUT);
    HOLDS(strcmp(problem.message, "the name of the param is NULL") == 0);
    HOLDS(calyx_set_in(small, "x", 1, NULL) == CALYX_INVALID_INPUT && calyx_set_text(small, "x", NULL) == CALYX_INVALID_INPUT);
    HOLDS(calyx_get(small, "x", NULL) == CALYX_INVALID_INPUT && calyx_last_position(small, NULL) == CALYX_INVALID_INPUT);
    HOLDS(calyx_param_at(small, 0, NULL) == CALYX_INVALID_INPUT && calyx_output_named(small, NULL, NULL) == CALYX_INVALID_INPUT);
    HOLDS(calyx_create_like(small, NULL) == CALYX_INVALID_INPUT);
    HOLDS(calyx_set_text(small, "x", "\xff\xfe") == CALYX_INVALID_INPUT);
    HOLDS(calyx_error(small, &problem) == CALYX_OK && strcmp(problem.message, "the text is not UTF-8") == 0);
    HOLDS(value == 7);
    calyx_free(small);
}

static void params_and_printing(void)
{
    calyx_instance *small = NULL, *other = NULL;
    calyx_param_info info;
    calyx_output_info output;
    calyx_problem problem;
    calyx_position position;
    calyx_summary summary;
    char printed[200] = "";
    double value;
    size_t index;

    HOLDS(calyx_create(&small_model, &small) == CALYX_OK);
    HOLDS(calyx_create_like(small, &other) == CALYX_OK);
    HOLDS(calyx_param_count(small) == small_params && small_params == 4 && calyx_output_count(small) == small_outputs);
    HOLDS(calyx_param_at(small, small_param_x, &info) == CALYX_OK);
    HOLDS(strcmp(info.name, "x") == 0 && strcmp(info.unit, "mm") == 0 && strcmp(info.doc, "Says how far. */") == 0);
    HOLDS(info.default_value == 2 && info.low == 0 && info.high == 100);
    HOLDS(calyx_param_at(small, small_param_word, &info) == CALYX_OK && isnan(info.default_value));
    HOLDS(calyx_param_at(small, 4, &info) == CALYX_INVALID_INPUT);
    HOLDS(calyx_output_at(small, 0, &output) == CALYX_INVALID_INPUT && calyx_output_named(small, "y", &index) == CALYX_INVALID_INPUT);

    HOLDS(calyx_get(small, "x", &value) == CALYX_OK && value == 2);
    HOLDS(calyx_set(small, "x", 3) == CALYX_OK && calyx_get(small, "x", &value) == CALYX_OK && value == 3);
    HOLDS(calyx_get(other, "x", &value) == CALYX_OK && value == 2);
    HOLDS(calyx_set_in(small, "x", 1, "inch") == CALYX_OK && calyx_get(small, "x", &value) == CALYX_OK);
    HOLDS(fabs(value - 25.4) < 1e-12);
    HOLDS(calyx_set_in(small, "x", 1, "N") == CALYX_INVALID_INPUT);
    HOLDS(calyx_error(small, &problem) == CALYX_OK && strstr(problem.message, "that is a force, and"));
    HOLDS(strstr(problem.help, "`x` takes 0 mm .. 100 mm") && strstr(problem.report, "error: `x` cannot be"));
    HOLDS(calyx_set(small, "z", 1) == CALYX_INVALID_INPUT && calyx_error(small, &problem) == CALYX_OK);
    HOLDS(strstr(problem.message, "no param called `z`") && problem.file[0] == '\0' && problem.line == 0);
    HOLDS(calyx_reset(small, "x") == CALYX_OK && calyx_get(small, "x", &value) == CALYX_OK && value == 2);
    HOLDS(calyx_set_bool(small, "on", 1) == CALYX_OK && calyx_get(small, "on", &value) == CALYX_OK && value == 1);
    HOLDS(calyx_set_bool(small, "x", 1) == CALYX_INVALID_INPUT && calyx_get(small, "word", &value) == CALYX_INVALID_INPUT);
    HOLDS(calyx_set_text(small, "word", "other") == CALYX_OK && calyx_set_text(small, "x", "0.5 mm") == CALYX_OK);
    HOLDS(calyx_set_text(small, "word", "none") == CALYX_INVALID_INPUT);

    HOLDS(calyx_last_position(small, &position) == CALYX_INVALID_INPUT && calyx_summarize(small, 0, &summary) == CALYX_INVALID_INPUT);
    HOLDS(calyx_on_print(small, take_line, printed) == CALYX_OK);
    HOLDS(calyx_step(small) == CALYX_END);
    HOLDS(strcmp(printed, "0.5 mm other TRUE\n") == 0);
    HOLDS(calyx_on_print(small, NULL, NULL) == CALYX_OK && calyx_step(small) == CALYX_END);
    HOLDS(strcmp(printed, "0.5 mm other TRUE\n") == 0);

    /* An error of the model has a code and a source location. */
    HOLDS(calyx_set(small, "n", 7) == CALYX_OK && calyx_step(small) == CALYX_MODEL);
    HOLDS(calyx_error(small, &problem) == CALYX_OK && problem.status == CALYX_MODEL);
    HOLDS(strcmp(problem.code, "E0701") == 0 && strstr(problem.file, "small.cx"));
    HOLDS(problem.line == 13 && problem.column > 1 && strstr(problem.report, "small.cx:13:"));
    /* A range that depends on other params is checked when a run begins. */
    HOLDS(calyx_set(small, "x", 101) == CALYX_INVALID_INPUT && calyx_error(small, &problem) == CALYX_OK);
    HOLDS(strstr(problem.message, "outside its range"));
    HOLDS(calyx_set(small, "x", 60) == CALYX_OK && calyx_step(small) == CALYX_INVALID_INPUT);
    HOLDS(calyx_error(small, &problem) == CALYX_OK && strstr(problem.message, "outside its range"));
    HOLDS(calyx_reset(small, "n") == CALYX_OK);

    HOLDS(calyx_limit_time(small, -1) == CALYX_INVALID_INPUT && calyx_limit_time(small, NAN) == CALYX_INVALID_INPUT);
    HOLDS(calyx_set(small, "x", 50) == CALYX_OK && calyx_limit_time(small, 0.05) == CALYX_OK);
    HOLDS(calyx_step(small) == CALYX_LIMIT && calyx_error(small, &problem) == CALYX_OK);
    HOLDS(strcmp(problem.code, "E0707") == 0);
    HOLDS(calyx_limit_time(small, 0) == CALYX_OK && calyx_limit_memory(small, 1000000) == CALYX_OK);
    HOLDS(calyx_set(small, "x", 51) == CALYX_OK && calyx_step(small) == CALYX_LIMIT);
    HOLDS(calyx_limit_memory(small, 0) == CALYX_OK && calyx_stop(small) == CALYX_OK);
    calyx_free(small);
    /* The other instance outlives it. */
    HOLDS(calyx_step(other) == CALYX_END);
    calyx_free(other);
}

static void positions(void)
{
    calyx_instance *pair = NULL;
    calyx_output_info output;
    calyx_position position;
    calyx_summary summary, in_arcsec;
    calyx_status status;
    double value, radians, most = -HUGE_VAL, least = HUGE_VAL;
    size_t index, seen = 0, most_at = 0;

    HOLDS(calyx_create(&spur_pair_model, &pair) == CALYX_OK);
    HOLDS(calyx_output_named(pair, "transmission_error", &index) == CALYX_OK);
    HOLDS(index == spur_pair_output_transmission_error);
    HOLDS(calyx_output_at(pair, index, &output) == CALYX_OK && strcmp(output.name, "transmission_error") == 0);
    HOLDS(calyx_set_text(pair, "fidelity", "plane") == CALYX_OK);
    HOLDS(calyx_set(pair, "steps", 2) == CALYX_OK && calyx_output(pair, index, &value) == CALYX_INVALID_INPUT);
    while (calyx_step(pair) == CALYX_OK) {
        HOLDS(calyx_last_position(pair, &position) == CALYX_OK && position.index == seen && position.count > seen);
        HOLDS(calyx_output(pair, index, &value) == CALYX_OK);
        HOLDS(calyx_output_in(pair, index, "rad", &radians) == CALYX_OK && radians != 0);
        HOLDS(calyx_output_in(pair, index, "N", &radians) == CALYX_INVALID_INPUT);
        HOLDS(calyx_output(pair, spur_pair_outputs, &radians) == CALYX_INVALID_INPUT);
        if (value > most) {
            most = value;
            most_at = seen;
        }
        least = fmin(least, value);
        seen++;
    }
    HOLDS(seen == position.count && seen > 2);
    HOLDS(calyx_summarize(pair, index, &summary) == CALYX_OK);
    HOLDS(summary.max == most && summary.min == least && summary.max_at == most_at);
    HOLDS(summary.mean > least && summary.mean < most && summary.peak_to_peak > 0);
    HOLDS(calyx_summarize_in(pair, index, "arcsec", &in_arcsec) == CALYX_OK);
    /* The unit of the output is urad. */
    HOLDS(fabs(in_arcsec.peak_to_peak * 4.84813681109536 / summary.peak_to_peak - 1) < 1e-12);

    /* A cancelled run returns this error, and the next one starts from the beginning. */
    HOLDS(calyx_step(pair) == CALYX_OK && calyx_cancel(pair) == CALYX_OK);
    /* Positions that are already solved may precede the error. */
    do
        status = calyx_step(pair);
    while (status == CALYX_OK);
    HOLDS(status == CALYX_CANCELLED);
    HOLDS(calyx_summarize(pair, index, &summary) == CALYX_INVALID_INPUT);
    HOLDS(calyx_step(pair) == CALYX_OK && calyx_last_position(pair, &position) == CALYX_OK && position.index == 0);
    /* Destroying an instance ends its current run. */
    calyx_free(pair);
}

/* Former names have the meaning of the current ones. */
static void former_names(void)
{
    calyx_instance *small = NULL;
    calyx_position position;

    HOLDS(CALYX_GIVEN == CALYX_INVALID_INPUT && CALYX_GIVEN == 2);
    HOLDS(calyx_create(&small_model, &small) == CALYX_OK);
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#endif
    HOLDS(calyx_where(NULL, &position) == CALYX_NULL && calyx_where(small, NULL) == CALYX_INVALID_INPUT);
    HOLDS(calyx_where(small, &position) == CALYX_GIVEN);
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic pop
#endif
    calyx_free(small);
}

int main(int argc, char **argv)
{
    calyx_instance *foreign = NULL;

    (void)argv;
    HOLDS(calyx_create(&foreign_model, &foreign) == CALYX_VERSION && foreign == NULL);
    HOLDS(strstr(calyx_status_message(CALYX_VERSION), "another version of Calyx"));
    HOLDS(strcmp(calyx_status_message((calyx_status)99), "unknown status") == 0);
    null_pointers();
    former_names();
    params_and_printing();
    if (argc > 1)
        positions();
    return 0;
}
