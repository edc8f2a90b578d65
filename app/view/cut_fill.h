// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"
#include "app/scene/area_windows.h"
#include "app/view/outline.h"
#include "app/view/painted_part.h"

#include <span>
#include <stop_token>
#include <vector>

namespace app {

/// The part of filled areas that a picture shows: inside the clip windows, or what these remove.
class CutFill {
public:
    /// Without a region, and for Painted::All, areas are shown whole. When a stop is requested,
    /// areas are missing.
    CutFill(const ClipRegion* region, Painted part, const std::stop_token& stop = {});

    bool cuts() const { return windows_ != nullptr; }
    /// What is shown of anything in a box, as far as the box tells.
    Remains remains(const clipping::Window& box) const;
    /// What is shown of an area, as rings: each line begins where the one before it ends.
    std::vector<clipping::Segment> clip(const Outline& outline, FillRule rule) const;

private:
    ClipRegion region_;
    std::shared_ptr<const clipping::PreparedRegion> windows_;
    std::stop_token stop_;
};

/// The bounding box of an outline, which must not be empty.
clipping::Window boxOf(const Outline& outline);

/// The part of a closed outline's area inside the window, as an outline that may run along the
/// window's edges (Sutherland and Hodgman 1974). It can be filled with either fill rule.
std::vector<Point> areaInside(std::span<const Point> outline, const clipping::Window& window);

} // namespace app
