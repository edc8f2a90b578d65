// SPDX-License-Identifier: MIT
#include "clipping/batch/vector_kernel.h"
#include "clipping/ieee_numbers.h"

#if defined(__AVX2__) && defined(__FMA__)

#include <immintrin.h>

namespace clipping {
namespace {

/// All bits of a lane, or none.
struct LaneMask {
    __m256d lanes;
    LANE LaneMask operator&(LaneMask a, LaneMask b) { return {_mm256_and_pd(a.lanes, b.lanes)}; }
    LANE LaneMask operator|(LaneMask a, LaneMask b) { return {_mm256_or_pd(a.lanes, b.lanes)}; }
    LANE LaneMask operator~(LaneMask a)
    {
        return {_mm256_xor_pd(a.lanes, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))};
    }
    LANE bool any(LaneMask a) { return bits(a) != 0; }
    LANE unsigned bits(LaneMask a) { return static_cast<unsigned>(_mm256_movemask_pd(a.lanes)); }
};

/// For each set of lanes out of four: the bytes of those lanes, in order, at the front.
struct FrontTable {
    alignas(16) std::uint8_t bytes[16][16];
};
constexpr FrontTable frontTable()
{
    FrontTable table{};
    for (unsigned which = 0; which < 16; ++which) {
        unsigned place = 0;
        for (unsigned lane = 0; lane < 4; ++lane)
            if (which >> lane & 1) {
                for (unsigned byte = 0; byte < 4; ++byte)
                    table.bytes[which][4 * place + byte] =
                        static_cast<std::uint8_t>(4 * lane + byte);
                ++place;
            }
    }
    return table;
}
constexpr FrontTable front = frontTable();

/// Writes first + lane for each set lane of four; returns their number.
CLIPPING_INLINE std::size_t storeFour(std::uint32_t* to, std::size_t first, unsigned which)
{
    const __m128i all =
        _mm_add_epi32(_mm_set1_epi32(static_cast<int>(first)), _mm_setr_epi32(0, 1, 2, 3));
    const __m128i order = _mm_load_si128(reinterpret_cast<const __m128i*>(front.bytes[which]));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_shuffle_epi8(all, order));
    return static_cast<std::size_t>(__builtin_popcount(which));
}

/// Four doubles.
struct Doubles {
    static constexpr std::size_t width = 4;
    using Mask = LaneMask;
    __m256d v;

    CLIPPING_INLINE static Doubles of(double x) { return {_mm256_set1_pd(x)}; }
    CLIPPING_INLINE static Doubles ofBits(std::uint64_t x)
    {
        return {_mm256_castsi256_pd(_mm256_set1_epi64x(static_cast<long long>(x)))};
    }
    LANE Doubles operator+(Doubles a, Doubles b) { return {_mm256_add_pd(a.v, b.v)}; }
    LANE Doubles operator-(Doubles a, Doubles b) { return {_mm256_sub_pd(a.v, b.v)}; }
    LANE Doubles operator*(Doubles a, Doubles b) { return {_mm256_mul_pd(a.v, b.v)}; }
    LANE Doubles operator/(Doubles a, Doubles b) { return {_mm256_div_pd(a.v, b.v)}; }
    LANE Doubles operator^(Doubles a, Doubles b) { return {_mm256_xor_pd(a.v, b.v)}; }
    LANE Doubles operator|(Doubles a, Doubles b) { return {_mm256_or_pd(a.v, b.v)}; }
    LANE Doubles fma(Doubles a, Doubles b, Doubles c) { return {_mm256_fmadd_pd(a.v, b.v, c.v)}; }
    /// a * b - c, where c is nearly a * b.
    LANE Doubles restOfProduct(Doubles a, Doubles b, Doubles c)
    {
        return {_mm256_fmsub_pd(a.v, b.v, c.v)};
    }
    LANE Doubles fnma(Doubles a, Doubles b, Doubles c) { return {_mm256_fnmadd_pd(a.v, b.v, c.v)}; }
    LANE Doubles abs(Doubles a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)}; }
    LANE Doubles min(Doubles a, Doubles b) { return {_mm256_min_pd(a.v, b.v)}; }
    LANE Doubles max(Doubles a, Doubles b) { return {_mm256_max_pd(a.v, b.v)}; }
    LANE Doubles signOf(Doubles a) { return {_mm256_and_pd(a.v, _mm256_set1_pd(-0.0))}; }
    LANE Mask operator<(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)}; }
    LANE Mask operator>(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)}; }
    LANE Mask notAbove(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_NGT_UQ)}; }
    LANE Mask operator<=(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)}; }
    LANE Mask operator>=(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GE_OQ)}; }
    LANE Mask operator==(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)}; }
    LANE Doubles select(Mask m, Doubles a, Doubles b)
    {
        return {_mm256_blendv_pd(b.v, a.v, m.lanes)};
    }
    LANE Doubles select(Doubles sign, Doubles a, Doubles b)
    {
        return {_mm256_blendv_pd(b.v, a.v, sign.v)};
    }
    /// NaN, infinite, or too small for a full reciprocal; but not 0.
    LANE Mask irregular(Doubles a)
    {
        const Doubles size = abs(a);
        const Mask normal = (size >= of(std::numeric_limits<double>::min()))
                            & (size <= of(std::numeric_limits<double>::max()));
        return ~(normal | (a == of(0)));
    }
    template <class T>
    CLIPPING_INLINE Doubles rounded() const
    {
        if constexpr (sizeof(T) == sizeof(double))
            return *this;
        else
            return {_mm256_cvtps_pd(_mm256_cvtpd_ps(v))};
    }

    CLIPPING_INLINE static Ends<Doubles> load(const Segment* s)
    {
        return joined(s, s + 1, s + 2, s + 3);
    }
    CLIPPING_INLINE static std::size_t storeIndices(std::uint32_t* to, std::size_t first,
                                                    Mask which)
    {
        return storeFour(to, first, bits(which));
    }
    /// The numbers of a table at the indices that the lanes hold as bits.
    CLIPPING_INLINE static Doubles look(const double* table, Doubles indices)
    {
        return {_mm256_i64gather_pd(table, _mm256_castpd_si256(indices.v), 8)};
    }
    CLIPPING_INLINE static Doubles lookInEight(const double* table, Doubles indices)
    {
        return look(table, indices);
    }
    CLIPPING_INLINE static Ends<Doubles> gather(const Segment* s, const std::uint32_t* at)
    {
        return joined(s + at[0], s + at[1], s + at[2], s + at[3]);
    }
    CLIPPING_INLINE static Ends<Doubles> gather(const BasicSegment<float>* s,
                                                const std::uint32_t* at)
    {
        __m128 ax = _mm_loadu_ps(&s[at[0]].a.x), ay = _mm_loadu_ps(&s[at[1]].a.x);
        __m128 bx = _mm_loadu_ps(&s[at[2]].a.x), by = _mm_loadu_ps(&s[at[3]].a.x);
        _MM_TRANSPOSE4_PS(ax, ay, bx, by);
        return {{_mm256_cvtps_pd(ax)},
                {_mm256_cvtps_pd(ay)},
                {_mm256_cvtps_pd(bx)},
                {_mm256_cvtps_pd(by)}};
    }

    CLIPPING_INLINE static void store(Clipped* out, const Clip<Doubles>& clip,
                                      const std::uint32_t* at, unsigned visible)
    {
        const auto& [ax, ay, bx, by] = clip.piece;
        const __m256d a02 = _mm256_unpacklo_pd(ax.v, ay.v), a13 = _mm256_unpackhi_pd(ax.v, ay.v);
        const __m256d b02 = _mm256_unpacklo_pd(bx.v, by.v), b13 = _mm256_unpackhi_pd(bx.v, by.v);
        const __m256d rows[4] = {
            _mm256_permute2f128_pd(a02, b02, 0x20), _mm256_permute2f128_pd(a13, b13, 0x20),
            _mm256_permute2f128_pd(a02, b02, 0x31), _mm256_permute2f128_pd(a13, b13, 0x31)};
        alignas(32) std::uint64_t tails[width];
        _mm256_store_si256(reinterpret_cast<__m256i*>(tails), tailsOf(clip, at));
        for (std::size_t i = 0; i < width; ++i) {
            _mm256_storeu_pd(&out->segment.a.x, rows[i]);
            __builtin_memcpy(&out->source, tails + i, 8);
            out += visible >> i & 1;
        }
    }
    CLIPPING_INLINE static void store(BasicClipped<BasicSegment<float>>* out,
                                      const Clip<Doubles>& clip, const std::uint32_t* at,
                                      unsigned visible)
    {
        __m128 r0 = _mm256_cvtpd_ps(clip.piece.ax.v), r1 = _mm256_cvtpd_ps(clip.piece.ay.v);
        __m128 r2 = _mm256_cvtpd_ps(clip.piece.bx.v), r3 = _mm256_cvtpd_ps(clip.piece.by.v);
        _MM_TRANSPOSE4_PS(r0, r1, r2, r3);
        const __m128 rows[4] = {r0, r1, r2, r3};
        alignas(32) std::uint64_t tails[width];
        _mm256_store_si256(reinterpret_cast<__m256i*>(tails), tailsOf(clip, at));
        for (std::size_t i = 0; i < width; ++i) {
            _mm_storeu_ps(&out->segment.a.x, rows[i]);
            __builtin_memcpy(&out->source, tails + i, 8);
            out += visible >> i & 1;
        }
    }

private:
    CLIPPING_INLINE static Ends<Doubles> joined(const Segment* s0, const Segment* s1,
                                                const Segment* s2, const Segment* s3)
    {
        const __m256d r0 = _mm256_loadu_pd(&s0->a.x), r1 = _mm256_loadu_pd(&s1->a.x);
        const __m256d r2 = _mm256_loadu_pd(&s2->a.x), r3 = _mm256_loadu_pd(&s3->a.x);
        const __m256d x01 = _mm256_unpacklo_pd(r0, r1), y01 = _mm256_unpackhi_pd(r0, r1);
        const __m256d x23 = _mm256_unpacklo_pd(r2, r3), y23 = _mm256_unpackhi_pd(r2, r3);
        return {{_mm256_permute2f128_pd(x01, x23, 0x20)},
                {_mm256_permute2f128_pd(y01, y23, 0x20)},
                {_mm256_permute2f128_pd(x01, x23, 0x31)},
                {_mm256_permute2f128_pd(y01, y23, 0x31)}};
    }
    /// `source` and `cut` of each lane.
    CLIPPING_INLINE static __m256i tailsOf(const Clip<Doubles>& clip, const std::uint32_t* at)
    {
        const __m256i sources =
            _mm256_cvtepu32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)));
        return _mm256_or_si256(sources, _mm256_castpd_si256(clip.cut.v));
    }
};

/// Eight floats, for the first pass.
struct Floats {
    static constexpr std::size_t width = 8;
    struct Mask {
        __m256 lanes;
        LANE Mask operator&(Mask a, Mask b) { return {_mm256_and_ps(a.lanes, b.lanes)}; }
        LANE Mask operator~(Mask a)
        {
            return {_mm256_xor_ps(a.lanes, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))};
        }
        LANE bool any(Mask a) { return _mm256_movemask_ps(a.lanes) != 0; }
    };
    __m256 v;

    CLIPPING_INLINE static Floats of(float x) { return {_mm256_set1_ps(x)}; }
    LANE Floats operator+(Floats a, Floats b) { return {_mm256_add_ps(a.v, b.v)}; }
    LANE Floats operator-(Floats a, Floats b) { return {_mm256_sub_ps(a.v, b.v)}; }
    LANE Floats operator*(Floats a, Floats b) { return {_mm256_mul_ps(a.v, b.v)}; }
    LANE Floats fma(Floats a, Floats b, Floats c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
    LANE Floats fnma(Floats a, Floats b, Floats c) { return {_mm256_fnmadd_ps(a.v, b.v, c.v)}; }
    LANE Floats abs(Floats a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)}; }
    LANE Floats min(Floats a, Floats b) { return {_mm256_min_ps(a.v, b.v)}; }
    LANE Floats max(Floats a, Floats b) { return {_mm256_max_ps(a.v, b.v)}; }
    LANE Mask notAbove(Floats a, Floats b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_NGT_UQ)}; }
    LANE Mask operator<=(Floats a, Floats b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
    LANE Mask operator>=(Floats a, Floats b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)}; }

    CLIPPING_INLINE static Ends<Floats> load(const BasicSegment<float>* s)
    {
        const auto two = [&](int low, int high) {
            return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(&s[low].a.x)),
                                        _mm_loadu_ps(&s[high].a.x), 1);
        };
        const __m256 s04 = two(0, 4), s15 = two(1, 5), s26 = two(2, 6), s37 = two(3, 7);
        const __m256d a01 = _mm256_castps_pd(_mm256_unpacklo_ps(s04, s15));
        const __m256d b01 = _mm256_castps_pd(_mm256_unpackhi_ps(s04, s15));
        const __m256d a23 = _mm256_castps_pd(_mm256_unpacklo_ps(s26, s37));
        const __m256d b23 = _mm256_castps_pd(_mm256_unpackhi_ps(s26, s37));
        return {{_mm256_castpd_ps(_mm256_unpacklo_pd(a01, a23))},
                {_mm256_castpd_ps(_mm256_unpackhi_pd(a01, a23))},
                {_mm256_castpd_ps(_mm256_unpacklo_pd(b01, b23))},
                {_mm256_castpd_ps(_mm256_unpackhi_pd(b01, b23))}};
    }
    CLIPPING_INLINE static std::size_t storeIndices(std::uint32_t* to, std::size_t first,
                                                    Mask which)
    {
        const auto all = static_cast<unsigned>(_mm256_movemask_ps(which.lanes));
        const std::size_t low = storeFour(to, first, all & 15);
        return low + storeFour(to + low, first + 4, all >> 4);
    }
};

BatchResult clip(const Batch<double>& batch) { return clipAtWindow<Doubles, Doubles>(batch); }
BatchResult clipSingle(const Batch<float>& batch) { return clipAtWindow<Doubles, Floats>(batch); }
BatchResult clipPolygon(const PolygonBatch& batch) { return clipAtPolygon<Doubles>(batch); }

} // namespace

const InstructionSet avx2Set{"AVX2", true, clip, clipSingle, clipPolygon};

} // namespace clipping

#else

const clipping::InstructionSet clipping::avx2Set{"AVX2", false, nullptr, nullptr, nullptr};

#endif
