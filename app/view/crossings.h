// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"
#include "app/document/subpath.h"

namespace app {

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
