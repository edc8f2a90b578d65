// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/scene/scene_lines.h"
#include "app/view/draw_list_builder.h"
#include "app/view/picture.h"
#include "clipping/algorithm.h"
#include "clipping/outside.h"

#include <algorithm>

/// The draw lists of a drawing that is clipped to one window, made the long way: all lines in one
/// row, all pieces of them in another, object by object.
class PlainDrawLists {
public:
    PlainDrawLists(const app::Document& document, const app::SceneLines& lines)
        : document_(document), lines_(lines)
    {
        for (const auto& run : lines.runs())
            all_.insert(all_.end(), run.segments.begin(), run.segments.end());
        for (std::size_t i = 0; i <= document.objects().size(); ++i)
            first_.push_back(lines.firstLineOf(i));
    }

    void clip(const clipping::Functions<clipping::Segment, clipping::Window>& uses,
              const clipping::Window& window)
    {
        inside_.resize(all_.size());
        inside_.resize(uses.clipAll(all_, window, inside_));
        outside_.resize(all_.size() + inside_.size());
        outside_.resize(clipping::outsideAll(all_, inside_, outside_));
    }
    /// Whether the form gives a piece that runs against its line.
    bool hasTurned() const
    {
        return std::ranges::any_of(inside_, [&](const clipping::Clipped& piece) {
            const clipping::Segment& line = all_[piece.source];
            return glm::dot(piece.segment.b - piece.segment.a, line.b - line.a) < 0;
        });
    }
    app::DrawList all(const app::PictureOptions& options) const
    {
        return drawList(app::untouched(all_), options);
    }
    app::DrawList inside(const app::PictureOptions& options) const
    {
        return drawList(inside_, options);
    }
    app::DrawList outside(const app::PictureOptions& options) const
    {
        return drawList(outside_, options);
    }
    app::DrawList selected(app::PictureOptions options) const
    {
        options.page.reset();
        if (!app::outlines(lines_, options.selection))
            return {};
        app::DrawListBuilder builder(options, 0);
        app::ObjectRanges selected;
        for (const app::ObjectRange& range : options.selection)
            selected.insert(range);
        const std::pair<app::Colour, double> bands[]{{options.light, 6}, {options.paper, 4}};
        for (const auto& [colour, wider] : bands)
            for (const std::size_t object : selected) {
                const app::Style& own = document_.objects()[object].style();
                const app::Style style{.stroke = colour,
                                       .width = (own.stroke ? own.width : 0)
                                                + wider / options.view.zoom / options.strokes,
                                       .join = app::Join::Round};
                const auto whole = linesOf(object);
                if (!whole.empty())
                    builder.add(style, whole, 0, app::untouched(whole));
            }
        return builder.take();
    }

private:
    std::span<const clipping::Segment> linesOf(std::size_t object) const
    {
        return std::span(all_).subspan(first_[object], first_[object + 1] - first_[object]);
    }
    app::DrawList drawList(std::span<const clipping::Clipped> pieces,
                           const app::PictureOptions& options) const
    {
        app::DrawListBuilder builder(options, 0);
        for (std::size_t object = 0; object + 1 < first_.size(); ++object) {
            std::size_t count = 0;
            while (count < pieces.size() && pieces[count].source < first_[object + 1])
                ++count;
            if (count > 0)
                builder.add(document_.objects()[object].style(), linesOf(object), first_[object],
                            pieces.first(count));
            pieces = pieces.subspan(count);
        }
        return builder.take();
    }

    const app::Document& document_;
    const app::SceneLines& lines_;
    std::vector<clipping::Segment> all_;
    std::vector<std::size_t> first_; // line of each object, and the end
    std::vector<clipping::Clipped> inside_, outside_;
};
