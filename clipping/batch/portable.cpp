// SPDX-License-Identifier: MIT
#include "clipping/algorithm.h"
#include "clipping/batch/vector_kernel.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <cmath>

namespace clipping {
namespace {

template <class Vector>
CLIPPING_INLINE Vector sixteenBytes(const void* from)
{
    Vector result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
}

/// Sixteen bytes of numbers in the compiler's vector extension.
template <class T, class Bit>
struct Numbers {
    using Vector [[gnu::vector_size(16)]] = T;
    using Bits [[gnu::vector_size(16)]] = Bit;
    static constexpr std::size_t width = 16 / sizeof(T);

    /// All bits of a lane, or none.
    struct Mask {
        Bits lanes;
        LANE Mask operator&(Mask a, Mask b) { return {a.lanes & b.lanes}; }
        LANE Mask operator|(Mask a, Mask b) { return {a.lanes | b.lanes}; }
        LANE Mask operator~(Mask a) { return {~a.lanes}; }
        LANE unsigned bits(Mask a)
        {
            unsigned result = 0;
            for (unsigned lane = 0; lane < width; ++lane)
                result |= static_cast<unsigned>(a.lanes[lane] & 1) << lane;
            return result;
        }
        LANE bool any(Mask a)
        {
            std::uint64_t halves[2];
            __builtin_memcpy(halves, &a.lanes, sizeof halves);
            return (halves[0] | halves[1]) != 0;
        }
    };

    Vector v;

    CLIPPING_INLINE static Numbers of(T x) { return {x - Vector{}}; }
    CLIPPING_INLINE static Numbers ofBits(std::uint64_t x)
    {
        return {reinterpret_cast<Vector>(Bits{} + static_cast<Bit>(x))};
    }
    CLIPPING_INLINE Bits asBits() const { return reinterpret_cast<Bits>(v); }
    LANE Numbers operator+(Numbers a, Numbers b) { return {a.v + b.v}; }
    LANE Numbers operator-(Numbers a, Numbers b) { return {a.v - b.v}; }
    LANE Numbers operator*(Numbers a, Numbers b) { return {a.v * b.v}; }
    LANE Numbers operator/(Numbers a, Numbers b) { return {a.v / b.v}; }
    LANE Numbers operator^(Numbers a, Numbers b) { return ofLanes(a.asBits() ^ b.asBits()); }
    LANE Numbers operator|(Numbers a, Numbers b) { return ofLanes(a.asBits() | b.asBits()); }
    LANE Numbers fma(Numbers a, Numbers b, Numbers c) { return a * b + c; }
    LANE Numbers fnma(Numbers a, Numbers b, Numbers c) { return c - a * b; }
    LANE Numbers abs(Numbers a) { return ofLanes(a.asBits() & ~of(T(-0.0)).asBits()); }
    LANE Numbers signOf(Numbers a) { return ofLanes(a.asBits() & of(T(-0.0)).asBits()); }
    LANE Numbers min(Numbers a, Numbers b) { return {a.v < b.v ? a.v : b.v}; }
    LANE Numbers max(Numbers a, Numbers b) { return {a.v > b.v ? a.v : b.v}; }
    LANE Mask operator<(Numbers a, Numbers b) { return {reinterpret_cast<Bits>(a.v < b.v)}; }
    LANE Mask operator>(Numbers a, Numbers b) { return {reinterpret_cast<Bits>(a.v > b.v)}; }
    LANE Mask operator<=(Numbers a, Numbers b) { return {reinterpret_cast<Bits>(a.v <= b.v)}; }
    LANE Mask operator>=(Numbers a, Numbers b) { return {reinterpret_cast<Bits>(a.v >= b.v)}; }
    /// Not a > b, or a is infinite: here a product may overflow before it is added to another.
    LANE Mask notAbove(Numbers a, Numbers b)
    {
        return ~((a > b) & (a <= of(std::numeric_limits<T>::max())));
    }
    LANE Mask operator==(Numbers a, Numbers b) { return {reinterpret_cast<Bits>(a.v == b.v)}; }
    LANE Numbers select(Mask m, Numbers a, Numbers b)
    {
        return ofLanes((m.lanes & a.asBits()) | (~m.lanes & b.asBits()));
    }
    LANE Numbers select(Numbers sign, Numbers a, Numbers b)
    {
        return select(Mask{reinterpret_cast<Bits>(sign.asBits() < 0)}, a, b);
    }
    /// NaN, infinite, or too small for a full reciprocal; but not 0.
    LANE Mask irregular(Numbers a)
    {
        const Numbers size = abs(a);
        const Mask normal = (size >= of(std::numeric_limits<T>::min()))
                            & (size <= of(std::numeric_limits<T>::max()));
        return ~(normal | (a == of(0)));
    }
    /// a * b - product (Dekker). `product` must be within a few ulps of a * b; then all sums but
    /// the last are exact. Overflow on the way ends as NaN.
    LANE Numbers restOfProduct(Numbers a, Numbers b, Numbers product)
    {
        const auto highOf = [](Numbers x) {
            const Numbers scaled = of(0x8000001p0) * x;
            return scaled - (scaled - x);
        };
        const Numbers ah = highOf(a), bh = highOf(b), al = a - ah, bl = b - bh;
        return ((ah * bh - product) + ah * bl + al * bh) + al * bl;
    }
    template <class To>
    CLIPPING_INLINE Numbers rounded() const
    {
        using Narrow [[gnu::vector_size(16 / sizeof(T) * sizeof(To))]] = To;
        return {__builtin_convertvector(__builtin_convertvector(v, Narrow), Vector)};
    }

    CLIPPING_INLINE static Ends<Numbers> load(const BasicSegment<T>* s)
    {
        if constexpr (width == 4)
            return fourFloats(s);
        else
            return twoSegments(s, s + 1);
    }
    template <class From>
    CLIPPING_INLINE static Ends<Numbers> gather(const BasicSegment<From>* s,
                                                const std::uint32_t* at)
    {
        return twoSegments(s + at[0], s + at[1]);
    }
    /// The numbers of a table at the indices that the lanes hold as bits.
    CLIPPING_INLINE static Numbers look(const double* table, Numbers indices)
    {
        return {Vector{static_cast<T>(table[indices.asBits()[0]]),
                       static_cast<T>(table[indices.asBits()[1]])}};
    }
    CLIPPING_INLINE static Numbers lookInEight(const double* table, Numbers indices)
    {
        return look(table, indices);
    }
    CLIPPING_INLINE static std::size_t storeIndices(std::uint32_t* to, std::size_t first,
                                                    Mask which)
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < width; ++i) {
            to[count] = static_cast<std::uint32_t>(first + i);
            count += static_cast<std::size_t>(which.lanes[i] & 1);
        }
        return count;
    }
    template <class To>
    CLIPPING_INLINE static void store(BasicClipped<BasicSegment<To>>* out,
                                      const Clip<Numbers>& clip, const std::uint32_t* at,
                                      unsigned visible)
    {
        const auto& [ax, ay, bx, by] = clip.piece;
        for (std::size_t i = 0; i < width; ++i) {
            out->segment.a.x = static_cast<To>(ax.v[i]);
            out->segment.a.y = static_cast<To>(ay.v[i]);
            out->segment.b.x = static_cast<To>(bx.v[i]);
            out->segment.b.y = static_cast<To>(by.v[i]);
            out->source = at[i];
            out->cut =
                static_cast<std::uint32_t>(static_cast<std::uint64_t>(clip.cut.asBits()[i]) >> 32);
            out += visible >> i & 1;
        }
    }

private:
    CLIPPING_INLINE static Numbers ofLanes(Bits bits) { return {reinterpret_cast<Vector>(bits)}; }
    CLIPPING_INLINE static Ends<Numbers> twoSegments(const Segment* s0, const Segment* s1)
    {
        const Vector a0 = sixteenBytes<Vector>(&s0->a), b0 = sixteenBytes<Vector>(&s0->b);
        const Vector a1 = sixteenBytes<Vector>(&s1->a), b1 = sixteenBytes<Vector>(&s1->b);
        return {{__builtin_shufflevector(a0, a1, 0, 2)},
                {__builtin_shufflevector(a0, a1, 1, 3)},
                {__builtin_shufflevector(b0, b1, 0, 2)},
                {__builtin_shufflevector(b0, b1, 1, 3)}};
    }
    CLIPPING_INLINE static Ends<Numbers> twoSegments(const BasicSegment<float>* s0,
                                                     const BasicSegment<float>* s1)
    {
        using Four [[gnu::vector_size(16)]] = float;
        const Four r0 = sixteenBytes<Four>(s0), r1 = sixteenBytes<Four>(s1);
        return {{__builtin_convertvector(__builtin_shufflevector(r0, r1, 0, 4), Vector)},
                {__builtin_convertvector(__builtin_shufflevector(r0, r1, 1, 5), Vector)},
                {__builtin_convertvector(__builtin_shufflevector(r0, r1, 2, 6), Vector)},
                {__builtin_convertvector(__builtin_shufflevector(r0, r1, 3, 7), Vector)}};
    }
    CLIPPING_INLINE static Ends<Numbers> fourFloats(const BasicSegment<T>* s)
    {
        const Vector r0 = sixteenBytes<Vector>(s), r1 = sixteenBytes<Vector>(s + 1);
        const Vector r2 = sixteenBytes<Vector>(s + 2), r3 = sixteenBytes<Vector>(s + 3);
        const Vector a01 = __builtin_shufflevector(r0, r1, 0, 4, 1, 5);
        const Vector a23 = __builtin_shufflevector(r2, r3, 0, 4, 1, 5);
        const Vector b01 = __builtin_shufflevector(r0, r1, 2, 6, 3, 7);
        const Vector b23 = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
        return {{__builtin_shufflevector(a01, a23, 0, 1, 4, 5)},
                {__builtin_shufflevector(a01, a23, 2, 3, 6, 7)},
                {__builtin_shufflevector(b01, b23, 0, 1, 4, 5)},
                {__builtin_shufflevector(b01, b23, 2, 3, 6, 7)}};
    }
};
using Doubles = Numbers<double, std::int64_t>;
using Floats = Numbers<float, std::int32_t>;

BatchResult clip(const Batch<double>& batch) { return clipAtWindow<Doubles, Doubles>(batch); }
BatchResult clipSingle(const Batch<float>& batch) { return clipAtWindow<Doubles, Floats>(batch); }
BatchResult clipPolygon(const PolygonBatch& batch) { return clipAtPolygon<Doubles>(batch); }

} // namespace

const InstructionSet portableSet{"portable", true, clip, clipSingle, clipPolygon};

template <class T>
bool canShow(const BasicWindow<T>& window)
{
    return withinContract(BasicSegment<T>{}, window);
}
template bool canShow(const BasicWindow<double>&);
template bool canShow(const BasicWindow<float>&);

template <class T>
Box<T> boxOf(const BasicWindow<T>& w)
{
    const auto centre = [](T low, T high) { return low / 2 + high / 2; };
    const auto half = [](T low, T high, T middle) {
        const T larger = std::max(high - middle, middle - low);
        return std::nextafter(larger, std::numeric_limits<T>::infinity());
    };
    // K of the first test (sets.h): rounding takes less than what is more than needed here.
    const auto reach = [](T halfSize, T middle) {
        constexpr T more = missFactor<T>, longer = 1 + 2 * more;
        if (!(std::abs(middle) + halfSize < mostMissed<T>))
            return std::numeric_limits<T>::infinity();
        return 2 * halfSize * longer + more * std::abs(middle) + missTiny<T>;
    };
    const T x = centre(w.min.x, w.max.x), y = centre(w.min.y, w.max.y);
    const T halfX = half(w.min.x, w.max.x, x), halfY = half(w.min.y, w.max.y, y);
    return {x, y, halfX, halfY, 2 * x, 2 * y, reach(halfX, x), reach(halfY, y)};
}
template Box<double> boxOf(const BasicWindow<double>&);
template Box<float> boxOf(const BasicWindow<float>&);

} // namespace clipping
