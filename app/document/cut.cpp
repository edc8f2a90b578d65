// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/cut.h"

#include "app/document/runs.h"
#include "clipping/outside.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace app {
namespace {

using clipping::Clipped;

/// All shapes as chords in one array, so that one call of the algorithm clips them all.
struct Chords {
    std::vector<Chord> all;
    std::vector<std::size_t> first; ///< of each path in drawing order, and the end

    std::span<const Chord> of(std::size_t path) const
    {
        return std::span(all).subspan(first[path], first[path + 1] - first[path]);
    }
};

bool reached(const Sheet& sheet, const Shape& shape, Reach reach)
{
    return reach == Reach::Everything || (sheet.shown(shape) && !sheet.layers[shape.layer].locked);
}

Chords chordsOf(const Sheet& sheet, double tolerance, Reach reach)
{
    Chords chords;
    for (const Shape& shape : sheet.shapes)
        for (const Subpath& path : shape.paths) {
            chords.first.push_back(chords.all.size());
            if (reached(sheet, shape, reach))
                flatten(path, tolerance, chords.all);
        }
    chords.first.push_back(chords.all.size());
    return chords;
}

bool notFinite(const Clipped& piece)
{
    const auto& [a, b] = piece.segment;
    return !std::isfinite(a.x + a.y + b.x + b.y); // what was read is far below overflow
}

std::vector<Clipped> keptPieces(const std::vector<Chord>& chords, const CutOptions& options)
{
    std::vector<clipping::Segment> segments(chords.size());
    std::ranges::transform(chords, segments.begin(), &Chord::segment);
    std::vector<Clipped> inside(segments.size());
    inside.resize(options.algorithm->clipAll(segments, options.window, inside));
    std::erase_if(inside, notFinite); // a published form may give anything
    if (options.keep == Keep::Inside)
        return inside;
    std::vector<Clipped> outside(segments.size() + inside.size());
    outside.resize(clipping::outsideAll(segments, inside, outside));
    return outside;
}

class Cutter {
public:
    Cutter(const Sheet& sheet, const CutOptions& options)
        : options_(options), sheet_(sheet),
          chords_(chordsOf(sheet,
                           options.tolerance > 0 ? options.tolerance : usualTolerance(sheet.page),
                           options.reach)),
          pieces_(keptPieces(chords_.all, options)), next_(pieces_.begin())
    {
        result_.sheet.page = sheet.page;
        result_.sheet.layers = sheet.layers;
        result_.sheet.window = sheet.window;
        result_.sheet.about = sheet.about;
    }

    Cut cut()
    {
        for (const Shape& shape : sheet_.shapes) {
            if (reached(sheet_, shape, options_.reach))
                cutShape(shape);
            else
                leaveAlone(shape);
            result_.sources.resize(result_.sheet.shapes.size(),
                                   std::size_t(&shape - sheet_.shapes.data()));
        }
        result_.counts.segmentsBefore = chords_.all.size();
        return std::move(result_);
    }

private:
    // The pieces of the next path, without contacts unless they are wanted.
    std::vector<KeptPart> partsOfNextPath()
    {
        const std::size_t first = chords_.first[path_], end = chords_.first[path_ + 1];
        std::vector<KeptPart> parts;
        for (; next_ != pieces_.end() && next_->source < end; ++next_) {
            const auto& [a, b] = next_->segment;
            const auto& chord = chords_.all[next_->source].segment;
            if (a == b && chord.a != chord.b && !options_.keepContacts)
                continue;
            parts.push_back({next_->source - first, next_->segment,
                             clipping::cutEdgeOfA(next_->cut), clipping::cutEdgeOfB(next_->cut)});
        }
        result_.counts.segmentsAfter += parts.size();
        return parts;
    }

    void leaveAlone(const Shape& shape)
    {
        path_ += shape.paths.size();
        ++(sheet_.layers[shape.layer].locked ? result_.counts.leftLocked
                                             : result_.counts.leftHidden);
        result_.sheet.shapes.push_back(shape);
    }

    void cutShape(const Shape& shape)
    {
        const bool hidden = !sheet_.shown(shape);
        const OverStart overStart = shape.style.dashes.empty() ? OverStart::Join : OverStart::Break;
        std::vector<Run> runs;
        bool whole = true;
        std::size_t opened = 0;
        for (const Subpath& path : shape.paths) {
            const auto parts = partsOfNextPath();
            const auto kept =
                joinRuns(path, chords_.of(path_++), parts, options_.window, overStart);
            const bool unchanged = kept.size() == 1 && kept.front().path == path;
            whole = whole && unchanged;
            opened += path.closed && !unchanged && !kept.empty();
            runs.insert(runs.end(), kept.begin(), kept.end());
        }
        CutCounts& counts = result_.counts;
        if (whole) {
            ++counts.whole;
            counts.hidden += hidden;
            result_.sheet.shapes.push_back(shape);
        } else if (runs.empty()) {
            ++counts.gone;
        } else {
            ++counts.cut;
            counts.hidden += hidden;
            counts.opened += opened;
            counts.unfilled += shape.style.fill && hasArea(shape);
            addCutShape(shape, runs);
        }
    }

    // A cut shape has no inside to fill any more, so a shape that was only filled is outlined.
    void addCutShape(const Shape& shape, std::vector<Run>& runs)
    {
        Shape outline{{}, shape.style, shape.id, shape.layer, shape.hidden};
        outline.style.stroke = lineInk(shape);
        outline.style.fill.reset();
        std::ranges::move(shapesOfRuns(outline, std::move(runs)),
                          std::back_inserter(result_.sheet.shapes));
    }

    const CutOptions& options_;
    const Sheet& sheet_;
    const Chords chords_;
    const std::vector<Clipped> pieces_;
    std::vector<Clipped>::const_iterator next_;
    std::size_t path_ = 0;
    Cut result_;
};

} // namespace

bool hasArea(const Shape& shape)
{
    return std::ranges::any_of(shape.paths, [](const Subpath& path) {
        return path.segments.size() > 1
               || (path.segments.size() == 1 && path.segments.front().curved);
    });
}

std::optional<Colour> lineInk(const Shape& shape)
{
    return shape.style.stroke || !hasArea(shape) ? shape.style.stroke : shape.style.fill;
}

Cut cut(const Sheet& sheet, const CutOptions& options)
{
    assert(options.algorithm);
    return Cutter(sheet, options).cut();
}

Sheet withoutHidden(Sheet sheet)
{
    std::erase_if(sheet.shapes, [&](const Shape& shape) { return !sheet.shown(shape); });
    std::vector<std::uint32_t> now(sheet.layers.size()); // where each layer that stays will be
    std::vector<Layer> layers;
    for (std::size_t i = 0; i < now.size(); ++i) {
        now[i] = std::uint32_t(layers.size());
        if (sheet.layers[i].visible)
            layers.push_back(std::move(sheet.layers[i]));
    }
    for (Shape& shape : sheet.shapes)
        shape.layer = now[shape.layer];
    sheet.layers = layers.empty() ? Sheet{}.layers : std::move(layers);
    return sheet;
}

} // namespace app
