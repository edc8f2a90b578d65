// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/document.h"
#include "app/document/style_table.h"
#include "app/document/subpath.h"
#include "app/scene/scene_lines.h"

#include <optional>

namespace app {

/// The topmost editable filled object whose area contains the point. `lines` are the document's
/// lines. Visits the boxes of all chunks, but only few lines.
std::optional<std::size_t> areaAt(const Document& document, const SceneLines& lines,
                                  const Point& point);

/// Whether the shape contains the point or its border is no farther than `reach` (user units).
bool isAt(const WindowShape& shape, const Point& point, double reach);

/// The number of the last visible clip window whose border is no farther than `reach`.
std::optional<std::size_t> windowBorderAt(const ClipWindows& windows, const Point& point,
                                          double reach);
/// The number of the last visible clip window there: it lies above those before it.
std::optional<std::size_t> windowAt(const ClipWindows& windows, const Point& point, double reach);

/// The winding number of an outline around a point, and the number of crossings of a ray from the
/// point with the outline. Open paths are filled as if closed.
class Crossings {
public:
    explicit Crossings(const Point& point) : p_(point) {}

    void add(const clipping::Segment& line)
    {
        if (open_ && line.a != last_)
            close();
        if (!open_)
            start_ = line.a;
        open_ = true;
        count(line);
        last_ = line.b;
    }
    void close()
    {
        if (open_ && last_ != start_)
            count({last_, start_});
        open_ = false;
    }
    /// Counts a line of an outline that is closed already; their order does not matter.
    void count(const clipping::Segment& s)
    {
        if ((s.a.y <= p_.y) == (s.b.y <= p_.y))
            return;
        const double x = s.a.x + (s.b.x - s.a.x) * ((p_.y - s.a.y) / (s.b.y - s.a.y));
        if (x <= p_.x)
            return;
        ++crossings_;
        winding_ += s.b.y > s.a.y ? 1 : -1;
    }
    bool inside(FillRule rule) const
    {
        return rule == FillRule::EvenOdd ? crossings_ % 2 == 1 : winding_ != 0;
    }

private:
    Point p_, start_{}, last_{};
    bool open_ = false;
    int winding_ = 0, crossings_ = 0;
};

} // namespace app
