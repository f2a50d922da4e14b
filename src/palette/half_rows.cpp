// SPDX-License-Identifier: MIT
#include "palette/half_rows.hpp"

#include "format/half.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define POSEPACK_HAS_F16C 1
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace posepack::palette {
namespace {

#ifdef POSEPACK_HAS_F16C

// F16C needs the upper halves of the vector registers saved by the system (AVX): Intel's manual, volume 1,
// section 14.4.1.
bool has_f16c() {
    unsigned eax = 0;
    unsigned ebx = 0;
    unsigned ecx = 0;
    unsigned edx = 0;
    if (__get_cpuid(1, &eax, &ebx, &ecx, &edx) == 0) return false;
    constexpr unsigned kF16c = 1u << 29;
    return (ecx & kF16c) != 0 && __builtin_cpu_supports("avx");
}

__attribute__((target("avx,f16c"))) std::size_t round_eights(std::span<float> values,
                                                             std::span<std::uint16_t> halves) {
    std::size_t i = 0;
    for (; i + 8 <= values.size(); i += 8) {
        const __m128i packed =
            _mm256_cvtps_ph(_mm256_loadu_ps(&values[i]), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
        _mm_storeu_si128(reinterpret_cast<__m128i*>(&halves[i]), packed);
        _mm256_storeu_ps(&values[i], _mm256_cvtph_ps(packed));
    }
    return i;
}

#endif

}  // namespace

void round_to_halves_in_software(std::span<float> values, std::span<std::uint16_t> halves) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        halves[i] = posepack_half_from_float(values[i]);
        values[i] = posepack_float_from_half(halves[i]);
    }
}

void round_to_halves(std::span<float> values, std::span<std::uint16_t> halves) {
    std::size_t done = 0;
#ifdef POSEPACK_HAS_F16C
    static const bool kHasF16c = has_f16c();
    if (kHasF16c) done = round_eights(values, halves);
#endif
    round_to_halves_in_software(values.subspan(done), halves.subspan(done));
}

}  // namespace posepack::palette
