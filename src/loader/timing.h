/* SPDX-License-Identifier: MIT */
/* Numbers of the time law that play and packets share. No libm: doubles go through integers. */
#ifndef POSEPACK_LOADER_TIMING_H
#define POSEPACK_LOADER_TIMING_H

#include "posepack/play.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The largest whole number that is not above x; x itself where it is not finite. */
double posepack_floor(double x);

int posepack_is_finite(double x);

/* x modulo a period above 0: 0 <= result < period; 0 where x is not finite. */
double posepack_modulo(double x, double period);

/* The same place of a clip with the fewest cycles: below 1 of a loop, below 2 of ping-pong; once unchanged.
 */
double posepack_fold_cycles(uint32_t wrap, double cycles);

/* 1 where a clip played once stands at its end, forwards or backwards. */
int posepack_has_ended(uint32_t wrap, const posepack_track* track, double time_s);

/* Share of play.now at a time: 0 before its start and for NaN, 1 behind the fade. */
double posepack_fade_factor(const posepack_play* play, double time_s);

#ifdef __cplusplus
}
#endif

#endif
