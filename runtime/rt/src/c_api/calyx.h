#ifndef CALYX_H
#define CALYX_H

/*
 * Models compiled by Calyx, run by programs in C and C++.
 *
 *     calyx_instance *pair = NULL;
 *     calyx_create(&spur_pair_model, &pair);
 *     calyx_set_in(pair, "torque", 100, "N*m");
 *     while ((status = calyx_step(pair)) == CALYX_OK)
 *         calyx_output(pair, spur_pair_output_transmission_error, &value);
 *     if (status != CALYX_END)
 *         the run failed: calyx_error(pair, &error) says why
 *     calyx_free(pair);
 *
 * Every function that can fail returns a status; what went wrong with an instance is told by calyx_error. Nothing ends the
 * process, and a function that fails leaves what it should have stored untouched. Texts are UTF-8. An instance is used by
 * one thread at a time, except by calyx_cancel; different instances are independent of each other. Signals of the process
 * are left alone.
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A compiled model: constant data of the program. */
typedef struct calyx_model calyx_model;

/* A model with values of its own. */
typedef struct calyx_instance calyx_instance;

typedef enum calyx_status {
    CALYX_OK = 0,
    /* The run is complete: there is no further position. */
    CALYX_END = 1,
    /* What was given cannot be used: an unknown name, a unit of another dimension, a value out of range. */
    CALYX_GIVEN = 2,
    /* The model or its analysis failed at these params. */
    CALYX_MODEL = 3,
    /* calyx_cancel ended the run. */
    CALYX_CANCELLED = 4,
    /* The run used up its time or memory. */
    CALYX_LIMIT = 5,
    /* A defect of Calyx, or this machine refused what a run needs. */
    CALYX_INTERNAL = 6,
    /* A pointer is NULL where something must be. */
    CALYX_NULL = 7,
    /* The model was compiled by another version of Calyx than the library it is linked with. */
    CALYX_VERSION = 8
} calyx_status;

/* What a status means, as a sentence. It is never NULL. */
const char *calyx_status_message(calyx_status status);

/* -- Instances ---------------------------------------------------------------------------------------------------------- */

/* Makes an instance with all params at their defaults. It is freed by calyx_free. */
calyx_status calyx_create(const calyx_model *model, calyx_instance **instance);

/* Makes another instance of the same model, with all params at their defaults. The two share what makes running several of
   one model cheap, and nothing else. */
calyx_status calyx_create_like(const calyx_instance *instance, calyx_instance **another);

/* Ends a run under way and frees the instance. NULL is nothing to free. */
void calyx_free(calyx_instance *instance);

/* Why the last function that failed with this instance did so. */
typedef struct calyx_problem {
    calyx_status status;
    /* By which `calyx explain` says more, like "E0603"; empty for what was given wrong. */
    const char *code;
    /* What is wrong, and what to do about it; either may be empty. */
    const char *message;
    const char *help;
    /* Where in the model's source, counted from 1; an empty name and 0 if it is nowhere there. */
    const char *file;
    size_t line;
    size_t column;
    /* All of it for people, in several lines, with the line of the source. */
    const char *report;
} calyx_problem;

/* Tells the last problem; status is CALYX_OK if there was none. The texts stay until the next call with this instance. */
calyx_status calyx_error(const calyx_instance *instance, calyx_problem *problem);

/* -- Params ------------------------------------------------------------------------------------------------------------- */

/* Sets a param to a number in the unit of its default. What is set counts from the next run on. A value out of range is
   refused: here, or when that run begins if the range depends on other params. */
calyx_status calyx_set(calyx_instance *instance, const char *param, double value);

/* Sets a param to a number in a unit, like "N*m". */
calyx_status calyx_set_in(calyx_instance *instance, const char *param, double value, const char *unit);

/* Sets a param that is TRUE or FALSE; 0 is FALSE. */
calyx_status calyx_set_bool(calyx_instance *instance, const char *param, int value);

/* Sets a param to what a text says: "0.5 mm", "TRUE", or the string itself. */
calyx_status calyx_set_text(calyx_instance *instance, const char *param, const char *text);

/* Gives a param its default again. */
calyx_status calyx_reset(calyx_instance *instance, const char *param);

/* What a param would be in a run, in the unit of its default; 1 and 0 for TRUE and FALSE. */
calyx_status calyx_get(const calyx_instance *instance, const char *param, double *value);

/* -- Limits ------------------------------------------------------------------------------------------------------------- */

/* How long each run may take, in seconds; 0 for as long as it likes. */
calyx_status calyx_limit_time(calyx_instance *instance, double seconds);

/* Bytes that a run's values may take, and the whole process while it analyses; 0 for any number. */
calyx_status calyx_limit_memory(calyx_instance *instance, uint64_t bytes);

/* What takes the lines that the model prints, each without its end; NULL to drop them, as at first. It is called while a run
   goes on, by a thread of the run, and must not call functions of this instance. */
calyx_status calyx_on_print(calyx_instance *instance, void (*print)(const char *line, void *user), void *user);

/* -- Running ------------------------------------------------------------------------------------------------------------ */

/* Solves the next position. If no run is under way it begins one, with the params as they are set. CALYX_OK: a position is
   solved and can be read. CALYX_END: all were, and summaries can be read. */
calyx_status calyx_step(calyx_instance *instance);

/* Ends a run under way; the next step begins another. */
calyx_status calyx_stop(calyx_instance *instance);

/* Ends the run under way soon, from any thread: its step returns CALYX_CANCELLED. The instance must not be freed meanwhile. */
calyx_status calyx_cancel(const calyx_instance *instance);

typedef struct calyx_position {
    /* From 0. */
    size_t index;
    /* Positions of the run. */
    size_t count;
    /* s */
    double time;
    /* Part of the mesh cycle. */
    double cycle;
    /* rad */
    double roll_angle;
    /* Name of a characteristic point; empty for all others. It stays until the next step. */
    const char *point;
} calyx_position;

/* The position that was solved last. */
calyx_status calyx_where(const calyx_instance *instance, calyx_position *position);

/* An output at that position, in the unit the model shows it in. */
calyx_status calyx_output(const calyx_instance *instance, size_t output, double *value);

/* An output at that position, in a unit of one's choice. */
calyx_status calyx_output_in(const calyx_instance *instance, size_t output, const char *unit, double *value);

typedef struct calyx_summary {
    double min;
    double max;
    /* Over time. */
    double mean;
    double peak_to_peak;
    /* Index of the position of the maximum. */
    size_t max_at;
} calyx_summary;

/* An output over all positions of the run that was completed last, in the unit the model shows it in. */
calyx_status calyx_summarize(const calyx_instance *instance, size_t output, calyx_summary *summary);

/* The same in a unit of one's choice. */
calyx_status calyx_summarize_in(
    const calyx_instance *instance, size_t output, const char *unit, calyx_summary *summary);

/* -- What a model says of itself ---------------------------------------------------------------------------------------- */

typedef struct calyx_param_info {
    const char *name;
    const char *doc;
    /* Of the default and of the range, and what calyx_set counts in; empty for pure numbers and what is no number. */
    const char *unit;
    /* NAN for what is not there: of texts, and of params without a range. */
    double default_value;
    double low;
    double high;
} calyx_param_info;

typedef struct calyx_output_info {
    const char *name;
    const char *doc;
    /* What calyx_output counts in. */
    const char *unit;
} calyx_output_info;

/* How many params and outputs there are; 0 if the instance is NULL. */
size_t calyx_param_count(const calyx_instance *instance);
size_t calyx_output_count(const calyx_instance *instance);

/* The texts stay as long as the instance. */
calyx_status calyx_param_at(const calyx_instance *instance, size_t param, calyx_param_info *info);
calyx_status calyx_output_at(const calyx_instance *instance, size_t output, calyx_output_info *info);

/* The output of a name. */
calyx_status calyx_output_named(const calyx_instance *instance, const char *name, size_t *output);

#ifdef __cplusplus
}
#endif

#endif
