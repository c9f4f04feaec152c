/* Prints the seconds that CHOLMOD takes to order and to factorize a symmetric matrix, and the number
   of entries of its factor. It is a reference for the factorization benchmark and not part of the
   program. The input file contains, with eight bytes each in native byte order: the size, the number
   of entries, the column starts, the rows and the values of the lower triangle. */
#include <cholmod.h>
#include <stdio.h>
#include <time.h>

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
}

int main(int count, char **arguments) {
    FILE *file = count == 2 ? fopen(arguments[1], "rb") : NULL;
    SuiteSparse_long size[2];
    if (!file || fread(size, 8, 2, file) != 2) return 2;
    cholmod_common common;
    cholmod_l_start(&common);
    cholmod_sparse *matrix = cholmod_l_allocate_sparse(size[0], size[0], size[1], 1, 1, -1, CHOLMOD_REAL, &common);
    if (!matrix || fread(matrix->p, 8, size[0] + 1, file) != (size_t)(size[0] + 1)
        || fread(matrix->i, 8, size[1], file) != (size_t)size[1]
        || fread(matrix->x, 8, size[1], file) != (size_t)size[1]) return 2;
    fclose(file);
    double start = now();
    cholmod_factor *factor = cholmod_l_analyze(matrix, &common);
    double analysed = now();
    cholmod_l_factorize(matrix, factor, &common);
    double factorised = now();
    if (common.status != CHOLMOD_OK) return 1;
    printf("%.4f %.4f %.4e\n", analysed - start, factorised - analysed, common.lnz);
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_free_sparse(&matrix, &common);
    cholmod_l_finish(&common);
    return 0;
}
