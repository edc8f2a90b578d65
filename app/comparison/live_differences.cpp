// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/live_differences.h"

#include "app/base/finite.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

using clipping::Clipped;
using clipping::Segment;
using clipping::Window;

namespace {

constexpr std::size_t sliceLines = 5'000; // a millisecond or two

/// Appends the pieces of the lines that differ, line by line, A's first: consecutive marks are
/// joined when they are painted, so the order must not depend on how the lines are split into
/// slices. All inputs ascend by line; lines are counted from `first`.
void appendPieces(std::vector<Clipped>& to, std::span<const Difference> list,
                  std::span<const Clipped> a, std::span<const Clipped> b, std::uint32_t first)
{
    for (const Difference& difference : list)
        for (std::span<const Clipped>* left : {&a, &b}) {
            while (!left->empty() && left->front().source < difference.source)
                *left = left->subspan(1);
            if (!left->empty() && left->front().source == difference.source)
                to.push_back({left->front().segment, difference.source + first, left->front().cut});
        }
}

} // namespace

Differences extended(Differences so, const Comparison& comparison, std::span<const Segment> more)
{
    const auto a = clipped(comparison.a, more, so.window);
    const auto b = clipped(comparison.b, more, so.window);
    return extended(std::move(so), more, a, b,
                    {comparison.allowed(), endsOf(comparison.a, comparison.b)});
}

Differences extended(Differences so, std::span<const Segment> more, std::span<const Clipped> a,
                     std::span<const Clipped> b, const Allowance& allowed)
{
    const auto first = std::uint32_t(so.lines);
    auto found = differences(more, so.window, a, b, allowed);
    appendPieces(so.pieces, found, a, b, first);
    for (Difference& difference : found) {
        difference.source += first;
        so.list.push_back(difference);
    }
    so.lines += more.size();
    return so;
}

Differences extended(Differences so, const Comparison& comparison, const SceneLines& lines,
                     std::size_t count)
{
    const std::size_t first = so.lines, end = first + std::min(count, lines.size() - first);
    lines.forEachPart(first, end, [&](std::size_t run, std::size_t from, std::size_t to) {
        const auto part = lines.runs()[run].segments.subspan(from, to - from);
        so = extended(std::move(so), comparison, part);
    });
    return so;
}

Window placeOf(const Comparison& comparison, const Segment& line, const Window& window)
{
    std::optional<Window> place;
    for (const Variant& variant : {comparison.a, comparison.b})
        if (const auto piece = clipped(variant, line, window); piece && isFinite(*piece)) {
            const glm::dvec2 min = glm::min(piece->a, piece->b), max = glm::max(piece->a, piece->b);
            place = place ? Window{glm::min(place->min, min), glm::max(place->max, max)}
                          : Window{min, max};
        }
    if (!place)
        place = Window{glm::min(line.a, line.b), glm::max(line.a, line.b)};
    return *place;
}

LiveDifferences::LiveDifferences(const EditedDocument& document, const Scene& scene,
                                 QObject* parent)
    : LiveFinding(document, scene, {mostAtOnce, sliceLines}, parent)
{
}

void LiveDifferences::ask(const std::optional<Comparison>& comparison)
{
    if (comparison == asked_)
        return;
    asked_ = comparison;
    askAnew(asked_.has_value());
}

class LiveDifferences::Growing final : public Finding {
public:
    Growing(const Comparison& comparison, const Window& window)
        : differences{window}, comparison_(comparison)
    {
    }
    void look(const SceneLines& lines, std::size_t count) override
    {
        differences = extended(std::move(differences), comparison_, lines, count);
    }

    Differences differences;

private:
    Comparison comparison_;
};

std::unique_ptr<LiveFinding::Finding> LiveDifferences::start(const Window& window)
{
    return std::make_unique<Growing>(*asked_, window);
}

void LiveDifferences::keep(Finding& whole)
{
    found_ =
        std::make_shared<const Differences>(std::move(static_cast<Growing&>(whole).differences));
}

void LiveDifferences::forget() { found_ = std::make_shared<const Differences>(); }

std::shared_ptr<const Differences> LiveDifferences::at(const Window& window) const
{
    return asked_ && upToDate() && found_->window == window ? found_ : nullptr;
}

std::span<const Clipped> LiveDifferences::piecesAt(const Window& window) const
{
    const auto now = at(window); // shared with this object
    return now ? std::span<const Clipped>(now->pieces) : std::span<const Clipped>();
}

} // namespace app

#include "moc_live_differences.cpp"
