// SPDX-License-Identifier: MIT
#include "clipping/clip.h"

#include "clipping/algorithms/best.h"
#include "clipping/batch/sets.h"
#include "clipping/blocks.h"
#include "clipping/gradual_underflow.h"
#include "clipping/ieee_numbers.h"
#include "clipping/polygon/line_or_ray.h"
#include "clipping/polygon/window_data.h"

namespace clipping {
namespace {

template <class Shape>
const Functions<Shape, Window, Segment>& lineOrRay()
{
    if constexpr (std::is_same_v<Shape, Line>)
        return liangBarskyLine;
    else
        return liangBarskyRay;
}

std::size_t clipAtPolygon(std::span<const Segment> in, const ConvexWindow::Data& window,
                          Clipped* out)
{
    if (window.table)
        return clipBatch({in.data(), 0, in.size(), &window.polygon, &window.table->table(), out})
            .pieces;
    std::size_t visible = 0;
    for (std::uint32_t i = 0; i < in.size(); ++i)
        visible += clipOneByOne(in.data(), &i, 1, window.polygon, out + visible);
    return visible;
}

/// Clips the segments of a view with a `clip` of arrays, at once if they are an array that goes
/// into another with enough room.
template <class T, class Clip>
Progress clipView(const SegmentsView<T>& in, const Output<T>& out, const Clip& clip)
{
    const BasicSegment<T>* const array = in.array();
    if (array && out.pieces() && out.room() >= in.size() && in.size() < tooMany)
        return {in.size(), clip(std::span(array, in.size()), out.pieces())};
    return clipInBlocks(
        in.size(), out, [&](std::size_t i) { return in[i]; }, clip);
}

template <class T>
Progress clipAtWindow(const SegmentsView<T>& in, const BasicWindow<T>& window, const Output<T>& out)
{
    const GradualUnderflow here;
    return clipView(in, out, [&](std::span<const BasicSegment<T>> block, auto* pieces) {
        return clipBatch(Batch<T>{block.data(), 0, block.size(), window, pieces}).pieces;
    });
}

/// Lines or rays, in double, with a `clip` of arrays.
template <class Shape, template <class> class LineOrRay, class T, class Clip>
Progress clipLinesOrRays(const LinesOrRaysView<LineOrRay, T>& in, const Output<T>& out,
                         const Clip& clip)
{
    const GradualUnderflow here;
    return clipInBlocks(
        in.size(), out,
        [&](std::size_t i) {
            const LineOrRay<T> read = in[i];
            return Shape{glm::dvec2(read.a), glm::dvec2(read.b)};
        },
        clip);
}
template <class Shape, template <class> class LineOrRay, class T>
Progress clipAtWindow(const LinesOrRaysView<LineOrRay, T>& in, const BasicWindow<T>& window,
                      const Output<T>& out)
{
    const Window w{glm::dvec2(window.min), glm::dvec2(window.max)};
    return clipLinesOrRays<Shape>(in, out, [&](std::span<const Shape> block, Clipped* pieces) {
        return lineOrRay<Shape>().clipAll(block, w, {pieces, block.size()});
    });
}
template <Reach reach, class T>
Progress clipAtPolygon(const auto& in, const ConvexWindow& window, const Output<T>& out)
{
    using Shape = LineOrRay<reach>;
    return clipLinesOrRays<Shape>(in, out, [&](std::span<const Shape> block, Clipped* pieces) {
        std::size_t visible = 0;
        for (std::uint32_t i = 0; window && i < block.size(); ++i)
            if (const auto piece =
                    lineOrRayInPolygon<reach>({block[i].a, block[i].b}, window.data()->polygon))
                pieces[visible++] = {piece->segment, i,
                                     polygonCutAt(piece->numberOfA, piece->numberOfB)};
        return visible;
    });
}

/// One of anything, by the functions for many.
template <class T, class Many>
std::optional<BasicSegment<T>> clipOne(const Many& clipMany)
{
    BasicClipped<BasicSegment<T>> piece;
    return clipMany(Output<T>(std::span(&piece, 1))).visible == 1 ? std::optional(piece.segment)
                                                                  : std::nullopt;
}

} // namespace

std::optional<Segment> clip(const Segment& segment, const Window& window) noexcept
{
    const GradualUnderflow here;
    return exactWindow.clip(segment, window);
}

std::optional<BasicSegment<float>> clip(const BasicSegment<float>& segment,
                                        const BasicWindow<float>& window) noexcept
{
    const GradualUnderflow here;
    return exactFloats.clip(segment, window);
}

std::optional<Segment> clip(const Segment& segment, const ConvexWindow& window) noexcept
{
    const GradualUnderflow here;
    Clipped piece;
    const std::uint32_t only = 0;
    if (!window || clipOneByOne(&segment, &only, 1, window.data()->polygon, &piece) == 0)
        return std::nullopt;
    return piece.segment;
}

std::optional<BasicSegment<float>> clip(const BasicSegment<float>& segment,
                                        const ConvexWindow& window) noexcept
{
    const GradualUnderflow here;
    const auto piece = clip(converted<double>(segment), window);
    return piece ? std::optional(converted<float>(*piece)) : std::nullopt;
}

std::optional<Segment> clip(const Line& line, const Window& window) noexcept
{
    const GradualUnderflow here;
    return liangBarskyLine.clip(line, window);
}

std::optional<BasicSegment<float>> clip(const BasicLine<float>& line,
                                        const BasicWindow<float>& window) noexcept
{
    return clipOne<float>(
        [&](const Output<float>& out) { return clipAll(std::span(&line, 1), window, out); });
}

std::optional<Segment> clip(const Ray& ray, const Window& window) noexcept
{
    const GradualUnderflow here;
    return liangBarskyRay.clip(ray, window);
}

std::optional<BasicSegment<float>> clip(const BasicRay<float>& ray,
                                        const BasicWindow<float>& window) noexcept
{
    return clipOne<float>(
        [&](const Output<float>& out) { return clipAll(std::span(&ray, 1), window, out); });
}

std::optional<Segment> clip(const Line& line, const ConvexWindow& window) noexcept
{
    return clipOne<double>(
        [&](const Output<double>& out) { return clipAll(std::span(&line, 1), window, out); });
}

std::optional<BasicSegment<float>> clip(const BasicLine<float>& line,
                                        const ConvexWindow& window) noexcept
{
    return clipOne<float>(
        [&](const Output<float>& out) { return clipAll(std::span(&line, 1), window, out); });
}

std::optional<Segment> clip(const Ray& ray, const ConvexWindow& window) noexcept
{
    return clipOne<double>(
        [&](const Output<double>& out) { return clipAll(std::span(&ray, 1), window, out); });
}

std::optional<BasicSegment<float>> clip(const BasicRay<float>& ray,
                                        const ConvexWindow& window) noexcept
{
    return clipOne<float>(
        [&](const Output<float>& out) { return clipAll(std::span(&ray, 1), window, out); });
}

std::optional<Segment3> clip(const Segment3& segment, const Window3& box) noexcept
{
    const GradualUnderflow here;
    return liangBarskyBox.clip(segment, box);
}

Progress clipAll(const SegmentsView<double>& in, const Window& window, Output<double> out) noexcept
{
    return clipAtWindow(in, window, out);
}

Progress clipAll(const SegmentsView<float>& in, const BasicWindow<float>& window,
                 Output<float> out) noexcept
{
    return clipAtWindow(in, window, out);
}

Progress clipAll(const SegmentsView<double>& in, const ConvexWindow& window,
                 Output<double> out) noexcept
{
    const GradualUnderflow here;
    return clipView(in, out, [&](std::span<const Segment> block, Clipped* pieces) {
        return window ? clipAtPolygon(block, *window.data(), pieces) : 0;
    });
}

Progress clipAll(const SegmentsView<float>& in, const ConvexWindow& window,
                 Output<float> out) noexcept
{
    const GradualUnderflow here;
    return clipInBlocks(
        in.size(), out, [&](std::size_t i) { return converted<double>(in[i]); },
        [&](std::span<const Segment> block, Clipped* pieces) {
            return window ? clipAtPolygon(block, *window.data(), pieces) : 0;
        });
}

Progress clipAll(const LinesView<double>& in, const Window& window, Output<double> out) noexcept
{
    return clipAtWindow<Line>(in, window, out);
}

Progress clipAll(const LinesView<float>& in, const BasicWindow<float>& window,
                 Output<float> out) noexcept
{
    return clipAtWindow<Line>(in, window, out);
}

Progress clipAll(const RaysView<double>& in, const Window& window, Output<double> out) noexcept
{
    return clipAtWindow<Ray>(in, window, out);
}

Progress clipAll(const RaysView<float>& in, const BasicWindow<float>& window,
                 Output<float> out) noexcept
{
    return clipAtWindow<Ray>(in, window, out);
}

Progress clipAll(const LinesView<double>& in, const ConvexWindow& window,
                 Output<double> out) noexcept
{
    return clipAtPolygon<Reach::BothWays>(in, window, out);
}

Progress clipAll(const LinesView<float>& in, const ConvexWindow& window, Output<float> out) noexcept
{
    return clipAtPolygon<Reach::BothWays>(in, window, out);
}

Progress clipAll(const RaysView<double>& in, const ConvexWindow& window,
                 Output<double> out) noexcept
{
    return clipAtPolygon<Reach::OneWay>(in, window, out);
}

Progress clipAll(const RaysView<float>& in, const ConvexWindow& window, Output<float> out) noexcept
{
    return clipAtPolygon<Reach::OneWay>(in, window, out);
}

Progress clipAll(std::span<const Segment3> in, const Window3& box,
                 std::span<BasicClipped<Segment3>> out) noexcept
{
    const GradualUnderflow here;
    const std::size_t count = std::min(in.size(), tooMany - 1);
    Progress done;
    while (true) {
        const auto rest = out.subspan(done.visible);
        const std::size_t size = std::min(count - done.segments, rest.size());
        if (size == 0)
            return done;
        const auto block = in.subspan(done.segments, size);
        const std::size_t found = liangBarskyBox.clipAll(block, box, rest);
        for (auto& piece : rest.first(found))
            piece.source += static_cast<std::uint32_t>(done.segments);
        done.segments += size, done.visible += found;
    }
}

} // namespace clipping
