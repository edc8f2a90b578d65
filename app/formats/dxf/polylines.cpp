// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/entities.h"
#include "app/formats/dxf/losses.h"

#include <algorithm>

namespace app::dxf {
namespace {

constexpr int isClosed = 1;

/// The corners of a polyline and the widths of its lines, in its own plane.
struct Corners {
    std::vector<Corner> list{};
    std::vector<double> widths{}; ///< at the ends of each line

    /// The width of all lines; 0 if they have different ones.
    double width() const
    {
        const bool same = !widths.empty()
                          && std::ranges::all_of(widths, [&](double w) { return w == widths[0]; });
        return same ? widths[0] : 0;
    }
    bool isUneven() const
    {
        return width() == 0 && std::ranges::any_of(widths, [](double w) { return w != 0; });
    }
};

void addPolyline(const Entity& entity, const Corners& corners, bool closed, const Space& space)
{
    if (corners.isUneven())
        entity.drawer.report().add(losses::unevenWidth);
    addCorners(entity, corners.list,
               {.closed = closed, .space = space, .width = corners.width() * space.scale()});
}

Corners cornersOf(const Record& record)
{
    Corners corners;
    const double elevation = record.number(38);
    const bool constant = record.has(43) && record.number(43) != 0;
    double begins = 0, ends = 0;
    const auto endCorner = [&] {
        if (!corners.list.empty() && !constant)
            corners.widths.insert(corners.widths.end(), {begins, ends});
        begins = ends = 0;
    };
    for (const auto& [code, value] : record.pairs) {
        if (code == 10) {
            endCorner();
            corners.list.push_back({{numberOf(value), 0, elevation}});
        }
        if (corners.list.empty())
            continue;
        if (code == 20)
            corners.list.back().at.y = numberOf(value);
        else if (code == 42)
            corners.list.back().bulge = numberOf(value);
        else if (code == 40)
            begins = numberOf(value);
        else if (code == 41)
            ends = numberOf(value);
    }
    endCorner();
    if (constant)
        corners.widths = {record.number(43)};
    return corners;
}

/// The flags of an old polyline, and those of a vertex.
namespace flags {
constexpr int mesh = 16 | 64, space = 8;
constexpr int control = 16; ///< of a curve that other vertices follow
} // namespace flags

Corners verticesOf(const Entity& entity)
{
    const Record& record = entity.record;
    const double begins = record.number(40), ends = record.number(41);
    const bool flat = (record.integer(70) & flags::space) == 0;
    const double elevation = record.number(30);
    Corners corners;
    Record vertex;
    while (entity.following.nextType() == "VERTEX") {
        entity.following.next(vertex);
        if ((vertex.integer(70) & flags::control) != 0)
            continue;
        Corner corner{vertex.point(10), vertex.number(42)};
        if (flat)
            corner.at.z = elevation;
        corners.list.push_back(corner);
        corners.widths.insert(corners.widths.end(),
                              {vertex.number(40, begins), vertex.number(41, ends)});
    }
    return corners;
}

} // namespace

void drawLwPolyline(const Entity& entity)
{
    tellHeight(entity, entity.record.number(38));
    addPolyline(entity, cornersOf(entity.record), (entity.record.integer(70) & isClosed) != 0,
                entity.plane());
}

void drawPolyline(const Entity& entity)
{
    const int kind = entity.record.integer(70);
    if ((kind & flags::mesh) != 0) {
        entity.drawer.report().add(losses::mesh);
        return; // its vertices draw nothing by themselves
    }
    const Corners corners = verticesOf(entity);
    const bool inSpace = (kind & flags::space) != 0;
    const auto high =
        std::ranges::find_if(corners.list, [](const Corner& c) { return c.at.z != 0; });
    tellHeight(entity, high == corners.list.end() ? 0 : high->at.z);
    addPolyline(entity, corners, (kind & isClosed) != 0,
                inSpace ? entity.place.space : entity.plane());
}

} // namespace app::dxf
