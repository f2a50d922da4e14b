/* SPDX-License-Identifier: MIT */
/*
 * Plays one clip and fades to another, as a game would: prints the packets that a vertex shader gets, and
 * where the shader then shows one bone, eight times a second.
 *
 *     c_play FILE.posepack CLIP NEXT_CLIP [BONE]
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "posepack/play.h"

/* The game has run for two days when the clip starts; a second later it fades, through half a second. */
#define START_S 172800.0
#define CHANGE_S (START_S + 1.0)
#define FADE_S 0.5
#define FRAME_S 0.125

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

static void print_packet(const posepack_view* view, const posepack_play* play) {
    float p[8];
    if (posepack_pack_play(view, play, POSEPACK_CLOCK_S, p) != POSEPACK_OK) return;
    printf(
        "packet: clip %g, %g cycles/s, phase %g at clock %g | before: clip %g, %g cycles/s, phase %g, fade "
        "%g s\n",
        (double)p[0], (double)p[1], (double)p[2], (double)p[3], (double)p[4], (double)p[5], (double)p[6],
        (double)p[7]);
}

/* One line of what is shown, and how far the bone's bind-pose origin has moved since the frame before. */
static posepack_result print_moment(const posepack_view* view, const posepack_play* play, double time_s,
                                    uint32_t bone) {
    posepack_moment now, before;
    float m[12], previous[12];
    posepack_result result = posepack_find_moment(view, play, time_s, &now);
    if (result == POSEPACK_OK) result = posepack_find_moment(view, play, time_s - FRAME_S, &before);
    if (result == POSEPACK_OK) result = posepack_show_bone(view, &now, bone, m);
    if (result == POSEPACK_OK) result = posepack_show_bone(view, &before, bone, previous);
    if (result != POSEPACK_OK) return result;
    printf("%7.3f s  clip %" PRIu32
           " phase %.4f factor %.2f  translation %8.4f %8.4f %8.4f  moved %8.4f %8.4f %8.4f\n",
           time_s - START_S, now.clip, (double)now.phase, (double)now.factor, (double)m[3], (double)m[7],
           (double)m[11], (double)(m[3] - previous[3]), (double)(m[7] - previous[7]),
           (double)(m[11] - previous[11]));
    return POSEPACK_OK;
}

static posepack_result play_clips(const posepack_view* view, const char* first, const char* next,
                                  uint32_t bone) {
    posepack_track track;
    posepack_play play;
    uint32_t clip, next_clip;
    uint64_t steps = 0;
    int frame;
    posepack_result result = posepack_find_clip(view, first, &clip);
    if (result == POSEPACK_OK) result = posepack_find_clip(view, next, &next_clip);
    if (result == POSEPACK_OK) {
        result = posepack_start_track(view, clip, 1.0, posepack_spread_phase(7), START_S, POSEPACK_CLOCK_S,
                                      &track);
    }
    if (result != POSEPACK_OK) return result;
    posepack_start_play(&play, &track);
    print_packet(view, &play);
    for (frame = 0; frame <= 16 && result == POSEPACK_OK; ++frame) {
        const double time_s = START_S + frame * FRAME_S;
        if (time_s == CHANGE_S) {
            result = posepack_start_track(view, next_clip, 1.0, 0.0, time_s, POSEPACK_CLOCK_S, &track);
            if (result == POSEPACK_OK) result = posepack_fade_play(&play, &track, FADE_S);
            if (result == POSEPACK_OK) print_packet(view, &play);
        }
        if (result == POSEPACK_OK) result = print_moment(view, &play, time_s, bone);
    }
    if (result == POSEPACK_OK) {
        result = posepack_count_passes(view, &play.now, 0.0, START_S, START_S + 60.0, &steps);
        printf("in a minute it begins %" PRIu64 " times\n", steps);
    }
    return result;
}

int main(int argument_count, char** arguments) {
    posepack_view view;
    size_t size = 0;
    void* bytes = argument_count == 4 || argument_count == 5 ? read_file(arguments[1], &size) : NULL;
    posepack_result result;
    uint32_t bone = 0;
    if (bytes == NULL) {
        fprintf(stderr, "usage: c_play FILE.posepack CLIP NEXT_CLIP [BONE] (a file that can be read)\n");
        return 2;
    }
    result = posepack_open(&view, bytes, size);
    if (result == POSEPACK_OK && argument_count == 5) result = posepack_find_bone(&view, arguments[4], &bone);
    if (result == POSEPACK_OK) result = play_clips(&view, arguments[2], arguments[3], bone);
    if (result != POSEPACK_OK) fprintf(stderr, "%s: %s\n", arguments[1], posepack_result_name(result));
    free(bytes);
    return result == POSEPACK_OK ? 0 : 1;
}
