/* SPDX-License-Identifier: MIT */
/* What the GPU shows of a moment, on the CPU: one clip, or the fade of two. */
#include "loader/internal.h"
#include "posepack/play.h"

static void fade(const posepack_bone_source* before, const posepack_bone_source* now, float factor,
                 float* matrix) {
    if (before->form.encoding == POSEPACK_ENCODING_DUALQUAT && now->form.encoding == before->form.encoding &&
        before->texel0 != NULL && now->texel0 != NULL) {
        const posepack_scaled_dualquat a = posepack_read_source(before);
        const posepack_scaled_dualquat b = posepack_read_source(now);
        const posepack_scaled_dualquat mixed = posepack_dualquat_fade(&a, &b, factor);
        posepack_dualquat_write(&mixed, matrix);
    } else {
        float other[12];
        uint32_t i;
        posepack_decode_source(before, other);
        posepack_decode_source(now, matrix);
        for (i = 0; i < 12; ++i) matrix[i] = other[i] * (1.0f - factor) + matrix[i] * factor;
    }
}

static void show(const posepack_view* view, const posepack_moment* moment, uint32_t bone, float* matrix) {
    const posepack_bone_source now = posepack_find_source(view, moment->clip, bone, moment->phase);
    if (moment->before == POSEPACK_NONE) {
        posepack_decode_source(&now, matrix);
    } else {
        const posepack_bone_source before =
            posepack_find_source(view, moment->before, bone, moment->before_phase);
        fade(&before, &now, moment->factor, matrix);
    }
}

static posepack_result check(const posepack_view* view, const posepack_moment* moment, const float* matrix) {
    if (view == NULL || view->bytes == NULL || moment == NULL || matrix == NULL) return POSEPACK_ERROR_ARG;
    if (moment->clip >= view->header.clip_count) return POSEPACK_ERROR_INDEX;
    return moment->before == POSEPACK_NONE || moment->before < view->header.clip_count ? POSEPACK_OK
                                                                                       : POSEPACK_ERROR_INDEX;
}

posepack_result posepack_show_bone(const posepack_view* view, const posepack_moment* moment, uint32_t bone,
                                   float matrix[12]) {
    const posepack_result result = check(view, moment, matrix);
    if (result != POSEPACK_OK) return result;
    if (bone >= view->header.bone_count) return POSEPACK_ERROR_INDEX;
    show(view, moment, bone, matrix);
    return POSEPACK_OK;
}

posepack_result posepack_show_pose(const posepack_view* view, const posepack_moment* moment,
                                   float* matrices) {
    const posepack_result result = check(view, moment, matrices);
    uint32_t bone;
    if (result != POSEPACK_OK) return result;
    for (bone = 0; bone < view->header.bone_count; ++bone) {
        show(view, moment, bone, matrices + 12 * (size_t)bone);
    }
    return POSEPACK_OK;
}
