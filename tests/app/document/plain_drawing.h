// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/flatten.h"
#include "clipping/algorithm.h"
#include "clipping/outside.h"

#include <algorithm>
#include <span>

#include "tests/app/document/sheet.h"

/// A drawing as plain as can be, edited in the same ways as a document: what the document and its
/// scene are compared with.
class PlainDrawing {
public:
    PlainDrawing() = default;
    explicit PlainDrawing(app::Sheet sheet) : sheet_(std::move(sheet)) {}

    const app::Sheet& sheet() const { return sheet_; }
    int edits() const { return edits_; } ///< so far

    void load(app::Sheet sheet) { sheet_ = std::move(sheet), ++edits_; }
    void splice(std::size_t first, std::size_t count, const std::vector<app::Shape>& shapes)
    {
        const auto at = sheet_.shapes.begin() + std::ptrdiff_t(first);
        sheet_.shapes.insert(sheet_.shapes.erase(at, at + std::ptrdiff_t(count)), shapes.begin(),
                             shapes.end());
        ++edits_;
    }
    void setWindow(const clipping::Window& window) { sheet_.window = window, ++edits_; }
    void setLayers(std::vector<app::Layer> layers) { sheet_.layers = std::move(layers), ++edits_; }
    void setPage(const app::Page& page) { sheet_.page = page, ++edits_; }
    /// Where a new shape of that layer goes.
    std::size_t endOfLayer(std::uint32_t layer) const
    {
        const auto end = std::ranges::upper_bound(sheet_.shapes, layer, {}, &app::Shape::layer);
        return std::size_t(end - sheet_.shapes.begin());
    }

private:
    app::Sheet sheet_;
    int edits_ = 0;
};

/// All lines of a plain drawing in one array, and what one call leaves of them.
class PlainScene {
public:
    explicit PlainScene(const PlainDrawing& drawing) : drawing_(drawing) {}

    std::span<const clipping::Segment> segments() const
    {
        follow();
        return segments_;
    }
    std::size_t firstSegmentOf(std::size_t shape) const
    {
        follow();
        return first_[shape];
    }
    std::size_t shapeOf(std::size_t segment) const
    {
        follow();
        return std::size_t(std::ranges::upper_bound(first_, segment) - first_.begin()) - 1;
    }

    struct Frame {
        std::vector<clipping::Clipped> inside, outside;
    };
    Frame clip(const clipping::Functions<clipping::Segment, clipping::Window>& algorithm,
               const clipping::Window& window) const
    {
        Frame frame;
        frame.inside.resize(segments().size());
        frame.inside.resize(algorithm.clipAll(segments(), window, frame.inside));
        frame.outside.resize(segments_.size() + frame.inside.size());
        frame.outside.resize(clipping::outsideAll(segments_, frame.inside, frame.outside));
        return frame;
    }

private:
    void follow() const
    {
        if (std::exchange(edits_, drawing_.edits()) == drawing_.edits())
            return;
        const app::Sheet& sheet = drawing_.sheet();
        segments_.clear();
        first_ = {0};
        for (const app::Shape& shape : sheet.shapes) {
            std::vector<app::Chord> chords;
            if (sheet.shown(shape))
                for (const app::Subpath& path : shape.paths)
                    flatten(path, app::usualTolerance(sheet.page), chords);
            for (const app::Chord& chord : chords)
                segments_.push_back(chord.segment);
            first_.push_back(segments_.size());
        }
    }

    const PlainDrawing& drawing_;
    mutable int edits_ = -1; ///< of the drawing that the lines are of
    mutable std::vector<clipping::Segment> segments_;
    mutable std::vector<std::size_t> first_;
};
