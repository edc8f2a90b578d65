// SPDX-License-Identifier: MIT
#include "clipping/algorithm.h"
#include "clipping/outside.h"
#include "clipping/python/exact_on_threads.h"
#include "clipping/python/module.h"
#include "clipping/python/pieces.h"
#include "clipping/python/rows.h"

#include <pybind11/stl.h>

namespace py = pybind11;
using namespace py::literals;

namespace clipping::python {
namespace {

template <class T>
using PieceOf = BasicClipped<BasicSegment<T>>;

template <class T>
BasicWindow<T> windowOf(const WindowNumbers& w)
{
    return {{T(w[0]), T(w[1])}, {T(w[2]), T(w[3])}};
}

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
        const py::gil_scoped_release released;
        count = clipRows<S, T>(rows, clipAll, pieces.room());
    }
    return pieces.take(count);
}

const Algorithm& rowOf(const std::string& key)
{
    const Algorithm* row = findAlgorithm(key);
    if (!row)
        throw py::value_error("there is no algorithm '" + key
                              + "'; clearcut.algorithms() lists them all");
    return *row;
}

template <class Form>
const Form& formOf(const Form* uses, const Algorithm& row, const char* form)
{
    if (!uses)
        throw py::value_error("'" + std::string(row.key) + "' has no " + form
                              + "; clearcut.algorithms() says which algorithms have it");
    return *uses;
}

py::tuple clipAtWindow(const py::array& array, const WindowNumbers& numbers, const std::string& key,
                       bool published, int threads)
{
    const Algorithm& row = rowOf(key);
    const Window window = windowOf<double>(numbers);
    const auto& uses = formOf(functionsOf(row, published ? Form::Published : Form::Corrected), row,
                              "published form");
    const bool isExact = &row == &exactAlgorithm();
    return clipArray<Segment, double>(array, [&](auto in, auto out) {
        return isExact ? exactOnThreads<double>(threads, in, window, out)
                       : uses.clipAll(in, window, out);
    });
}

py::tuple clipFloats(const py::array& array, const WindowNumbers& numbers, const std::string& key,
                     int threads)
{
    const Algorithm& row = rowOf(key);
    const auto window = windowOf<float>(numbers);
    const bool isExact = &row == &exactAlgorithm();
    return clipArray<BasicSegment<float>, float>(array, [&](auto in, auto out) {
        return isExact ? exactOnThreads<float>(threads, in, window, out)
                       : row.floats->clipAll(in, window, out);
    });
}

template <class Shape>
py::tuple clipAs(const py::array& array, const WindowNumbers& numbers,
                 const Functions<Shape, Window, Segment>& form)
{
    const Window window = windowOf<double>(numbers);
    return clipArray<Shape, double>(
        array, [&](auto in, auto out) { return form.clipAll(in, window, out); });
}

py::tuple clipLines(const py::array& array, const WindowNumbers& numbers, const std::string& key)
{
    const Algorithm& row = rowOf(key);
    return clipAs(array, numbers, formOf(row.line, row, "form for infinite lines"));
}

py::tuple clipRays(const py::array& array, const WindowNumbers& numbers, const std::string& key)
{
    const Algorithm& row = rowOf(key);
    return clipAs(array, numbers, formOf(row.ray, row, "form for rays"));
}

py::tuple clipAtPolygon(const py::array& array, const std::vector<std::array<double, 2>>& corners,
                        const std::string& key)
{
    const Algorithm& row = rowOf(key);
    formOf(row.polygon, row, "form for convex polygons");
    const ConvexWindow polygon = polygonOf(corners);
    return clipArray<Segment, double>(
        array, [&](auto in, auto out) { return clipAllAt(polygon, row, in, out); });
}

py::tuple outsideOf(const py::array& array, const WindowNumbers& numbers)
{
    const Rows<double> rows(array);
    const Window window = windowOf<double>(numbers);
    PieceBuffer<Clipped> inside(rows.size()), outside(2 * rows.size());
    std::size_t in = 0, out = 0;
    {
        const py::gil_scoped_release released;
        rows.forEachBlock<Segment>([&](std::span<const Segment> block, std::size_t first) {
            const auto here = inside.room().subspan(in);
            const auto pieces = here.first(exactAlgorithm().corrected.clipAll(block, window, here));
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
    module.def("clip_at_window", clipAtWindow, Guarded(), "segments"_a, "window"_a, "key"_a,
               "published"_a, "threads"_a);
    module.def("clip_floats", clipFloats, Guarded(), "segments"_a, "window"_a, "key"_a,
               "threads"_a);
    module.def("clip_lines_at_window", clipLines, Guarded(), "segments"_a, "window"_a, "key"_a);
    module.def("clip_rays_at_window", clipRays, Guarded(), "segments"_a, "window"_a, "key"_a);
    module.def("clip_at_polygon", clipAtPolygon, Guarded(), "segments"_a, "corners"_a, "key"_a);
    module.def("split", outsideOf, Guarded(), "segments"_a, "window"_a);
}

} // namespace clipping::python
