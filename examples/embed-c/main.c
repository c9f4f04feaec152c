/* The spur pair of ../spur_pair.cx in a C program: sets params, solves one mesh cycle position by
   position, and reads the results. The model and the engine are in libspur_pair.a; spur_pair.h
   declares the params and outputs of the model. */

#include "spur_pair.h"

#include <stdio.h>
#include <stdlib.h>

/* Prints an error, if there is one, and ends the program. */
static void check(const calyx_instance *pair, calyx_status status)
{
    calyx_problem problem;

    if (status == CALYX_OK || status == CALYX_END)
        return;
    if (calyx_error(pair, &problem) == CALYX_OK && problem.status == status)
        fputs(problem.report, stderr);
    else
        fprintf(stderr, "error: %s\n", calyx_status_message(status));
    exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    const double steps = argc > 1 ? atof(argv[1]) : 8;
    calyx_instance *pair = NULL;
    calyx_problem problem;
    calyx_position at;
    calyx_summary error;
    calyx_status status;

    check(pair, calyx_create(&spur_pair_model, &pair));

    /* A length is not a torque: nothing is set, and the error describes the valid values. */
    if (calyx_set_in(pair, "torque", 5, "mm") == CALYX_INVALID_INPUT && calyx_error(pair, &problem) == CALYX_OK)
        printf("refused: %s\n         %s\n\n", problem.message, problem.help);

    check(pair, calyx_set_in(pair, "torque", 100, "N*m"));
    check(pair, calyx_set(pair, "steps", steps));
    check(pair, calyx_set_text(pair, "fidelity", "plane"));
    check(pair, calyx_set_bool(pair, "tip_corner_contact", 0));

    printf("roll angle   load share   transmission error   root stress of the pinion\n");
    printf("       rad                                um                         MPa\n");
    while ((status = calyx_step(pair)) == CALYX_OK) {
        double share, lag, stress;

        check(pair, calyx_last_position(pair, &at));
        check(pair, calyx_output(pair, spur_pair_output_load_share, &share));
        check(pair, calyx_output_in(pair, spur_pair_output_transmission_error_length, "um", &lag));
        check(pair, calyx_output_in(pair, spur_pair_output_max_root_stress_pinion, "MPa", &stress));
        printf("%10.4f   %10.4f   %18.3f   %25.1f\n", at.roll_angle, share, lag, stress);
    }
    check(pair, status);

    check(pair, calyx_summarize_in(pair, spur_pair_output_transmission_error_length, "um", &error));
    printf("\npeak-to-peak transmission error: %.3f um\n", error.peak_to_peak);

    calyx_free(pair);
    return EXIT_SUCCESS;
}
