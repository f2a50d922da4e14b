/* SPDX-License-Identifier: MIT */
/*
 * Playing clips: from time to phase, packets for the GPU, and what they show, on the CPU.
 *
 * The law, which docs/time.md gives with its reasons:
 *
 *     cycles = phase + cycle_hz x (time - start)     cycle_hz = speed / period_s, or 0 where the period is 0
 *     loop       fract(cycles)
 *     once       clamp(cycles, 0, 1)
 *     ping-pong  1 - abs(1 - 2 fract(cycles / 2))
 *
 * in double, so that it is as exact after weeks as at the start. What it gives, a phase of 0 to 1, is float:
 * posepack_sample_bone and posepack_find_place make rows of it. A shader follows the same law in float on a
 * clock that wraps (posepack_wrap_clock); rates are multiples of 1 / clock, so that the wrap is not seen.
 *
 * A *track* is one clip in time; a *play* is what an instance shows: a track, and while it fades in also the
 * one before it. Use:
 *
 *     posepack_track walk;
 *     posepack_play play;
 *     posepack_moment moment;
 *     posepack_start_track(&view, clip, 1.0, posepack_spread_phase(animal), now_s, POSEPACK_CLOCK_S, &walk);
 *     posepack_start_play(&play, &walk);
 *     posepack_pack_play(&view, &play, POSEPACK_CLOCK_S, packet);       (8 floats, to the GPU, once)
 *     posepack_find_moment(&view, &play, time_s, &moment);              (any time: what the GPU shows)
 *     posepack_show_bone(&view, &moment, bone, matrix);
 *
 * Times are seconds of one clock of the game, as double. Speeds: 1 as stored, negative backwards, 0 stands
 * still. Memory and threads: as in posepack/loader.h; nothing here allocates, and tracks and plays are plain
 * values. Every function is O(1) where it does not say otherwise. Stability: draft.
 */
#ifndef POSEPACK_PLAY_H
#define POSEPACK_PLAY_H

#include "posepack/loader.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The clock of shaders unless an engine has its own (Godot's TIME: 3600): seconds until it wraps. */
#define POSEPACK_CLOCK_S 1024.0

/* One clip in time. Fields are free to read; functions below keep them in range. */
typedef struct posepack_track {
    uint32_t clip;
    double phase;    /* cycles at start_s */
    double cycle_hz; /* cycles a second; a cycle takes period_s at speed 1 */
    double start_s;
} posepack_track;

/* What an instance shows. From now.start_s on `now` fades in, through fade_s seconds, over `before`. */
typedef struct posepack_play {
    posepack_track now;
    posepack_track before; /* clip is POSEPACK_NONE where nothing was shown before */
    double fade_s;         /* 0: `now` is shown at once */
} posepack_play;

/* What is shown at a time: one clip, or a fade. */
typedef struct posepack_moment {
    uint32_t clip;
    uint32_t before; /* the clip it fades from; POSEPACK_NONE: `clip` alone */
    float phase, before_phase;
    float factor; /* share of `clip`: above 0 and below 1 in a fade, else 1 */
} posepack_moment;

/* ---- The time law ---- */

/* Cycles of a track at a time, before its start as well; NaN where a number of them is. */
double posepack_count_cycles(const posepack_track* track, double time_s);

/*
 * The phase that cycles have under a wrap (POSEPACK_WRAP_*; unknown ones loop): 0 to 1, below 1 under loop.
 * Negative cycles: a loop goes on backwards, once stays at 0, ping-pong is mirrored. NaN gives 0, and so does
 * infinity but for plus infinity under once, which gives 1.
 */
float posepack_wrap_phase(uint32_t wrap, double cycles);

/* The clock of shaders at a time: time_s modulo clock_s, 0 <= clock < clock_s; 0 where an argument is no
 * time or clock_s is not above 0. Equal times give equal bits. */
float posepack_wrap_clock(double time_s, double clock_s);

/*
 * A clip that is at `phase` now: "start now", and the start of everything else.
 *   clip_index  < header.clip_count
 *   speed       1 as stored. The rate becomes a multiple of 1 / clock_s (2 / clock_s for ping-pong) of at
 *               most 11 bits: off by up to half of that multiple or, if more, 2^-11 of itself; never 0 unless
 *               speed is
 *   phase       cycles; any number, stored within one cycle of a loop, two of ping-pong
 *   clock_s     of the shader; 0: rates are exact, for the CPU alone
 * OK, ARG (null, a number that is not finite, a negative clock, more than 10^6 cycles a second) or INDEX.
 */
posepack_result posepack_start_track(const posepack_view* view, uint32_t clip_index, double speed,
                                     double phase, double now_s, double clock_s, posepack_track* track);

/* Another speed from now on, without a jump of the phase; may be called every frame. Results as above. */
posepack_result posepack_change_speed(const posepack_view* view, double speed, double now_s, double clock_s,
                                      posepack_track* track);

/*
 * The speed at which feet do not slide: ground_mps / clip.speed_mps; divide ground_mps by the scale of the
 * instance first. Negative walks backwards. OK, ARG (null, or not finite), INDEX, or NOT_FOUND where the
 * clip states no ground speed (*speed is 1 then).
 */
posepack_result posepack_match_speed(const posepack_view* view, uint32_t clip_index, double ground_mps,
                                     double* speed);

/*
 * Phases of a herd, 0 <= phase < 1: fract(index / golden ratio). The phases of any number of neighbours lie
 * nearly evenly, their largest gap at most 2.7 times their smallest, and no two of the first half million are
 * the same. A flock that moves as one has one phase on purpose: give its members one index, or copy its
 * track.
 */
float posepack_spread_phase(uint32_t index);

/* ---- Plays ---- */

/* A track that nothing comes before. OK or ARG. */
posepack_result posepack_start_play(posepack_play* play, const posepack_track* track);

/*
 * Goes over to a track at its start_s, through fade_s seconds (0: at once). What is shown then comes before
 * it: where a fade has not ended, the clip that has the larger share, alone. OK, or ARG (null, fade_s
 * negative or not finite).
 */
posepack_result posepack_fade_play(posepack_play* play, const posepack_track* track, double fade_s);

/*
 * Drops what needs no clock any more, a second after its end: a fade that is over; a clip played once that is
 * held from then on. A packet with either must be written again within one clock, a loop alone never.
 *   changed  1 where the play changed and its packet should be written again
 * OK, ARG or INDEX.
 */
posepack_result posepack_settle_play(const posepack_view* view, double now_s, posepack_play* play,
                                     uint32_t* changed);

/*
 * What is shown at a time; before now.start_s it is the clip before, or the first pose where there is none.
 * So the moment one frame before this one is, always, that of time_s - frame_s: the pose for motion vectors.
 * A time of NaN lies before every start. OK, ARG or INDEX (a clip of the play).
 */
posepack_result posepack_find_moment(const posepack_view* view, const posepack_play* play, double time_s,
                                     posepack_moment* moment);

/*
 * The matrix of one bone at a moment, 3x4 row-major as posepack_sample_bone gives it. In a fade, matrices are
 * mixed entry by entry, before x (1 - factor) + clip x factor; where both clips are dual quaternions their
 * numbers are, those of `clip` with all signs turned where the real parts are in opposite hemispheres.
 * OK, ARG or INDEX.
 */
posepack_result posepack_show_bone(const posepack_view* view, const posepack_moment* moment, uint32_t bone,
                                   float matrix[12]);

/* The same for all bones: header.bone_count matrices of 12 floats, bone by bone. O(bones). */
posepack_result posepack_show_pose(const posepack_view* view, const posepack_moment* moment, float* matrices);

/*
 * How often a track passes a mark in from_s < time <= to_s, however many cycles that is. Neighbouring spans
 * add up exactly, so that no event is lost or doubled. A mark at which the track starts is passed at its
 * start; nothing is passed before. Ping-pong passes a mark on both ways, its ends once.
 *   mark   0 to 1, a phase; 0 and 1 of a loop are the same
 *   count  0 where to_s is not behind from_s, the track stands, or a time is not finite; at most 2^53
 * OK, ARG (null, or a mark out of range) or INDEX.
 */
posepack_result posepack_count_passes(const posepack_view* view, const posepack_track* track, double mark,
                                      double from_s, double to_s, uint64_t* count);

/* ---- Packets: what a vertex shader gets of an instance; docs/time.md has the law of each ---- */

/*
 * posepack's own packet, for every row scheme and wrap: clip, cycles a second, phase at start, start on the
 * clock; then the clip before (-1: none), its cycles a second, its phase at the same start, and fade_s.
 * OK, ARG (null, or clock_s not above 0) or INDEX.
 */
posepack_result posepack_pack_play(const posepack_view* view, const posepack_play* play, double clock_s,
                                   float packet[8]);

/*
 * The same for instance data of 16-bit floats, where each number survives: clip, cycles a clock, 2048 x
 * phase at start, start in clock / 2048; then the clip before (-1), its cycles a clock, 2048 x its phase, and
 * the factor at time_s: written again every frame of a fade. The phase is off by 2^-12 of a cycle at most
 * (loop). Results as above, and UNSUPPORTED where a clip's index or its rate does not survive.
 */
posepack_result posepack_pack_halves(const posepack_view* view, const posepack_play* play, double time_s,
                                     double clock_s, float packet[8]);

/*
 * The published packet: first row, row count, rows a second, phase at clock 0. Row = first + (clock x z +
 * w x y) mod y, blended with the next, which wraps. OK, ARG, INDEX, or UNSUPPORTED under runs.
 */
posepack_result posepack_pack_rows(const posepack_view* view, const posepack_track* track, double clock_s,
                                   float packet[4]);

/* Babylon.js: first row, last row, offset in frames, frames a second (format as
 * bakedVertexAnimationSettings). Results as of posepack_pack_rows. */
posepack_result posepack_pack_babylon(const posepack_view* view, const posepack_track* track, double clock_s,
                                      float packet[4]);

/* Godot's vertex animation plugin: phase, first row, end row, alpha 1; `fps` goes to the material, so that
 * one material has one speed. Results as of posepack_pack_rows. */
posepack_result posepack_pack_godot(const posepack_view* view, const posepack_track* track, double clock_s,
                                    float packet[4], float* fps);

/* Layouts of packets. */
#define POSEPACK_LAYOUT_PLAY 0u
#define POSEPACK_LAYOUT_HALVES 1u
#define POSEPACK_LAYOUT_ROWS 2u
#define POSEPACK_LAYOUT_BABYLON 3u
#define POSEPACK_LAYOUT_GODOT 4u

/* What an engine gives. */
typedef struct posepack_limits {
    uint32_t float_bits;      /* of instance data: 32, or 16 (Godot's Compatibility renderer) */
    uint32_t max_side_texels; /* of a texture; 0 any */
    double clock_s;           /* of the shader */
} posepack_limits;

/* What breaks. */
#define POSEPACK_BREAK_ROWS 1u       /* the layout addresses uniform rows, the palette has runs */
#define POSEPACK_BREAK_FORM 2u       /* it reads mat4, bone-major, a row a line */
#define POSEPACK_BREAK_WRAP 4u       /* it loops; the clip is played once or to and fro */
#define POSEPACK_BREAK_SEAM 8u       /* its loop leaves out the step from the last row to row 0, or row 0 */
#define POSEPACK_BREAK_HOLD 16u      /* it blends rows that are steps or cuts */
#define POSEPACK_BREAK_BLEND 32u     /* it does not blend rows: motion goes in steps */
#define POSEPACK_BREAK_FADE 64u      /* it shows one clip; the play is fading */
#define POSEPACK_BREAK_INDEX 128u    /* a row or clip number does not survive 16 bits: another row is shown */
#define POSEPACK_BREAK_RATE 256u     /* a rate does not, or is no multiple of 1 / clock: its wrap is seen */
#define POSEPACK_BREAK_PHASE 512u    /* phase and start do not: off by more than 1/16 of a row */
#define POSEPACK_BREAK_TEXTURE 1024u /* the texture is wider or higher than the engine allows */

/*
 * Says what of a play breaks in a layout under the limits of an engine: POSEPACK_BREAK_* in *breaks, 0 for
 * nothing. OK, ARG (null, clock_s not above 0, another layout, float_bits not 16 or 32) or INDEX.
 */
posepack_result posepack_check_packet(const posepack_view* view, const posepack_play* play, uint32_t layout,
                                      const posepack_limits* limits, uint32_t* breaks);

#ifdef __cplusplus
}
#endif

#endif
