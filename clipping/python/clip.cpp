// SPDX-License-Identifier: MIT
#include "clipping/algorithm.h"
#include "clipping/outside.h"
#include "clipping/python/arguments.h"
#include "clipping/python/exact_on_threads.h"
#include "clipping/python/module.h"
#include "clipping/python/pieces.h"
#include "clipping/python/rows.h"

namespace py = pybind11;
using namespace py::literals;

namespace clipping::python {
namespace {

template <class T>
using PieceOf = BasicClipped<BasicSegment<T>>;

/// Clips all rows into `out` with `clipAll(span of S, span of pieces)`; returns their number.
template <class S, class T, class ClipAll>
std::size_t clipRows(const Rows<T>& rows, const ClipAll& clipAll, std::span<PieceOf<T>> out)
{
    std::size_t count = 0;
    rows.template forEachBlock<S>([&](std::span<const S> block, std::size_t first) {
        const std::size_t pieces = clipAll(block, out.subspan(count));
        for (PieceOf<T>& piece : out.subspan(count, first == 0 ? 0 : pieces))
            piece.source += static_cast<std::uint32_t>(first);
        count += pieces;
    });
    return count;
}

template <class S, class T, class ClipAll>
py::tuple clipArray(const py::array& array, const ClipAll& clipAll)
{
    const Rows<T> rows(array);
    PieceBuffer<PieceOf<T>> pieces(rows.size());
    std::size_t count = 0;
    {
        const Released released(rows.size());
        count = clipRows<S, T>(rows, clipAll, pieces.room());
    }
    return pieces.take(count);
}

template <class Form>
const Form& formOf(const Form* uses, const Algorithm& row, const char* form)
{
    if (!uses)
        throw py::value_error("'" + std::string(row.key) + "' has no " + form
                              + "; clearcut.algorithms() says which algorithms have it");
    return *uses;
}

py::tuple clipAtWindow(const py::array& array, const Window& window, const Algorithm& row,
                       bool published, int threads)
{
    const auto& uses = formOf(functionsOf(row, published ? Form::Published : Form::Corrected), row,
                              "published form");
    const bool isExact = &row == &exactAlgorithm();
    return clipArray<Segment, double>(array, [&](auto in, auto out) {
        return isExact ? exactOnThreads<double>(threads, in, window, out)
                       : uses.clipAll(in, window, out);
    });
}

py::tuple clipFloats(const py::array& array, const Window& window, const Algorithm& row,
                     int threads)
{
    const BasicWindow<float> rounded{glm::vec2(window.min), glm::vec2(window.max)};
    const bool isExact = &row == &exactAlgorithm();
    return clipArray<BasicSegment<float>, float>(array, [&](auto in, auto out) {
        return isExact ? exactOnThreads<float>(threads, in, rounded, out)
                       : row.floats->clipAll(in, rounded, out);
    });
}

template <class Shape>
py::tuple clipAs(const py::array& array, const Window& window,
                 const Functions<Shape, Window, Segment>& form)
{
    return clipArray<Shape, double>(
        array, [&](auto in, auto out) { return form.clipAll(in, window, out); });
}

py::tuple clipAtPolygon(const py::array& array, const std::vector<glm::dvec2>& corners,
                        const Algorithm& row)
{
    formOf(row.polygon, row, "form for convex polygons");
    const ConvexWindow polygon = polygonOf(corners);
    return clipArray<Segment, double>(
        array, [&](auto in, auto out) { return clipAllAt(polygon, row, in, out); });
}

void refuseCombinations(const py::array& array, bool atPolygon, py::handle kind, bool areSegments,
                        bool published)
{
    if (atPolygon && !areSegments)
        throw py::value_error("a polygon clips segments only, but kind is "
                              + py::repr(kind).cast<std::string>());
    if (published && (atPolygon || !areSegments))
        throw py::value_error("published forms clip segments at a window only");
    if (isFloat32(array) && (atPolygon || published || !areSegments))
        throw py::type_error("float32 works with segments, windows and corrected forms only; use "
                             ".astype(float)");
}

/// The visible pieces, their sources and cuts (clearcut.clip).
py::tuple clip(py::handle segments, py::handle window, py::handle polygon, py::handle kind,
               py::handle algorithm, py::handle form, py::handle threads)
{
    const py::array array = segmentsOf(segments);
    const Algorithm& row = algorithmOf(algorithm);
    const std::size_t shape = choiceOf(kind, "kind", {"segment", "line", "ray"});
    const bool published = choiceOf(form, "form", {"corrected", "published"}) == 1;
    const int count = threadsOf(threads);
    if (window.is_none() == polygon.is_none())
        throw py::type_error("give either a window or a polygon");
    refuseCombinations(array, !polygon.is_none(), kind, shape == 0, published);
    if (!polygon.is_none())
        return clipAtPolygon(array, cornersOf(polygon), row);
    const Window edges = windowOf(window);
    if (shape == 1)
        return clipAs(array, edges, formOf(row.line, row, "form for infinite lines"));
    if (shape == 2)
        return clipAs(array, edges, formOf(row.ray, row, "form for rays"));
    if (isFloat32(array))
        return clipFloats(array, edges, row, count);
    return clipAtWindow(array, edges, row, published, count);
}

/// The pieces inside and those outside (clearcut.split).
py::tuple split(py::handle segments, py::handle window)
{
    const Rows<double> rows(doublesOf(segments, "segments to split"));
    const Window edges = windowOf(window);
    PieceBuffer<Clipped> inside(rows.size()), outside(2 * rows.size());
    std::size_t in = 0, out = 0;
    {
        const Released released(rows.size());
        rows.forEachBlock<Segment>([&](std::span<const Segment> block, std::size_t first) {
            const auto here = inside.room().subspan(in);
            const auto pieces = here.first(exactAlgorithm().corrected.clipAll(block, edges, here));
            const auto room = outside.room().subspan(out);
            const auto removed = room.first(outsideAll(block, pieces, room));
            for (const auto part : {pieces, removed})
                for (Clipped& piece : part)
                    piece.source += static_cast<std::uint32_t>(first);
            in += pieces.size();
            out += removed.size();
        });
    }
    return py::make_tuple(inside.take(in), outside.take(out));
}

} // namespace

void defineClip(py::module_& module)
{
    module.def("clip", clip, Guarded(), "segments"_a, "window"_a, "polygon"_a, "kind"_a,
               "algorithm"_a, "form"_a, "threads"_a);
    module.def("split", split, Guarded(), "segments"_a, "window"_a);
}

} // namespace clipping::python
