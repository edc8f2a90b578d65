// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"
#include "app/document/style_table.h"
#include "clipping/geometry.h"

#include <QPainterPath>

#include <glm/geometric.hpp>

#include <span>
#include <vector>

namespace app {

/// All lines of an object, in order: one run, or several if the object spans blocks of the scene.
using Outline = std::vector<std::span<const clipping::Segment>>;

/// The length of an outline before each of its lines, counted from the last point where the pen was
/// lifted.
class LengthsBefore {
public:
    LengthsBefore() = default;
    explicit LengthsBefore(const Outline& outline) : left_(outline) {} ///< must outlive this object

    /// `line` is the number of a line in the outline. It must not decrease from call to call.
    double of(std::size_t line)
    {
        for (; at_ < line; ++at_)
            step();
        return length_;
    }

private:
    const clipping::Segment& next()
    {
        while (used_ == left_.front().size()) {
            left_ = left_.subspan(1);
            used_ = 0;
        }
        return left_.front()[used_];
    }
    void step()
    {
        const clipping::Segment& line = next();
        ++used_;
        const bool joined = next().a == line.b;
        length_ = joined ? length_ + glm::distance(line.a, line.b) : 0;
    }

    std::span<const std::span<const clipping::Segment>> left_;
    std::size_t used_ = 0; // lines used of the first run
    std::size_t at_ = 0;
    double length_ = 0;
};

/// An object's outline in user units, with curves kept as curves, and its fill rule.
QPainterPath painterPath(const Path& path, FillRule rule);
QPainterPath painterPath(std::span<const Subpath> subpaths, FillRule rule);

} // namespace app
