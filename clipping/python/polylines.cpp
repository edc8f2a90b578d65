// SPDX-License-Identifier: MIT
#include "clipping/ieee_numbers.h"
#include "clipping/polyline_clipper.h"
#include "clipping/polyline_runs.h"
#include "clipping/python/arguments.h"
#include "clipping/python/large_memory.h"
#include "clipping/python/module.h"

#include <algorithm>
#include <complex>
#include <cstring>
#include <limits>
#include <memory>

namespace py = pybind11;
using namespace py::literals;

namespace clipping::python {
namespace {

constexpr std::uint64_t mostPoints = 0xffffffff;

bool isTrue(py::handle value)
{
    const int truth = PyObject_IsTrue(value.ptr());
    if (truth < 0)
        throw py::error_already_set();
    return truth != 0;
}

py::array copyOf(std::span<const glm::dvec2> points, bool areComplex)
{
    const auto count = static_cast<py::ssize_t>(points.size());
    py::array array = areComplex ? py::array(py::array_t<std::complex<double>>(count))
                                 : py::array(py::array_t<double>({count, py::ssize_t(2)}));
    std::memcpy(array.mutable_data(), points.data(), points.size_bytes());
    return array;
}

/// The visible parts of a list of polylines, and for each the index of its polyline.
py::tuple clipLines(py::handle lines, py::handle window, py::handle closed)
{
    const py::list all = linesOf(lines);
    std::vector<Points> given;
    for (const py::handle line : all)
        given.push_back(pointsOf(line, "a line"));
    const Window edges = windowOf(window);
    const bool areClosed = isTrue(closed);
    py::list parts, sources;
    PolylineRuns runs;
    std::vector<glm::dvec2> copies;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto points = given[i].in(copies);
        {
            const Released released(points.size());
            findRuns(points, areClosed, edges, runs);
        }
        for (const VisibleRun& run : runs.runs) {
            const auto part = std::span(runs.points).subspan(run.first, run.count);
            parts.append(copyOf(part, given[i].areComplex));
            sources.append(i);
        }
    }
    return py::make_tuple(parts, sources);
}

/// Offsets of polylines among their points: from where each begins to where the last one ends.
template <class Offset>
std::vector<std::uint32_t> readOffsets(const py::array& array, std::size_t points)
{
    std::vector<std::uint32_t> offsets(static_cast<std::size_t>(array.shape(0)));
    const char* from = static_cast<const char*>(array.data());
    Offset before = 0;
    for (std::size_t i = 0; i < offsets.size(); ++i, from += array.strides(0)) {
        Offset offset;
        std::memcpy(&offset, from, sizeof offset);
        if (offset < before || std::uint64_t(offset) > points)
            throw py::value_error("offsets must not decrease, from 0 at least to the number of "
                                  "points, "
                                  + std::to_string(points) + ", at most, but offset "
                                  + std::to_string(i) + " is " + std::to_string(offset));
        offsets[i] = static_cast<std::uint32_t>(before = offset);
    }
    return offsets;
}

/// The parts of polylines with n points in all, in memory that is then given to arrays. At each
/// segment a part can begin, with two points.
template <class Offset>
class Parts {
public:
    /// `lines` are the offsets of the polylines.
    Parts(std::size_t n, std::span<const std::uint32_t> lines)
        : memory_(takeMemory(n * 2 * sizeof(glm::dvec2) + (n + 1) * sizeof(Offset)
                             + n * sizeof(std::uint32_t))),
          points_(static_cast<glm::dvec2*>(memory_.get())),
          offsets_(reinterpret_cast<Offset*>(points_ + 2 * n)),
          sources_(reinterpret_cast<std::uint32_t*>(offsets_ + n + 1)), lines_(lines)
    {
        offsets_[0] = 0;
    }

    void addPoints(std::span<const glm::dvec2> points)
    {
        std::ranges::copy(points, points_ + size_);
        size_ += points.size();
    }
    void addRuns(std::span<const VisibleRun> runs)
    {
        for (const VisibleRun& run : runs) {
            while (run.source >= lines_[line_ + 1])
                ++line_;
            sources_[runs_] = static_cast<std::uint32_t>(line_);
            offsets_[++runs_] = static_cast<Offset>(run.first + run.count);
        }
    }

    /// The points, the offsets of the parts, and their sources.
    py::tuple take(bool areComplex)
    {
        if (size_ > std::size_t(std::numeric_limits<Offset>::max()))
            throw py::value_error("the parts have " + std::to_string(size_)
                                  + " points; give the offsets as int64");
        const py::capsule owner(memory_.release(), giveMemory);
        const auto count = static_cast<py::ssize_t>(size_), runs = static_cast<py::ssize_t>(runs_);
        const auto* const numbers = reinterpret_cast<const double*>(points_);
        return py::make_tuple(
            areComplex ? py::array(py::array_t<std::complex<double>>(
                count, reinterpret_cast<const std::complex<double>*>(points_), owner))
                       : py::array(py::array_t<double>({count, py::ssize_t(2)}, numbers, owner)),
            py::array_t<Offset>(runs + 1, offsets_, owner),
            py::array_t<std::uint32_t>(runs, sources_, owner));
    }

private:
    struct Free {
        void operator()(void* memory) const { giveMemory(memory); }
    };
    std::unique_ptr<void, Free> memory_;
    glm::dvec2* points_;
    Offset* offsets_;
    std::uint32_t* sources_;
    std::span<const std::uint32_t> lines_;
    std::size_t size_ = 0, runs_ = 0, line_ = 0;
};

template <class Offset>
py::tuple clipAll(const Points& given, const py::array& array, const Window& window, bool closed)
{
    const auto lines = readOffsets<Offset>(array, given.size());
    Parts<Offset> parts(given.size(), lines);
    {
        const Released released(given.size());
        std::vector<glm::dvec2> copies;
        PolylineClipper<double, Parts<Offset>> clipper(given.in(copies), closed, window, parts);
        for (std::size_t i = 0; i + 1 < lines.size(); ++i)
            clipper.add(lines[i], lines[i + 1]);
        clipper.finish();
    }
    return parts.take(given.areComplex);
}

/// The visible parts of polylines as coordinates and offsets, and their sources
/// (clearcut.clip_polylines).
py::tuple clipPolylines(py::handle coordinates, py::handle offsets, py::handle window,
                        py::handle closed)
{
    const Points points = pointsOf(coordinates, "coordinates");
    if (points.size() > mostPoints)
        throw py::value_error("at most 4294967295 points can be clipped at once, but this is "
                              + whatIs(coordinates));
    const py::array array = offsetsOf(offsets);
    const auto clip = array.dtype().num() == py::detail::npy_api::NPY_INT_ ? clipAll<std::int32_t>
                                                                           : clipAll<std::int64_t>;
    return clip(points, array, windowOf(window), isTrue(closed));
}

} // namespace

void definePolylines(py::module_& module)
{
    module.def("clip_lines", clipLines, Guarded(), "lines"_a, "window"_a, "closed"_a);
    module.def("clip_polylines", clipPolylines, Guarded(), "coordinates"_a, "offsets"_a, "window"_a,
               "closed"_a);
}

} // namespace clipping::python
