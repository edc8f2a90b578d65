// SPDX-License-Identifier: MIT
#include "clipping/batch/vector_kernel.h"
#include "clipping/ieee_numbers.h"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)

#include <immintrin.h>

namespace clipping {
namespace {

/// A bit for each of eight lanes; by intrinsics, so that it stays in a mask register.
struct Mask8 {
    __mmask8 lanes;
    LANE Mask8 operator&(Mask8 a, Mask8 b) { return {_kand_mask8(a.lanes, b.lanes)}; }
    LANE Mask8 operator|(Mask8 a, Mask8 b) { return {_kor_mask8(a.lanes, b.lanes)}; }
    LANE Mask8 operator~(Mask8 a) { return {_knot_mask8(a.lanes)}; }
    LANE bool any(Mask8 a) { return !_kortestz_mask8_u8(a.lanes, a.lanes); }
    LANE unsigned bits(Mask8 a) { return _cvtmask8_u32(a.lanes); }
};

/// A bit for each of sixteen lanes.
struct Mask16 {
    __mmask16 lanes;
    LANE Mask16 operator&(Mask16 a, Mask16 b) { return {_kand_mask16(a.lanes, b.lanes)}; }
    LANE Mask16 operator|(Mask16 a, Mask16 b) { return {_kor_mask16(a.lanes, b.lanes)}; }
    LANE Mask16 operator~(Mask16 a) { return {_knot_mask16(a.lanes)}; }
    LANE bool any(Mask16 a) { return !_kortestz_mask16_u8(a.lanes, a.lanes); }
};

/// Eight doubles.
struct Doubles {
    static constexpr std::size_t width = 8;
    using Mask = Mask8;
    __m512d v;

    CLIPPING_INLINE static Doubles of(double x) { return {_mm512_set1_pd(x)}; }
    CLIPPING_INLINE static Doubles ofBits(std::uint64_t x)
    {
        return {_mm512_castsi512_pd(_mm512_set1_epi64(static_cast<long long>(x)))};
    }
    LANE Doubles operator+(Doubles a, Doubles b) { return {_mm512_add_pd(a.v, b.v)}; }
    LANE Doubles operator-(Doubles a, Doubles b) { return {_mm512_sub_pd(a.v, b.v)}; }
    LANE Doubles operator*(Doubles a, Doubles b) { return {_mm512_mul_pd(a.v, b.v)}; }
    LANE Doubles operator/(Doubles a, Doubles b) { return {_mm512_div_pd(a.v, b.v)}; }
    LANE Doubles operator^(Doubles a, Doubles b) { return {_mm512_xor_pd(a.v, b.v)}; }
    LANE Doubles operator|(Doubles a, Doubles b) { return {_mm512_or_pd(a.v, b.v)}; }
    LANE Doubles fma(Doubles a, Doubles b, Doubles c) { return {_mm512_fmadd_pd(a.v, b.v, c.v)}; }
    /// a * b - c, where c is nearly a * b.
    LANE Doubles restOfProduct(Doubles a, Doubles b, Doubles c)
    {
        return {_mm512_fmsub_pd(a.v, b.v, c.v)};
    }
    LANE Doubles fnma(Doubles a, Doubles b, Doubles c) { return {_mm512_fnmadd_pd(a.v, b.v, c.v)}; }
    LANE Doubles abs(Doubles a) { return {_mm512_abs_pd(a.v)}; }
    LANE Doubles min(Doubles a, Doubles b) { return {_mm512_maskz_min_pd(0xff, a.v, b.v)}; }
    LANE Doubles max(Doubles a, Doubles b) { return {_mm512_maskz_max_pd(0xff, a.v, b.v)}; }
    LANE Doubles signOf(Doubles a) { return {_mm512_and_pd(a.v, _mm512_set1_pd(-0.0))}; }
    /// NaN, infinite, or too small for a full reciprocal; but not 0.
    LANE Mask irregular(Doubles a) { return {_mm512_fpclass_pd_mask(a.v, 0xb9)}; }
    LANE Mask operator<(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)}; }
    LANE Mask operator>(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)}; }
    LANE Mask notAbove(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_NGT_UQ)}; }
    LANE Mask operator<=(Doubles a, Doubles b)
    {
        return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)};
    }
    LANE Mask operator>=(Doubles a, Doubles b)
    {
        return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GE_OQ)};
    }
    LANE Mask operator==(Doubles a, Doubles b)
    {
        return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)};
    }
    LANE Doubles select(Mask m, Doubles a, Doubles b)
    {
        return {_mm512_mask_blend_pd(m.lanes, b.v, a.v)};
    }
    LANE Doubles select(Doubles sign, Doubles a, Doubles b)
    {
        return {_mm512_mask_blend_pd(_mm512_movepi64_mask(_mm512_castpd_si512(sign.v)), b.v, a.v)};
    }
    template <class T>
    CLIPPING_INLINE Doubles rounded() const
    {
        if constexpr (sizeof(T) == sizeof(double))
            return *this;
        else
            return {_mm512_maskz_cvtps_pd(0xff, _mm512_maskz_cvtpd_ps(0xff, v))};
    }

    CLIPPING_INLINE static Ends<Doubles> load(const Segment* s)
    {
        const __m512d s01 = _mm512_loadu_pd(s), s23 = _mm512_loadu_pd(s + 2);
        const __m512d s45 = _mm512_loadu_pd(s + 4), s67 = _mm512_loadu_pd(s + 6);
        const __m512i xs = _mm512_setr_epi64(0, 4, 8, 12, 2, 6, 10, 14);
        const __m512i ys = _mm512_setr_epi64(1, 5, 9, 13, 3, 7, 11, 15);
        return joined(_mm512_permutex2var_pd(s01, xs, s23), _mm512_permutex2var_pd(s01, ys, s23),
                      _mm512_permutex2var_pd(s45, xs, s67), _mm512_permutex2var_pd(s45, ys, s67));
    }
    CLIPPING_INLINE static std::size_t storeIndices(std::uint32_t* to, std::size_t first,
                                                    Mask which)
    {
        const __m256i all = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(first)),
                                             _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                            _mm256_maskz_compress_epi32(which.lanes, all));
        return static_cast<std::size_t>(__builtin_popcount(which.lanes));
    }
    /// The numbers of a table at the indices that the lanes hold as bits.
    CLIPPING_INLINE static Doubles look(const double* table, Doubles indices)
    {
        return {_mm512_mask_i64gather_pd(_mm512_setzero_pd(), 0xff, _mm512_castpd_si512(indices.v),
                                         table, 8)};
    }
    /// The same in a table of up to eight numbers, with room for eight.
    CLIPPING_INLINE static Doubles lookInEight(const double* table, Doubles indices)
    {
        return {_mm512_maskz_permutexvar_pd(0xff, _mm512_castpd_si512(indices.v),
                                            _mm512_loadu_pd(table))};
    }
    CLIPPING_INLINE static Ends<Doubles> gather(const Segment* s, const std::uint32_t* at)
    {
        const auto two = [&](int low, int high) {
            return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(&s[at[low]].a.x)),
                                      _mm256_loadu_pd(&s[at[high]].a.x), 1);
        };
        const __m512d s02 = two(0, 2), s13 = two(1, 3), s46 = two(4, 6), s57 = two(5, 7);
        const __m512d x03 = _mm512_unpacklo_pd(s02, s13), y03 = _mm512_unpackhi_pd(s02, s13);
        const __m512d x47 = _mm512_unpacklo_pd(s46, s57), y47 = _mm512_unpackhi_pd(s46, s57);
        return {{_mm512_shuffle_f64x2(x03, x47, 0x88)},
                {_mm512_shuffle_f64x2(y03, y47, 0x88)},
                {_mm512_shuffle_f64x2(x03, x47, 0xdd)},
                {_mm512_shuffle_f64x2(y03, y47, 0xdd)}};
    }
    CLIPPING_INLINE static Ends<Doubles> gather(const BasicSegment<float>* s,
                                                const std::uint32_t* at)
    {
        const auto two = [&](int low, int high) {
            return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(&s[at[low]].a.x)),
                                        _mm_loadu_ps(&s[at[high]].a.x), 1);
        };
        const __m256 s04 = two(0, 4), s15 = two(1, 5), s26 = two(2, 6), s37 = two(3, 7);
        const __m256d a01 = _mm256_castps_pd(_mm256_unpacklo_ps(s04, s15));
        const __m256d b01 = _mm256_castps_pd(_mm256_unpackhi_ps(s04, s15));
        const __m256d a23 = _mm256_castps_pd(_mm256_unpacklo_ps(s26, s37));
        const __m256d b23 = _mm256_castps_pd(_mm256_unpackhi_ps(s26, s37));
        const auto wide = [](__m256d x) {
            return Doubles{_mm512_maskz_cvtps_pd(0xff, _mm256_castpd_ps(x))};
        };
        return {wide(_mm256_unpacklo_pd(a01, a23)), wide(_mm256_unpackhi_pd(a01, a23)),
                wide(_mm256_unpacklo_pd(b01, b23)), wide(_mm256_unpackhi_pd(b01, b23))};
    }

    CLIPPING_INLINE static void store(Clipped* out, const Clip<Doubles>& clip,
                                      const std::uint32_t* at, unsigned visible)
    {
        const auto& [ax, ay, bx, by] = clip.piece;
        const __m512d a02 = _mm512_unpacklo_pd(ax.v, ay.v), a13 = _mm512_unpackhi_pd(ax.v, ay.v);
        const __m512d b02 = _mm512_unpacklo_pd(bx.v, by.v), b13 = _mm512_unpackhi_pd(bx.v, by.v);
        const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
        const __m512i high = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
        alignas(64) __m512d rows[4] = {
            _mm512_permutex2var_pd(a02, low, b02), _mm512_permutex2var_pd(a13, low, b13),
            _mm512_permutex2var_pd(a02, high, b02), _mm512_permutex2var_pd(a13, high, b13)};
        const auto* row = reinterpret_cast<const double*>(rows);
        alignas(64) std::uint64_t tails[width];
        _mm512_store_si512(tails, tailsOf(clip, at));
        for (std::size_t i = 0; i < width; ++i) { // rows: 0, 2, 1, 3, 4, 6, 5, 7
            const std::size_t at8 = (i & 4) * 4 + (i & 1) * 8 + (i & 2) * 2;
            _mm256_storeu_pd(&out->segment.a.x, _mm256_load_pd(row + at8));
            __builtin_memcpy(&out->source, tails + i, 8);
            out += visible >> i & 1;
        }
    }
    CLIPPING_INLINE static void store(BasicClipped<BasicSegment<float>>* out,
                                      const Clip<Doubles>& clip, const std::uint32_t* at,
                                      unsigned visible)
    {
        const auto narrow = [](Doubles x) { return _mm512_maskz_cvtpd_ps(0xff, x.v); };
        const __m256 ax = narrow(clip.piece.ax), ay = narrow(clip.piece.ay);
        const __m256 bx = narrow(clip.piece.bx), by = narrow(clip.piece.by);
        const __m256d a01 = _mm256_castps_pd(_mm256_unpacklo_ps(ax, ay));
        const __m256d a23 = _mm256_castps_pd(_mm256_unpackhi_ps(ax, ay));
        const __m256d b01 = _mm256_castps_pd(_mm256_unpacklo_ps(bx, by));
        const __m256d b23 = _mm256_castps_pd(_mm256_unpackhi_ps(bx, by));
        alignas(64) __m256d rows[4] = {_mm256_unpacklo_pd(a01, b01), _mm256_unpackhi_pd(a01, b01),
                                       _mm256_unpacklo_pd(a23, b23), _mm256_unpackhi_pd(a23, b23)};
        const auto* row = reinterpret_cast<const float*>(rows);
        alignas(64) std::uint64_t tails[width];
        _mm512_store_si512(tails, tailsOf(clip, at));
        for (std::size_t i = 0; i < width; ++i) { // rows: 0 and 4, 1 and 5, ...
            _mm_storeu_ps(&out->segment.a.x, _mm_load_ps(row + (i & 3) * 8 + (i & 4)));
            __builtin_memcpy(&out->source, tails + i, 8);
            out += visible >> i & 1;
        }
    }

private:
    CLIPPING_INLINE static Ends<Doubles> joined(__m512d x03, __m512d y03, __m512d x47, __m512d y47)
    {
        return {{_mm512_shuffle_f64x2(x03, x47, 0x44)},
                {_mm512_shuffle_f64x2(y03, y47, 0x44)},
                {_mm512_shuffle_f64x2(x03, x47, 0xee)},
                {_mm512_shuffle_f64x2(y03, y47, 0xee)}};
    }
    /// `source` and `cut` of each lane.
    CLIPPING_INLINE static __m512i tailsOf(const Clip<Doubles>& clip, const std::uint32_t* at)
    {
        const __m512i sources = _mm512_maskz_cvtepu32_epi64(
            0xff, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at)));
        return _mm512_or_si512(sources, _mm512_castpd_si512(clip.cut.v));
    }
};

/// Sixteen floats, for the first pass.
struct Floats {
    static constexpr std::size_t width = 16;
    using Mask = Mask16;
    __m512 v;

    CLIPPING_INLINE static Floats of(float x) { return {_mm512_set1_ps(x)}; }
    LANE Floats operator+(Floats a, Floats b) { return {_mm512_add_ps(a.v, b.v)}; }
    LANE Floats operator-(Floats a, Floats b) { return {_mm512_sub_ps(a.v, b.v)}; }
    LANE Floats operator*(Floats a, Floats b) { return {_mm512_mul_ps(a.v, b.v)}; }
    LANE Floats fma(Floats a, Floats b, Floats c) { return {_mm512_fmadd_ps(a.v, b.v, c.v)}; }
    LANE Floats fnma(Floats a, Floats b, Floats c) { return {_mm512_fnmadd_ps(a.v, b.v, c.v)}; }
    LANE Floats abs(Floats a) { return {_mm512_abs_ps(a.v)}; }
    LANE Floats min(Floats a, Floats b) { return {_mm512_maskz_min_ps(0xffff, a.v, b.v)}; }
    LANE Floats max(Floats a, Floats b) { return {_mm512_maskz_max_ps(0xffff, a.v, b.v)}; }
    LANE Mask notAbove(Floats a, Floats b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_NGT_UQ)}; }
    LANE Mask operator<=(Floats a, Floats b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)}; }
    LANE Mask operator>=(Floats a, Floats b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GE_OQ)}; }

    CLIPPING_INLINE static Ends<Floats> load(const BasicSegment<float>* s)
    {
        const __m512 s03 = _mm512_loadu_ps(s), s47 = _mm512_loadu_ps(s + 4);
        const __m512 s8b = _mm512_loadu_ps(s + 8), scf = _mm512_loadu_ps(s + 12);
        const __m512i xs =
            _mm512_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28, 2, 6, 10, 14, 18, 22, 26, 30);
        const __m512i ys = _mm512_add_epi32(xs, _mm512_set1_epi32(1));
        const __m512 x07 = _mm512_permutex2var_ps(s03, xs, s47);
        const __m512 y07 = _mm512_permutex2var_ps(s03, ys, s47);
        const __m512 x8f = _mm512_permutex2var_ps(s8b, xs, scf);
        const __m512 y8f = _mm512_permutex2var_ps(s8b, ys, scf);
        return {{_mm512_shuffle_f32x4(x07, x8f, 0x44)},
                {_mm512_shuffle_f32x4(y07, y8f, 0x44)},
                {_mm512_shuffle_f32x4(x07, x8f, 0xee)},
                {_mm512_shuffle_f32x4(y07, y8f, 0xee)}};
    }
    CLIPPING_INLINE static std::size_t storeIndices(std::uint32_t* to, std::size_t first,
                                                    Mask which)
    {
        const __m512i all = _mm512_add_epi32(
            _mm512_set1_epi32(static_cast<int>(first)),
            _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
        _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(which.lanes, all));
        return static_cast<std::size_t>(__builtin_popcount(which.lanes));
    }
};

BatchResult clip(const Batch<double>& batch) { return clipAtWindow<Doubles, Doubles>(batch); }
BatchResult clipSingle(const Batch<float>& batch) { return clipAtWindow<Doubles, Floats>(batch); }
BatchResult clipPolygon(const PolygonBatch& batch) { return clipAtPolygon<Doubles>(batch); }

} // namespace

const InstructionSet avx512Set{"AVX-512", true, clip, clipSingle, clipPolygon};

} // namespace clipping

#else

const clipping::InstructionSet clipping::avx512Set{"AVX-512", false, nullptr, nullptr, nullptr};

#endif
