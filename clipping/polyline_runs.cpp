// SPDX-License-Identifier: MIT
#include "clipping/polyline_runs.h"

#include "clipping/ieee_numbers.h"
#include "clipping/polyline_clipper.h"

namespace clipping {
namespace {

template <class T>
struct Appended {
    BasicPolylineRuns<T>& out;

    void addPoints(std::span<const glm::vec<2, T>> points)
    {
        out.points.insert(out.points.end(), points.begin(), points.end());
    }
    void addRuns(std::span<const VisibleRun> runs)
    {
        out.runs.insert(out.runs.end(), runs.begin(), runs.end());
    }
};

} // namespace

template <class T>
void findRuns(std::span<const glm::vec<2, T>> points, bool closed, const BasicWindow<T>& window,
              BasicPolylineRuns<T>& out)
{
    out.points.clear();
    out.runs.clear();
    Appended<T> sink{out};
    PolylineClipper<T, Appended<T>> clipper(points, closed, window, sink);
    clipper.add(0, points.size());
    clipper.finish();
}
template void findRuns(std::span<const glm::dvec2>, bool, const Window&, PolylineRuns&);
template void findRuns(std::span<const glm::vec2>, bool, const BasicWindow<float>&,
                       BasicPolylineRuns<float>&);

void clipPolyline(std::span<const glm::dvec2> points, const Window& window, PolylineRuns& out)
{
    findRuns(points, false, window, out);
}

void clipClosedPolyline(std::span<const glm::dvec2> points, const Window& window, PolylineRuns& out)
{
    findRuns(points, true, window, out);
}

} // namespace clipping
