/* SPDX-License-Identifier: MIT */
/*
 * Loads a palette with stdio, lists its clips and decodes one matrix, whatever the row scheme.
 *
 *     c_loader FILE.posepack
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "posepack/loader.h"

/* The whole file in memory; free() it. Null if it cannot be read. */
static void* read_file(const char* path, size_t* size) {
    FILE* file = fopen(path, "rb");
    void* bytes = NULL;
    long end;
    if (file == NULL) return NULL;
    if (fseek(file, 0, SEEK_END) == 0 && (end = ftell(file)) > 0 && fseek(file, 0, SEEK_SET) == 0) {
        *size = (size_t)end;
        bytes = malloc(*size);
    }
    if (bytes != NULL && fread(bytes, 1, *size, file) != *size) {
        free(bytes);
        bytes = NULL;
    }
    fclose(file);
    return bytes;
}

int main(int argument_count, char** arguments) {
    posepack_view view;
    posepack_clip clip;
    float m[12];
    size_t size = 0;
    void* bytes = argument_count == 2 ? read_file(arguments[1], &size) : NULL;
    posepack_result result;
    uint32_t i;
    if (bytes == NULL) {
        fprintf(stderr, "usage: c_loader FILE.posepack (a file that can be read)\n");
        return 2;
    }
    result = posepack_open(&view, bytes, size);
    if (result != POSEPACK_OK) {
        fprintf(stderr, "%s: %s\n", arguments[1], posepack_result_name(result));
        free(bytes);
        return 1;
    }
    for (i = 0; posepack_get_clip(&view, i, &clip) == POSEPACK_OK; ++i) {
        printf("%-20.*s %5" PRIu32 " rows at %g Hz, %g s\n", (int)clip.name.size_bytes, clip.name.data,
               clip.row_count, (double)clip.rate_hz, (double)clip.period_s);
    }
    /* The skinning matrix of bone 0 where the first clip begins. */
    posepack_sample_bone(&view, 0, 0.0f, 0, m);
    for (i = 0; i < 12; i += 4) {
        printf("%10g %10g %10g %10g\n", (double)m[i], (double)m[i + 1], (double)m[i + 2], (double)m[i + 3]);
    }
    free(bytes);
    return 0;
}
