// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/arrange.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace app {
namespace {

double placeOf(const clipping::Window& box, int axis, AlignTo side)
{
    const double least = box.min[axis], most = box.max[axis];
    return side == AlignTo::Least  ? least
           : side == AlignTo::Most ? most
                                   : least + (most - least) / 2;
}

} // namespace

std::vector<Point> aligned(std::span<const clipping::Window> boxes, const clipping::Window& to,
                           int axis, AlignTo side)
{
    std::vector<Point> ways(boxes.size(), Point(0));
    for (std::size_t i = 0; i < boxes.size(); ++i)
        ways[i][axis] = placeOf(to, axis, side) - placeOf(boxes[i], axis, side);
    return ways;
}

std::vector<Point> spread(std::span<const clipping::Window> boxes, int axis,
                          const std::optional<clipping::Window>& over)
{
    std::vector<Point> ways(boxes.size(), Point(0));
    if (boxes.size() < (over ? 2 : 3))
        return ways;
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(
        order, {}, [&](std::size_t i) { return placeOf(boxes[i], axis, AlignTo::Middle); });
    const auto length = [&](std::size_t i) { return boxes[i].max[axis] - boxes[i].min[axis]; };
    double covered = 0;
    for (const std::size_t i : order)
        covered += length(i);
    const double first = over ? over->min[axis] : boxes[order.front()].min[axis];
    const double whole = (over ? over->max[axis] : boxes[order.back()].max[axis]) - first;
    const double gap = (whole - covered) / double(boxes.size() - 1);
    double before = 0; // the length of the boxes before
    for (std::size_t place = 0; place < order.size(); ++place) {
        const std::size_t i = order[place];
        if (over || (place > 0 && place + 1 < order.size()))
            ways[i][axis] = first + before + gap * double(place) - boxes[i].min[axis];
        before += length(i);
    }
    return ways;
}

std::vector<AffineMap> sameSize(std::span<const clipping::Window> boxes,
                                const clipping::Window& model, bool width, bool height)
{
    const Point wanted = model.max - model.min;
    std::vector<AffineMap> maps;
    for (const clipping::Window& box : boxes) {
        const Point size = box.max - box.min;
        const bool wide = width && size.x > 0 && wanted.x > 0;
        const bool high = height && size.y > 0 && wanted.y > 0;
        maps.push_back(
            scaling({wide ? wanted.x / size.x : 1, high ? wanted.y / size.y : 1}, box.min));
    }
    return maps;
}

std::vector<AffineMap> grid(int rows, int columns, const Point& step)
{
    std::vector<AffineMap> maps;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            if (row > 0 || column > 0)
                maps.push_back(translation(step * Point(column, row)));
    return maps;
}

std::vector<AffineMap> circle(int count, double degrees, const Point& about)
{
    const bool whole = std::abs(degrees) >= 360;
    const double step = degrees / std::max(1, whole ? count : count - 1);
    std::vector<AffineMap> maps;
    for (int i = 1; i < count; ++i)
        maps.push_back(rotation(step * i, about));
    return maps;
}

} // namespace app
