// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/line_clipping.h"

#include "clipping/outside.h"

#include <cmath>

namespace app {

using clipping::Clipped;
using clipping::Segment;

static bool notFinite(const Clipped& piece)
{
    const auto& [a, b] = piece.segment;
    return !std::isfinite(a.x + a.y + b.x + b.y); // coordinates are far below overflow
}

// Whether only a point of a longer line is kept.
static bool isContact(const Clipped& piece, std::span<const Segment> lines)
{
    const auto& [a, b] = piece.segment;
    return a == b && lines[piece.source].a != lines[piece.source].b;
}

LineClipping::LineClipping(const CutOptions& options, const std::stop_token& stop)
    : options_(options)
{
    folding_.start(options.region, options.clipAll, stop);
}

std::span<const Clipped> LineClipping::keptOf(std::span<const Segment> lines)
{
    kept_.clear();
    if (options_.region.everything())
        keepAll(lines);
    else if (const auto window = options_.region.single())
        clipAt(*window, lines);
    else
        folding_.fold(lines, 0, kept_);
    findContacts(lines);
    if (!options_.keepContacts && !contacts_.empty())
        std::erase_if(kept_, [&](const Clipped& piece) { return isContact(piece, lines); });
    return kept_;
}

void LineClipping::findContacts(std::span<const Segment> lines)
{
    contacts_.clear();
    for (const Clipped& piece : kept_)
        if (isContact(piece, lines))
            contacts_.push_back(piece.source);
}

void LineClipping::keepAll(std::span<const Segment> lines)
{
    for (std::size_t i = 0; i < lines.size(); ++i)
        kept_.push_back({lines[i], std::uint32_t(i), {}});
}

void LineClipping::clipAt(const clipping::Window& window, std::span<const Segment> lines)
{
    kept_.resize(lines.size());
    kept_.resize(options_.clipAll(lines, window, kept_));
    std::erase_if(kept_, notFinite); // a published form may return anything
    if (options_.region.keep == Keep::Inside)
        return;
    outside_.resize(lines.size() + kept_.size());
    outside_.resize(clipping::outsideAll(lines, kept_, outside_));
    std::swap(kept_, outside_);
}

} // namespace app
