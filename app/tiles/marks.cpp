// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/marks.h"

#include "app/base/text.h"
#include "app/document/recipe_outline.h"
#include "app/lettering/lettering.h"
#include "app/lettering/stroke_fonts.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double markWidth = 0.25; // millimetres

class Marks {
public:
    Marks(const Tiling& tiling, const Tile& tile, double margin)
        : tiling_(tiling), tile_(tile), unit_(1 / tiling.millimetresPerUnit),
          margin_(margin * unit_), arm_(std::min(margin * 0.4, 3.0) * unit_)
    {
        style_.stroke = Colour{};
        style_.width = markWidth * unit_;
    }

    std::vector<Object> take() { return std::move(objects_); }

    void addRegistration()
    {
        for (const int axis : {0, 1})
            for (const double along : shared(axis))
                for (const double across : {tile_.window.min[1 - axis] - margin_ / 2,
                                            tile_.window.max[1 - axis] + margin_ / 2}) {
                    Point at;
                    at[axis] = along;
                    at[1 - axis] = across;
                    addCross(at);
                }
    }

    void addCorners(bool nearMarks)
    {
        const auto& [min, max] = tile_.window;
        for (const Point& corner : {min, Point(max.x, min.y), max, Point(min.x, max.y)})
            addCorner(corner, nearMarks);
    }

    void addLabel(const QString& title)
    {
        const double size = std::min(margin_ * 0.25, 2.5 * unit_);
        const QString text = Text::tr("%1 %2-%3 of %4 × %5")
                                 .arg(title)
                                 .arg(tile_.row)
                                 .arg(tile_.column)
                                 .arg(tiling_.rows)
                                 .arg(tiling_.columns)
                                 .trimmed();
        const Point& drawing = tiling_.drawing;
        const QString whole =
            Text::tr("%1 × %2 mm").arg(std::lround(drawing.x)).arg(std::lround(drawing.y));
        // Between the registration marks.
        const double inset = std::max(3 * arm_, tiling_.overlap / 2 + 2 * arm_);
        const double right = tile_.window.max.x - inset;
        Point at(tile_.window.min.x + inset, tile_.window.max.y + margin_ / 2 + size / 2);
        const std::vector<Subpath> name = lettering(text, at, size);
        add(name);
        const double end = rightOf(name, at.x);
        at.x = 0;
        at.x = right - rightOf(lettering(whole, at, size), 0);
        if (at.x > end + 2 * size) // there is room for both
            add(lettering(whole, at, size));
    }

private:
    struct Neighbours {
        bool before, after; ///< along an axis
    };
    Neighbours neighbours(int axis) const
    {
        return axis == 0 ? Neighbours{tile_.column > 1, tile_.column < tiling_.columns}
                         : Neighbours{tile_.row > 1, tile_.row < tiling_.rows};
    }

    // The middles of the strips shared with the neighbours along an axis.
    std::vector<double> shared(int axis) const
    {
        const auto& [min, max] = tile_.window;
        std::vector<double> places;
        if (neighbours(axis).before)
            places.push_back(min[axis] + tiling_.overlap / 2);
        if (neighbours(axis).after)
            places.push_back(max[axis] - tiling_.overlap / 2);
        return places;
    }

    void addCross(const Point& at)
    {
        const EllipseRecipe ring{at, Point(arm_ * 0.6)};
        add({*outlineOf(ring),
             {at - Point(arm_, 0), {{at + Point(arm_, 0)}}, false},
             {at - Point(0, arm_), {{at + Point(0, arm_)}}, false}});
    }

    // With registration marks, only where no neighbour follows: elsewhere a mark is near.
    void addCorner(const Point& corner, bool nearMarks)
    {
        for (const int axis : {0, 1}) {
            const bool low = corner[axis] == tile_.window.min[axis];
            const int other = 1 - axis;
            const bool lowOther = corner[other] == tile_.window.min[other];
            const Neighbours beside = neighbours(other);
            if (nearMarks && (lowOther ? beside.before : beside.after))
                continue;
            Point away(0);
            away[axis] = low ? -1 : 1;
            add({{corner + away * (margin_ / 2 - arm_),
                  {{corner + away * (margin_ / 2 + arm_)}},
                  false}});
        }
    }

    static std::vector<Subpath> lettering(const QString& text, const Point& at, double size)
    {
        return lettered({text, strokeFonts().front().name, size, at}).paths;
    }
    static double rightOf(const std::vector<Subpath>& letters, double least)
    {
        for (const Subpath& stroke : letters) {
            least = std::max(least, stroke.start.x);
            for (const PathSegment& segment : stroke.segments)
                least = std::max(least, segment.to.x);
        }
        return least;
    }

    void add(const std::vector<Subpath>& paths)
    {
        if (!paths.empty())
            objects_.push_back({.path = Path(paths), .style = style_});
    }

    const Tiling& tiling_;
    const Tile& tile_;
    double unit_, margin_, arm_; // in user units
    Style style_;
    std::vector<Object> objects_;
};

} // namespace

std::vector<Object> marksOf(const Tiling& tiling, const Tile& tile, const TilePlan& plan,
                            const QString& title)
{
    Marks marks(tiling, tile, plan.margin);
    if (plan.marks.registration)
        marks.addRegistration();
    if (plan.marks.cropLines)
        marks.addCorners(plan.marks.registration);
    if (plan.marks.labels)
        marks.addLabel(title);
    return marks.take();
}

} // namespace app
