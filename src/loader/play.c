/* SPDX-License-Identifier: MIT */
/* The time law, tracks and plays, and the marks that a track passes. */
#include "posepack/play.h"

#include "loader/timing.h"

/* Behind the end of a fade and of a clip played once, longer than a frame: its last moments may be asked for.
 */
static const double kKeptS = 1.0;
static const double kMostHz = 1e6; /* cycles a second: a packet of more would hold infinity, or nothing */

double posepack_floor(double x) {
    const double all_integers = 4503599627370496.0; /* 2^52: above it a double has no fraction */
    double whole;
    if (!(x > -all_integers && x < all_integers)) return x;
    whole = (double)(int64_t)x;
    return whole > x ? whole - 1.0 : whole;
}

int posepack_is_finite(double x) {
    return x - x == 0.0;
}

double posepack_modulo(double x, double period) {
    const double rest = x - period * posepack_floor(x / period);
    return rest > 0.0 && rest < period ? rest : 0.0;
}

double posepack_count_cycles(const posepack_track* track, double time_s) {
    return track->phase + track->cycle_hz * (time_s - track->start_s);
}

double posepack_fold_cycles(uint32_t wrap, double cycles) {
    if (wrap == POSEPACK_WRAP_ONCE) return cycles;
    return posepack_modulo(cycles, wrap == POSEPACK_WRAP_PING_PONG ? 2.0 : 1.0);
}

float posepack_wrap_phase(uint32_t wrap, double cycles) {
    const float below_one = 0.99999994f;
    float phase;
    if (wrap == POSEPACK_WRAP_ONCE) {
        if (!(cycles > 0.0)) return 0.0f;
        return cycles < 1.0 ? (float)cycles : 1.0f;
    }
    cycles = posepack_fold_cycles(wrap, cycles);
    if (wrap == POSEPACK_WRAP_PING_PONG) return (float)(cycles > 1.0 ? 2.0 - cycles : cycles);
    phase = (float)cycles;
    return phase < 1.0f ? phase : below_one;
}

float posepack_wrap_clock(double time_s, double clock_s) {
    float clock;
    if (!posepack_is_finite(time_s) || !(clock_s > 0.0)) return 0.0f;
    clock = (float)posepack_modulo(time_s, clock_s);
    return (double)clock < clock_s ? clock : 0.0f;
}

/* Of at most 11 bits, so that a 16-bit float holds it; not 0. */
static double rounded_steps(double steps) {
    double grain = 1.0, magnitude = steps < 0.0 ? -steps : steps;
    while (magnitude >= 2048.0 * grain) grain *= 2.0;
    magnitude = grain * posepack_floor(magnitude / grain + 0.5);
    if (magnitude < 1.0) magnitude = 1.0;
    return steps < 0.0 ? -magnitude : magnitude;
}

int posepack_has_ended(uint32_t wrap, const posepack_track* track, double time_s) {
    const double cycles = posepack_count_cycles(track, time_s);
    if (wrap != POSEPACK_WRAP_ONCE || !(time_s >= track->start_s)) return 0;
    return track->cycle_hz > 0.0 ? cycles >= 1.0 : track->cycle_hz < 0.0 && cycles <= 0.0;
}

/* Cycles a second of a clip played at a speed; 0 where an argument is no number or gives too many. */
static int find_cycle_hz(const posepack_clip* clip, double speed, double clock_s, double* cycle_hz) {
    const double whole_cycles = clip->wrap == POSEPACK_WRAP_PING_PONG ? 2.0 : 1.0;
    const double exact_hz = clip->period_s > 0.0f ? speed / (double)clip->period_s : 0.0;
    const double steps = exact_hz * clock_s / whole_cycles;
    if (!(exact_hz >= -kMostHz && exact_hz <= kMostHz)) return 0;
    if (!posepack_is_finite(speed) || !posepack_is_finite(steps) || !(clock_s >= 0.0)) return 0;
    *cycle_hz = exact_hz == 0.0 || clock_s == 0.0 ? exact_hz : rounded_steps(steps) * whole_cycles / clock_s;
    return 1;
}

posepack_result posepack_start_track(const posepack_view* view, uint32_t clip_index, double speed,
                                     double phase, double now_s, double clock_s, posepack_track* track) {
    posepack_clip clip;
    const posepack_result result = posepack_get_clip(view, clip_index, &clip);
    double cycle_hz = 0.0;
    if (result != POSEPACK_OK) return result;
    if (track == NULL || !posepack_is_finite(phase) || !posepack_is_finite(now_s) ||
        !find_cycle_hz(&clip, speed, clock_s, &cycle_hz)) {
        return POSEPACK_ERROR_ARG;
    }
    track->clip = clip_index;
    track->phase = posepack_fold_cycles(clip.wrap, phase);
    track->cycle_hz = cycle_hz;
    track->start_s = now_s;
    return POSEPACK_OK;
}

posepack_result posepack_change_speed(const posepack_view* view, double speed, double now_s, double clock_s,
                                      posepack_track* track) {
    posepack_clip clip;
    const posepack_result result =
        track == NULL ? POSEPACK_ERROR_ARG : posepack_get_clip(view, track->clip, &clip);
    double cycles, cycle_hz = 0.0;
    if (result != POSEPACK_OK) return result;
    if (!posepack_is_finite(now_s) || !find_cycle_hz(&clip, speed, clock_s, &cycle_hz)) {
        return POSEPACK_ERROR_ARG;
    }
    /* The start stays, so that what was shown a frame ago can still be asked for. */
    if (now_s < track->start_s) now_s = track->start_s;
    cycles = posepack_count_cycles(track, now_s);
    if (posepack_has_ended(clip.wrap, track, now_s)) cycles = track->cycle_hz > 0.0 ? 1.0 : 0.0;
    track->cycle_hz = cycle_hz;
    track->phase = posepack_fold_cycles(clip.wrap, cycles - track->cycle_hz * (now_s - track->start_s));
    return POSEPACK_OK;
}

posepack_result posepack_match_speed(const posepack_view* view, uint32_t clip_index, double ground_mps,
                                     double* speed) {
    posepack_clip clip;
    const posepack_result result = posepack_get_clip(view, clip_index, &clip);
    if (result != POSEPACK_OK) return result;
    if (speed == NULL || !posepack_is_finite(ground_mps)) return POSEPACK_ERROR_ARG;
    *speed = 1.0;
    if (!(clip.speed_mps > 0.0f)) return POSEPACK_ERROR_NOT_FOUND;
    *speed = ground_mps / (double)clip.speed_mps;
    return POSEPACK_OK;
}

float posepack_spread_phase(uint32_t index) {
    /* 2^32 / golden ratio, odd: the product modulo 2^32 is the fraction, exactly, and takes every value. */
    return (float)(index * 2654435769u >> 8) / 16777216.0f;
}

posepack_result posepack_start_play(posepack_play* play, const posepack_track* track) {
    if (play == NULL || track == NULL) return POSEPACK_ERROR_ARG;
    play->now = *track;
    play->before = *track;
    play->before.clip = POSEPACK_NONE;
    play->fade_s = 0.0;
    return POSEPACK_OK;
}

double posepack_fade_factor(const posepack_play* play, double time_s) {
    const double elapsed_s = time_s - play->now.start_s;
    if (!(elapsed_s >= 0.0)) return 0.0;
    return elapsed_s < play->fade_s ? elapsed_s / play->fade_s : 1.0;
}

posepack_result posepack_fade_play(posepack_play* play, const posepack_track* track, double fade_s) {
    if (play == NULL || track == NULL || !posepack_is_finite(fade_s) || fade_s < 0.0) {
        return POSEPACK_ERROR_ARG;
    }
    if (play->before.clip == POSEPACK_NONE || posepack_fade_factor(play, track->start_s) >= 0.5) {
        play->before = play->now;
    }
    play->now = *track;
    play->fade_s = fade_s;
    return POSEPACK_OK;
}

posepack_result posepack_settle_play(const posepack_view* view, double now_s, posepack_play* play,
                                     uint32_t* changed) {
    posepack_clip clip;
    const posepack_result result =
        play == NULL || changed == NULL ? POSEPACK_ERROR_ARG : posepack_get_clip(view, play->now.clip, &clip);
    if (result != POSEPACK_OK) return result;
    *changed = 0;
    if (play->before.clip != POSEPACK_NONE && now_s - kKeptS - play->now.start_s >= play->fade_s) {
        play->before.clip = POSEPACK_NONE;
        play->fade_s = 0.0;
        *changed = 1;
    }
    if (posepack_has_ended(clip.wrap, &play->now, now_s - kKeptS)) {
        play->now.phase = play->now.cycle_hz > 0.0 ? 1.0 : 0.0;
        play->now.cycle_hz = 0.0;
        *changed = 1;
    }
    return POSEPACK_OK;
}

static posepack_result find_phase(const posepack_view* view, const posepack_track* track, double time_s,
                                  uint32_t* clip_index, float* phase) {
    posepack_clip clip;
    const posepack_result result = posepack_get_clip(view, track->clip, &clip);
    if (result != POSEPACK_OK) return result;
    *clip_index = track->clip;
    *phase = posepack_wrap_phase(clip.wrap, posepack_count_cycles(track, time_s));
    return POSEPACK_OK;
}

posepack_result posepack_find_moment(const posepack_view* view, const posepack_play* play, double time_s,
                                     posepack_moment* moment) {
    posepack_result result;
    double factor;
    if (play == NULL || moment == NULL) return POSEPACK_ERROR_ARG;
    moment->before = POSEPACK_NONE;
    moment->before_phase = 0.0f;
    moment->factor = 1.0f;
    if (play->before.clip == POSEPACK_NONE) {
        if (!(time_s >= play->now.start_s)) time_s = play->now.start_s;
        return find_phase(view, &play->now, time_s, &moment->clip, &moment->phase);
    }
    factor = posepack_fade_factor(play, time_s);
    if (!(factor > 0.0)) return find_phase(view, &play->before, time_s, &moment->clip, &moment->phase);
    result = find_phase(view, &play->now, time_s, &moment->clip, &moment->phase);
    if (result != POSEPACK_OK || !((float)factor < 1.0f)) return result;
    moment->factor = (float)factor;
    return find_phase(view, &play->before, time_s, &moment->before, &moment->before_phase);
}

/* Marks k x period + mark, for all whole k (period 0: mark alone), at or below `cycles`, and below them. */
static double marks_up_to(double cycles, double mark, double period) {
    if (period == 0.0) return cycles >= mark ? 1.0 : 0.0;
    return posepack_floor((cycles - mark) / period) + 1.0;
}
static double marks_below(double cycles, double mark, double period) {
    if (period == 0.0) return cycles > mark ? 1.0 : 0.0;
    return -posepack_floor((mark - cycles) / period);
}

posepack_result posepack_count_passes(const posepack_view* view, const posepack_track* track, double mark,
                                      double from_s, double to_s, uint64_t* count) {
    posepack_clip clip;
    const posepack_result result =
        track == NULL || count == NULL ? POSEPACK_ERROR_ARG : posepack_get_clip(view, track->clip, &clip);
    const double most = 9007199254740992.0; /* 2^53: above it doubles do not count one by one */
    double sign, period, from, to, passes = 0.0;
    int ways, way, starts;
    if (result != POSEPACK_OK) return result;
    if (!(mark >= 0.0 && mark <= 1.0)) return POSEPACK_ERROR_ARG;
    *count = 0;
    starts = from_s < track->start_s;
    if (!(to_s > from_s) || !(to_s >= track->start_s) || track->cycle_hz == 0.0) return POSEPACK_OK;
    sign = track->cycle_hz < 0.0 ? -1.0 : 1.0; /* backwards is forwards through the negative cycles */
    from = sign * posepack_count_cycles(track, starts ? track->start_s : from_s);
    to = sign * posepack_count_cycles(track, to_s);
    if (!posepack_is_finite(from) || !posepack_is_finite(to)) return POSEPACK_OK;
    period = clip.wrap == POSEPACK_WRAP_ONCE ? 0.0 : clip.wrap == POSEPACK_WRAP_PING_PONG ? 2.0 : 1.0;
    ways = clip.wrap == POSEPACK_WRAP_PING_PONG && mark > 0.0 && mark < 1.0 ? 2 : 1;
    for (way = 0; way < ways; ++way) {
        const double at = way == 0 ? sign * mark : -sign * mark;
        passes += marks_up_to(to, at, period) -
                  (starts ? marks_below(from, at, period) : marks_up_to(from, at, period));
    }
    *count = passes < most ? (uint64_t)passes : (uint64_t)most;
    return POSEPACK_OK;
}
