/* SPDX-License-Identifier: MIT */
/* Plays as the floats that shaders get, in posepack's layouts and those of others. */
#include "format/half.h"
#include "loader/timing.h"

static const double kHalvesACycle = 2048.0; /* whole numbers up to here are exact in 16-bit floats */

static int is_clock(double clock_s) {
    return posepack_is_finite(clock_s) && clock_s > 0.0;
}

static float half_of(double x) {
    return posepack_float_from_half(posepack_half_from_float((float)x));
}

static int survives(float x) {
    return half_of((double)x) == x;
}

/*
 * A track on the clock of a shader: clip, cycles a second, cycles at a start on that clock, and that start.
 * Starts are multiples of grain_s, or floats where that is 0: the cycles take up the difference.
 */
typedef struct on_clock {
    posepack_clip clip;
    double cycle_hz, cycles, clock_start_s;
} on_clock;

static posepack_result put_on_clock(const posepack_view* view, const posepack_track* track, double start_s,
                                    double clock_s, double grain_s, on_clock* out) {
    const double exact_s = posepack_modulo(start_s, clock_s);
    const posepack_result result = posepack_get_clip(view, track->clip, &out->clip);
    double shown_s = grain_s > 0.0 ? grain_s * posepack_floor(exact_s / grain_s) : (double)(float)exact_s;
    if (result != POSEPACK_OK) return result;
    out->clock_start_s = shown_s < clock_s ? shown_s : 0.0;
    out->cycle_hz = track->cycle_hz;
    if (posepack_has_ended(out->clip.wrap, track, start_s)) {
        out->cycles = out->cycle_hz > 0.0 ? 1.0 : 0.0;
        out->cycle_hz = 0.0;
    } else {
        out->cycles = posepack_fold_cycles(
            out->clip.wrap, posepack_count_cycles(track, start_s) + track->cycle_hz * (shown_s - exact_s));
    }
    return POSEPACK_OK;
}

/* Cycles as the float that is sent: of a loop below 1, where rounding up would leave the cycle. */
static float sent_cycles(const on_clock* track) {
    return track->clip.wrap == POSEPACK_WRAP_LOOP ? posepack_wrap_phase(POSEPACK_WRAP_LOOP, track->cycles)
                                                  : (float)track->cycles;
}

posepack_result posepack_pack_play(const posepack_view* view, const posepack_play* play, double clock_s,
                                   float packet[8]) {
    on_clock track;
    posepack_result result;
    if (play == NULL || packet == NULL || !is_clock(clock_s)) return POSEPACK_ERROR_ARG;
    result = put_on_clock(view, &play->now, play->now.start_s, clock_s, 0.0, &track);
    if (result != POSEPACK_OK) return result;
    packet[0] = (float)play->now.clip;
    packet[1] = (float)track.cycle_hz;
    packet[2] = sent_cycles(&track);
    packet[3] = (float)track.clock_start_s;
    packet[4] = -1.0f;
    packet[5] = packet[6] = packet[7] = 0.0f;
    if (play->before.clip == POSEPACK_NONE) return POSEPACK_OK;
    result = put_on_clock(view, &play->before, play->now.start_s, clock_s, 0.0, &track);
    if (result != POSEPACK_OK) return result;
    packet[4] = (float)play->before.clip;
    packet[5] = (float)track.cycle_hz;
    packet[6] = sent_cycles(&track);
    packet[7] = (float)play->fade_s;
    return POSEPACK_OK;
}

/* Three numbers of a track for 16-bit floats. */
static posepack_result pack_half_track(const posepack_view* view, const posepack_track* track, double start_s,
                                       double clock_s, float out[4]) {
    on_clock placed;
    const double grain_s = clock_s / kHalvesACycle;
    const posepack_result result = put_on_clock(view, track, start_s, clock_s, grain_s, &placed);
    double cycles;
    if (result != POSEPACK_OK) return result;
    cycles = posepack_floor(placed.cycles * kHalvesACycle + 0.5);
    if (placed.clip.wrap == POSEPACK_WRAP_LOOP && cycles >= kHalvesACycle) cycles = 0.0;
    out[0] = (float)track->clip;
    out[1] = (float)(placed.cycle_hz * clock_s);
    out[2] = half_of(cycles);
    out[3] = (float)posepack_floor(placed.clock_start_s / grain_s + 0.5);
    return survives(out[0]) && survives(out[1]) ? POSEPACK_OK : POSEPACK_ERROR_UNSUPPORTED;
}

posepack_result posepack_pack_halves(const posepack_view* view, const posepack_play* play, double time_s,
                                     double clock_s, float packet[8]) {
    posepack_result result;
    if (play == NULL || packet == NULL || !is_clock(clock_s)) return POSEPACK_ERROR_ARG;
    result = pack_half_track(view, &play->now, play->now.start_s, clock_s, packet);
    packet[4] = -1.0f;
    packet[5] = packet[6] = 0.0f;
    packet[7] = 1.0f;
    if (result != POSEPACK_OK || play->before.clip == POSEPACK_NONE) return result;
    result = pack_half_track(view, &play->before, play->now.start_s, clock_s, packet + 4);
    packet[7] = half_of(posepack_fade_factor(play, time_s));
    return result;
}

/* What the row layouts are made of: uniform rows, and the track at clock 0. */
static posepack_result find_rows(const posepack_view* view, const posepack_track* track, double clock_s,
                                 const float* packet, on_clock* out) {
    posepack_result result;
    if (track == NULL || packet == NULL || !is_clock(clock_s)) return POSEPACK_ERROR_ARG;
    result = put_on_clock(view, track, track->start_s, clock_s, 0.0, out);
    if (result != POSEPACK_OK) return result;
    if (view->header.row_scheme != POSEPACK_ROWS_UNIFORM) return POSEPACK_ERROR_UNSUPPORTED;
    out->cycles = posepack_modulo(out->cycles - out->cycle_hz * out->clock_start_s, 1.0);
    return POSEPACK_OK;
}

static double interval_count(const posepack_clip* clip) {
    if (clip->row_count == 1) return 0.0;
    return clip->wrap == POSEPACK_WRAP_LOOP ? (double)clip->row_count : (double)clip->row_count - 1.0;
}

posepack_result posepack_pack_rows(const posepack_view* view, const posepack_track* track, double clock_s,
                                   float packet[4]) {
    on_clock placed;
    const posepack_result result = find_rows(view, track, clock_s, packet, &placed);
    double intervals;
    if (result != POSEPACK_OK) return result;
    intervals = interval_count(&placed.clip);
    packet[0] = (float)placed.clip.first_row;
    packet[1] = (float)placed.clip.row_count;
    packet[2] = (float)(intervals * placed.cycle_hz);
    packet[3] =
        posepack_wrap_phase(POSEPACK_WRAP_LOOP, placed.cycles * intervals / (double)placed.clip.row_count);
    return POSEPACK_OK;
}

posepack_result posepack_pack_babylon(const posepack_view* view, const posepack_track* track, double clock_s,
                                      float packet[4]) {
    on_clock placed;
    const posepack_result result = find_rows(view, track, clock_s, packet, &placed);
    double rows;
    if (result != POSEPACK_OK) return result;
    /* From the second pass on that shader counts one row less, from row 1. The offset is right there. */
    rows = (double)(placed.clip.row_count + placed.clip.closing_row);
    packet[0] = (float)placed.clip.first_row;
    packet[1] = (float)(placed.clip.first_row + placed.clip.row_count + placed.clip.closing_row - 1u);
    packet[2] = (float)(placed.cycles * (rows - 1.0));
    packet[3] = (float)(rows * placed.cycle_hz);
    return POSEPACK_OK;
}

posepack_result posepack_pack_godot(const posepack_view* view, const posepack_track* track, double clock_s,
                                    float packet[4], float* fps) {
    on_clock placed;
    const posepack_result result =
        fps == NULL ? POSEPACK_ERROR_ARG : find_rows(view, track, clock_s, packet, &placed);
    uint32_t rows;
    if (result != POSEPACK_OK) return result;
    /* That shader goes from the first row to the one before the end row, and starts again. */
    rows = placed.clip.row_count + placed.clip.closing_row;
    packet[0] = posepack_wrap_phase(POSEPACK_WRAP_LOOP, placed.cycles);
    packet[1] = (float)placed.clip.first_row;
    packet[2] = (float)(placed.clip.first_row + rows);
    packet[3] = 1.0f;
    *fps = (float)((double)(rows - 1u) * placed.cycle_hz);
    return POSEPACK_OK;
}

/* Rows, rates and ways to end that the layouts of others do not know. */
static uint32_t check_rows(const posepack_view* view, const posepack_clip* clip, uint32_t layout) {
    const posepack_header* h = &view->header;
    const int moves = clip->row_count > 1;
    const int holds = clip->interpolation == POSEPACK_INTERPOLATION_STEP || clip->cut_count > 0;
    uint32_t breaks = 0;
    if (h->row_scheme != POSEPACK_ROWS_UNIFORM) breaks |= POSEPACK_BREAK_ROWS;
    if (clip->encoding != POSEPACK_ENCODING_MAT4 || h->texel_order != POSEPACK_ORDER_BONE_MAJOR ||
        h->rows_per_line != 1) {
        breaks |= POSEPACK_BREAK_FORM;
    }
    if (moves && clip->wrap != POSEPACK_WRAP_LOOP) breaks |= POSEPACK_BREAK_WRAP;
    if (layout == POSEPACK_LAYOUT_ROWS) {
        if (clip->closing_row) breaks |= POSEPACK_BREAK_SEAM; /* it blends into row 0 in its place */
    } else if (moves && clip->wrap == POSEPACK_WRAP_LOOP && !clip->closing_row) {
        breaks |= POSEPACK_BREAK_SEAM;
    }
    if (moves && holds && layout != POSEPACK_LAYOUT_BABYLON) breaks |= POSEPACK_BREAK_HOLD;
    if (moves && clip->interpolation == POSEPACK_INTERPOLATION_LINEAR && layout == POSEPACK_LAYOUT_BABYLON) {
        breaks |= POSEPACK_BREAK_BLEND;
    }
    return breaks;
}

static double magnitude(double x) {
    return x < 0.0 ? -x : x;
}

/* What each number of a layout is: Index, Rate, Cycles, roWs, Start. */
static const char kRoles[5][9] = {"IRCSIRC-", "IR--IR--", "IIRC----", "IIWR----", "CII-----"};

/* A packet whose numbers are rounded to 16 bits; `hz` and `rows`: cycles a second, and rows a cycle. */
static uint32_t check_halves(const float packet[8], uint32_t layout, double hz, double rows) {
    double rows_off = layout == POSEPACK_LAYOUT_HALVES ? rows / (2.0 * kHalvesACycle) : 0.0;
    uint32_t breaks = 0;
    int i;
    for (i = 0; i < 8; ++i) {
        const double error = magnitude((double)half_of((double)packet[i]) - (double)packet[i]);
        const char role = kRoles[layout][i];
        if (role == 'I' && error > 0.0) breaks |= POSEPACK_BREAK_INDEX;
        if (role == 'R' && error > 0.0) breaks |= POSEPACK_BREAK_RATE;
        if (role == 'C') rows_off += error * rows;
        if (role == 'W') rows_off += error;
        if (role == 'S') rows_off += error * hz * rows;
    }
    return rows_off > 0.0625 ? breaks | POSEPACK_BREAK_PHASE : breaks;
}

static posepack_result pack(const posepack_view* view, const posepack_play* play, uint32_t layout,
                            double clock_s, float packet[8]) {
    const double now_s = play->now.start_s;
    float fps;
    switch (layout) {
        case POSEPACK_LAYOUT_PLAY:
            return posepack_pack_play(view, play, clock_s, packet);
        case POSEPACK_LAYOUT_HALVES:
            return posepack_pack_halves(view, play, now_s, clock_s, packet);
        case POSEPACK_LAYOUT_ROWS:
            return posepack_pack_rows(view, &play->now, clock_s, packet);
        case POSEPACK_LAYOUT_BABYLON:
            return posepack_pack_babylon(view, &play->now, clock_s, packet);
        case POSEPACK_LAYOUT_GODOT:
            return posepack_pack_godot(view, &play->now, clock_s, packet, &fps);
        default:
            return POSEPACK_ERROR_ARG;
    }
}

/* Where the clock wraps, cycles must have gone through a whole number of clips. */
static int jumps_at_wrap(const posepack_clip* clip, double cycle_hz, double clock_s) {
    const double passes = cycle_hz * clock_s / (clip->wrap == POSEPACK_WRAP_PING_PONG ? 2.0 : 1.0);
    return clip->wrap != POSEPACK_WRAP_ONCE && magnitude(passes - posepack_floor(passes + 0.5)) > 1e-6;
}

posepack_result posepack_check_packet(const posepack_view* view, const posepack_play* play, uint32_t layout,
                                      const posepack_limits* limits, uint32_t* breaks) {
    posepack_clip clip;
    float packet[8] = {0, 0, 0, 0, 0, 0, 0, 0};
    posepack_result result;
    uint32_t found = 0;
    if (play == NULL || limits == NULL || breaks == NULL) return POSEPACK_ERROR_ARG;
    if (limits->float_bits != 16 && limits->float_bits != 32) return POSEPACK_ERROR_ARG;
    result = pack(view, play, layout, limits->clock_s, packet);
    if (result != POSEPACK_OK && result != POSEPACK_ERROR_UNSUPPORTED) return result;
    posepack_get_clip(view, play->now.clip, &clip);
    if (layout >= POSEPACK_LAYOUT_ROWS) {
        found |= check_rows(view, &clip, layout);
        if (play->before.clip != POSEPACK_NONE && play->fade_s > 0.0) found |= POSEPACK_BREAK_FADE;
    }
    if (jumps_at_wrap(&clip, play->now.cycle_hz, limits->clock_s)) found |= POSEPACK_BREAK_RATE;
    if (limits->float_bits == 16 || layout == POSEPACK_LAYOUT_HALVES) {
        found |= check_halves(packet, layout, magnitude(play->now.cycle_hz), (double)clip.row_count);
    }
    if (limits->max_side_texels > 0 && (view->header.texture_width_texels > limits->max_side_texels ||
                                        view->header.texture_height_texels > limits->max_side_texels)) {
        found |= POSEPACK_BREAK_TEXTURE;
    }
    *breaks = found;
    return POSEPACK_OK;
}
