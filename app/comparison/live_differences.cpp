// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/live_differences.h"
#include "app/document/compared_window.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

using clipping::Clipped;
using clipping::Segment;
using clipping::Window;

namespace {

constexpr std::size_t sliceLines = 20'000; // some milliseconds
constexpr int idleMilliseconds = 150;      // many lines wait until a series of changes is over

/// The pieces of the lines that differ; both ascend by line, which are counted from `first`.
void appendPieces(std::vector<Clipped>& to, std::span<const Difference> list,
                  std::span<const Clipped> pieces, std::uint32_t first)
{
    auto next = pieces.begin();
    for (const Difference& difference : list) {
        while (next != pieces.end() && next->source < difference.source)
            ++next;
        if (next != pieces.end() && next->source == difference.source)
            to.push_back({next->segment, next->source + first, next->cut});
    }
}

bool isFinite(const Segment& s)
{
    return std::isfinite(s.a.x) && std::isfinite(s.a.y) && std::isfinite(s.b.x)
           && std::isfinite(s.b.y);
}

} // namespace

Differences extended(Differences so, const Comparison& comparison, std::span<const Segment> lines,
                     std::size_t count)
{
    const auto first = std::uint32_t(so.lines);
    const auto part = lines.subspan(so.lines, std::min(count, lines.size() - so.lines));
    const auto a = clipped(comparison.a, part, so.window);
    const auto b = clipped(comparison.b, part, so.window);
    auto found = differences(part, so.window, a, b,
                             {comparison.allowed(), endsOf(comparison.a, comparison.b)});
    appendPieces(so.pieces, found, a, first);
    appendPieces(so.pieces, found, b, first);
    for (Difference& difference : found) {
        difference.source += first;
        so.list.push_back(difference);
    }
    so.lines += part.size();
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

LiveDifferences::LiveDifferences(const EditedDocument& document, const Scene& scene, QObject* parent)
    : QObject(parent), scene_(scene), window_(comparedWindow(document.now().windows(), document.now().page()).window)
{
    connect(&document, &EditedDocument::changed, this, &LiveDifferences::outdate);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &LiveDifferences::begin);
    connect(&work_, &QTimer::timeout, this, &LiveDifferences::work);
}

void LiveDifferences::ask(const std::optional<Comparison>& comparison)
{
    if (comparison == asked_)
        return;
    asked_ = comparison;
    ofTheseLines_ = false;
    found_ = {};
    restart();
    emit changed();
}

void LiveDifferences::setWindow(const Window& window)
{
    if (window == window_)
        return;
    window_ = window;
    if (asked_ && ofTheseLines_ && found_.window == window)
        return keep(std::move(found_)); // a gesture was dropped
    const bool was = upToDate_;
    restart();
    if (asked_ && was && scene_.segments().size() > mostAtOnce)
        emit changed(); // what was found is of another window for a while
}

void LiveDifferences::outdate(const DocumentChange& change)
{
    if (!asked_ || !change.drawing())
        return;
    ofTheseLines_ = false;
    restart();
    if (!change.everything)
        return;
    found_ = {};
    emit changed();
}

void LiveDifferences::restart()
{
    growing_.reset();
    work_.stop();
    soon_.stop();
    upToDate_ = !asked_;
    if (!asked_)
        return;
    if (scene_.segments().size() > mostAtOnce)
        return soon_.start(idleMilliseconds);
    // Posted, not by a timer: requests to paint are posted, too, with less priority.
    if (!std::exchange(posted_, true))
        QMetaObject::invokeMethod(this, &LiveDifferences::findAtOnce, Qt::QueuedConnection);
}

void LiveDifferences::findAtOnce()
{
    posted_ = false;
    if (!upToDate_ && scene_.segments().size() <= mostAtOnce)
        keep(extended({window_}, *asked_, scene_.segments(), mostAtOnce));
}

void LiveDifferences::begin()
{
    soon_.stop();
    growing_ = Differences{window_};
    work_.start(0);
    if (scene_.segments().size() > mostAtOnce)
        emit begun();
    work();
}

void LiveDifferences::work()
{
    growing_ = extended(std::move(*growing_), *asked_, scene_.segments(), sliceLines);
    if (growing_->lines == scene_.segments().size())
        keep(*std::exchange(growing_, std::nullopt));
}

void LiveDifferences::keep(Differences found)
{
    growing_.reset();
    soon_.stop();
    work_.stop();
    found_ = std::move(found);
    upToDate_ = ofTheseLines_ = true;
    emit changed();
}

void LiveDifferences::finish()
{
    if (upToDate_)
        return;
    if (!growing_)
        begin();
    while (!upToDate_)
        work();
}

const Differences* LiveDifferences::at(const Window& window) const
{
    return asked_ && upToDate_ && found_.window == window ? &found_ : nullptr;
}

std::span<const Clipped> LiveDifferences::piecesAt(const Window& window) const
{
    const Differences* now = at(window);
    return now ? std::span<const Clipped>(now->pieces) : std::span<const Clipped>();
}

} // namespace app
