// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/copy_place.h"

#include <functional>
#include <unordered_map>

namespace app {
namespace {

constexpr int mostSteps = 1000;

std::optional<Point> startOf(const ObjectView& object)
{
    if (const auto line = object.singleLine())
        return line->a;
    std::optional<Point> start;
    object.path().forEachPoint([&](const Point& p) { start = start ? start : p; });
    return start;
}

std::size_t keyOf(const Point& start)
{
    return std::hash<double>{}(start.x) * 31 + std::hash<double>{}(start.y);
}

/// An index of the drawing's objects by their start points.
class Starts {
public:
    explicit Starts(const Objects& objects) : objects_(objects)
    {
        numbers_.reserve(objects.size());
        objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
            if (const auto start = startOf(object))
                numbers_.emplace(keyOf(*start), std::uint32_t(i));
        });
    }

    bool hold(const ObjectView& object, const Point& offset) const
    {
        const auto start = startOf(object);
        if (!start)
            return false;
        const auto [first, last] = numbers_.equal_range(keyOf(*start + offset));
        if (first == last)
            return false;
        const Path moved = object.path().placed({{1, 1}, offset});
        return std::any_of(
            first, last, [&](const auto& entry) { return objects_[entry.second].path() == moved; });
    }

private:
    const Objects& objects_;
    std::unordered_multimap<std::size_t, std::uint32_t> numbers_;
};

bool anyHeld(const Starts& starts, const Objects& copies, const Point& offset)
{
    for (std::size_t i = 0; i < copies.size(); ++i)
        if (starts.hold(copies[i], offset))
            return true;
    return false;
}

} // namespace

Point copyOffset(const Document& document, const Objects& copies, const Point& step)
{
    const Starts starts(document.objects());
    for (int steps = 1; steps < mostSteps; ++steps)
        if (const Point offset = double(steps) * step; !anyHeld(starts, copies, offset))
            return offset;
    return double(mostSteps) * step;
}

} // namespace app
