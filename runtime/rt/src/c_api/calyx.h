#ifndef CALYX_H
#define CALYX_H

/*
 * Interface for programs in C and C++ that run models compiled by Calyx.
 *
 *     calyx_instance *pair = NULL;
 *     calyx_create(&spur_pair_model, &pair);
 *     calyx_set_in(pair, "torque", 100, "N*m");
 *     while ((status = calyx_step(pair)) == CALYX_OK)
 *         calyx_output(pair, spur_pair_output_transmission_error, &value);
 *     if (status != CALYX_END)
 *         the run failed: calyx_error(pair, &error) returns the reason
 *     calyx_free(pair);
 *
 * Every function that can fail returns a status, and calyx_error returns the last problem of an
 * instance. A function that fails does not write to its output arguments. No function ends the process
 * or changes its signal handlers. Strings are UTF-8. Only one thread at a time may use an instance,
 * except for calyx_cancel. Different instances are independent of each other.
 *
 * Former names, which work until version 0.2:
 *     CALYX_GIVEN   is now CALYX_INVALID_INPUT
 *     calyx_where   is now calyx_last_position
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Marks a former name; GCC and Clang warn where a program uses it. */
#if defined(__GNUC__) || defined(__clang__)
#define CALYX_DEPRECATED(message) __attribute__((deprecated(message)))
#else
#define CALYX_DEPRECATED(message)
#endif

/* Compiled model, a constant of the program. */
typedef struct calyx_model calyx_model;

/* Instance of a model, with its own params and results. */
typedef struct calyx_instance calyx_instance;

/* Result of a function. */
typedef enum calyx_status {
    /* The function succeeded. */
    CALYX_OK = 0,
    /* The run is complete: there is no further position. */
    CALYX_END = 1,
    /* An argument is invalid: an unknown name, a unit of another dimension, a value out of range. */
    CALYX_INVALID_INPUT = 2,
    /* The model or its analysis reported an error with these params. */
    CALYX_MODEL = 3,
    /* calyx_cancel ended the run. */
    CALYX_CANCELLED = 4,
    /* The run exceeded its limit of time or memory. */
    CALYX_LIMIT = 5,
    /* Calyx has a defect, or the machine refused a resource, such as a thread. */
    CALYX_INTERNAL = 6,
    /* A required pointer is NULL. */
    CALYX_NULL = 7,
    /* The model was compiled by another version of Calyx than that of the linked library. */
    CALYX_VERSION = 8
} calyx_status;

/* Former name of CALYX_INVALID_INPUT. */
#define CALYX_GIVEN CALYX_INVALID_INPUT

/* Returns the meaning of a status as a text, never NULL. */
const char *calyx_status_message(calyx_status status);

/* -- Instances --------------------------------------------------------------------------------- */

/* Creates an instance with the defaults of all params. Free it with calyx_free. */
calyx_status calyx_create(const calyx_model *model, calyx_instance **instance);

/* Creates another instance of the same model, with the defaults of all params. The two share only
   compiled code and cached structures. */
calyx_status calyx_create_like(const calyx_instance *instance, calyx_instance **another);

/* Stops the current run and frees the instance. Does nothing if the instance is NULL. */
void calyx_free(calyx_instance *instance);

/* Problem that the last failed function on an instance reported. */
typedef struct calyx_problem {
    calyx_status status;
    /* Diagnostic code for `calyx explain`, such as "E0603"; empty for invalid arguments. */
    const char *code;
    /* Problem and remedy; either may be empty. */
    const char *message;
    const char *help;
    /* Location in the model's source. Lines and columns are counted from 1; an empty name and 0 if the
       problem has no location. */
    const char *file;
    size_t line;
    size_t column;
    /* Message, help and the line of the source as text of several lines, to be shown to a user. */
    const char *report;
} calyx_problem;

/* Returns the last problem; its status is CALYX_OK if no function failed. The strings are valid until
   the next call with this instance. */
calyx_status calyx_error(const calyx_instance *instance, calyx_problem *problem);

/* -- Params ------------------------------------------------------------------------------------ */

/* Sets a param to a number in the unit of its default, for the next run. This function rejects a value
   out of range. If the range depends on other params, calyx_step rejects the value when it starts the
   run. */
calyx_status calyx_set(calyx_instance *instance, const char *param, double value);

/* Sets a param to a number in a unit, such as "N*m". */
calyx_status calyx_set_in(calyx_instance *instance, const char *param, double value, const char *unit);

/* Sets a param to TRUE or FALSE; 0 is FALSE. */
calyx_status calyx_set_bool(calyx_instance *instance, const char *param, int value);

/* Sets a param from a text: "0.5 mm", "TRUE", or the string itself. */
calyx_status calyx_set_text(calyx_instance *instance, const char *param, const char *text);

/* Resets a param to its default. */
calyx_status calyx_reset(calyx_instance *instance, const char *param);

/* Returns the value that a param has in the next run, in the unit of its default; 1 for TRUE and 0 for
   FALSE. */
calyx_status calyx_get(const calyx_instance *instance, const char *param, double *value);

/* -- Limits ------------------------------------------------------------------------------------ */

/* Limits the time of each run, s; 0 removes the limit. */
calyx_status calyx_limit_time(calyx_instance *instance, double seconds);

/* Limits the memory of the values of a run, and the memory of the process during an analysis, bytes; 0
   removes the limit. */
calyx_status calyx_limit_memory(calyx_instance *instance, uint64_t bytes);

/* Sets the function that receives each line that the model prints, without its line end. NULL, the
   default, discards the lines. A thread of the run calls the function, which must not use this
   instance. */
calyx_status calyx_on_print(calyx_instance *instance, void (*print)(const char *line, void *user), void *user);

/* -- Running ----------------------------------------------------------------------------------- */

/* Solves the next position. Starts a run with the current params if none is in progress. Returns
   CALYX_OK if the position is solved: its outputs are available. Returns CALYX_END if all positions are
   solved: summaries are available. */
calyx_status calyx_step(calyx_instance *instance);

/* Stops the current run. The next step starts another run. */
calyx_status calyx_stop(calyx_instance *instance);

/* Cancels the current run, from any thread: its step returns CALYX_CANCELLED. The caller must not free
   the instance before this function returns. */
calyx_status calyx_cancel(const calyx_instance *instance);

/* A solved position. */
typedef struct calyx_position {
    /* Index, from 0. */
    size_t index;
    /* Number of positions of the run. */
    size_t count;
    /* Time, s. */
    double time;
    /* Fraction of the mesh cycle, 0 to 1. */
    double cycle;
    /* Roll angle of the entering tooth of the first gear, rad. */
    double roll_angle;
    /* Name of the characteristic point of the path of contact, such as "HPSTC"; empty at other
       positions. The string is valid until the next step. */
    const char *point;
} calyx_position;

/* Returns the last solved position. */
calyx_status calyx_last_position(const calyx_instance *instance, calyx_position *position);

/* Former name of calyx_last_position. */
CALYX_DEPRECATED("use calyx_last_position")
calyx_status calyx_where(const calyx_instance *instance, calyx_position *position);

/* Returns an output at that position, in the unit in which the model displays it. */
calyx_status calyx_output(const calyx_instance *instance, size_t output, double *value);

/* Returns an output at that position, in a given unit. */
calyx_status calyx_output_in(const calyx_instance *instance, size_t output, const char *unit, double *value);

/* Statistics of an output over all positions of a run. */
typedef struct calyx_summary {
    double min;
    double max;
    /* Mean over time. */
    double mean;
    /* Difference of max and min. */
    double peak_to_peak;
    /* Index of the position of the maximum. */
    size_t max_at;
} calyx_summary;

/* Returns the summary of an output over all positions of the last completed run, in the unit in which
   the model displays it. */
calyx_status calyx_summarize(const calyx_instance *instance, size_t output, calyx_summary *summary);

/* Returns the summary in a given unit. */
calyx_status calyx_summarize_in(
    const calyx_instance *instance, size_t output, const char *unit, calyx_summary *summary);

/* -- Description of a model -------------------------------------------------------------------- */

/* Description of a param. */
typedef struct calyx_param_info {
    const char *name;
    const char *doc;
    /* Unit of the default, of the range and of calyx_set; empty for pure numbers and for params that are
       not numbers. */
    const char *unit;
    /* Default and range in that unit. NAN for strings, and for limits that the param does not have. */
    double default_value;
    double low;
    double high;
} calyx_param_info;

/* Description of an output. */
typedef struct calyx_output_info {
    const char *name;
    const char *doc;
    /* Unit of calyx_output. */
    const char *unit;
} calyx_output_info;

/* Return the number of params and of outputs; 0 if the instance is NULL. */
size_t calyx_param_count(const calyx_instance *instance);
size_t calyx_output_count(const calyx_instance *instance);

/* Return the description of the param or output with an index. The strings are valid until the instance
   is freed. */
calyx_status calyx_param_at(const calyx_instance *instance, size_t param, calyx_param_info *info);
calyx_status calyx_output_at(const calyx_instance *instance, size_t output, calyx_output_info *info);

/* Returns the index of the output with this name. */
calyx_status calyx_output_named(const calyx_instance *instance, const char *name, size_t *output);

#ifdef __cplusplus
}
#endif

#endif
