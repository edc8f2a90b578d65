// SPDX-License-Identifier: MIT
#include "clipping/polyline_runs.h"
#include "clipping/python/arguments.h"
#include "clipping/python/module.h"

#include <bit>
#include <cstring>
#include <utility>

// Lines as well-known binary (OGC 06-103r4), in this machine's byte order and with two coordinates
// a point: the form in which shapely gives and takes them in the least time.

namespace py = pybind11;
using namespace py::literals;

namespace clipping::python {
namespace {

enum class Kind : std::uint32_t { Point = 1, Line = 2, Lines = 5, Collection = 7 };

class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    /// Appends the points of a line, or of several, and where each of them ends.
    void read(std::vector<glm::dvec2>& points, std::vector<std::uint32_t>& ends)
    {
        if (take<bool>() != (std::endian::native == std::endian::little))
            refuse();
        const auto kind = take<Kind>();
        const auto count = take<std::uint32_t>();
        if (kind == Kind::Lines || (kind == Kind::Collection && count == 0)) { // LineString()
            for (std::uint32_t i = 0; i < count; ++i)
                read(points, ends);
            return;
        }
        if (kind != Kind::Line || bytes_.size() / sizeof(glm::dvec2) < count)
            refuse();
        for (std::uint32_t i = 0; i < count; ++i)
            points.push_back(take<glm::dvec2>());
        ends.push_back(static_cast<std::uint32_t>(points.size()));
    }

private:
    template <class T>
    T take()
    {
        if (bytes_.size() < sizeof(T))
            refuse();
        T value;
        std::memcpy(static_cast<void*>(&value), bytes_.data(), sizeof value);
        bytes_.remove_prefix(sizeof value);
        return value;
    }
    [[noreturn]] static void refuse() { throw py::value_error("not the WKB of lines"); }

    std::string_view bytes_;
};

class Writer {
public:
    std::string bytes;

    void begin(Kind kind)
    {
        addNumber(std::endian::native == std::endian::little);
        addNumber(kind);
    }
    void addPart(std::span<const glm::dvec2> part)
    {
        begin(part.size() == 1 ? Kind::Point : Kind::Line);
        if (part.size() != 1)
            addNumber(static_cast<std::uint32_t>(part.size()));
        bytes.append(reinterpret_cast<const char*>(part.data()), part.size_bytes());
    }
    template <class T>
    void addNumber(T value)
    {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
};

/// The visible part of a line or of lines: a line, which can be empty, a point, or several of
/// these. `closed`: it is a ring, which repeats its first point.
std::string clipped(std::string_view wkb, const Window& window, bool closed)
{
    std::vector<glm::dvec2> points;
    std::vector<std::uint32_t> ends;
    Reader(wkb).read(points, ends);
    const Released released(points.size());
    Writer parts;
    PolylineRuns runs;
    std::uint32_t begin = 0, count = 0;
    bool areLines = true;
    for (const std::uint32_t end : ends) {
        const std::size_t size = end - begin;
        findRuns(std::span(std::as_const(points)).subspan(begin, size - (closed && size > 0)),
                 closed, window, runs);
        for (const VisibleRun& run : runs.runs) {
            parts.addPart(std::span(runs.points).subspan(run.first, run.count));
            areLines &= run.count > 1;
            ++count;
        }
        begin = end;
    }
    Writer whole;
    if (count > 1) {
        whole.begin(areLines ? Kind::Lines : Kind::Collection);
        whole.addNumber(count);
    } else if (count == 0) {
        whole.addPart({});
    }
    return whole.bytes + parts.bytes;
}

py::bytes clipWkb(const py::bytes& wkb, py::handle window, bool closed)
{
    return clipped(std::string_view(wkb), windowOf(window), closed);
}

} // namespace

void defineWkb(py::module_& module)
{
    module.def("clip_wkb", clipWkb, Guarded(), "wkb"_a, "window"_a, "closed"_a);
}

} // namespace clipping::python
