// SPDX-License-Identifier: MIT
#include "clipping/polyline.h"
#include "clipping/python/module.h"

#include <cstring>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace py = pybind11;
using namespace py::literals;

namespace clipping::python {
namespace {

using Points = py::array_t<double>;

std::vector<glm::dvec2> pointsOf(const Points& array)
{
    const auto numbers = array.unchecked<2>();
    std::vector<glm::dvec2> points(static_cast<std::size_t>(numbers.shape(0)));
    for (py::ssize_t i = 0; i < numbers.shape(0); ++i)
        points[static_cast<std::size_t>(i)] = {numbers(i, 0), numbers(i, 1)};
    return points;
}

Points arrayOf(const PolylineRuns& runs, const VisibleRun& run)
{
    Points array({static_cast<py::ssize_t>(run.count), py::ssize_t(2)});
    std::memcpy(array.mutable_data(), runs.points.data() + run.first,
                run.count * sizeof(glm::dvec2));
    return array;
}

/// The visible runs of polylines of shape (k, 2), and for each the index of its polyline.
py::tuple clipPolylines(const py::list& polylines, const WindowNumbers& w, bool closed)
{
    const Window window{{w[0], w[1]}, {w[2], w[3]}};
    py::list found, sources;
    PolylineRuns runs;
    for (std::size_t i = 0; i < polylines.size(); ++i) {
        const auto points = pointsOf(polylines[i].cast<Points>());
        {
            const py::gil_scoped_release released;
            (closed ? clipClosedPolyline : clipPolyline)(points, window, runs);
        }
        for (const VisibleRun& run : runs.runs) {
            found.append(arrayOf(runs, run));
            sources.append(i);
        }
    }
    return py::make_tuple(found, sources);
}

} // namespace

void definePolylines(py::module_& module)
{
    module.def("clip_polylines", clipPolylines, Guarded(), "lines"_a, "window"_a, "closed"_a);
}

} // namespace clipping::python
