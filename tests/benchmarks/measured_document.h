// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/add_and_remove.h"
#include "app/commands/history.h"
#include "app/commands/move_objects.h"
#include "app/commands/resize_objects.h"
#include "app/commands/set_style.h"
#include "app/document/document_builder.h"
#include "app/scene/bounds.h"
#include "app/view/picking.h"
#include "app/view/picture.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "tests/app/scene/block_scene.h"

/// What document.cpp draws: lines that touch nothing, or pen lines of 100 segments.
enum class Drawn : std::uint8_t { Loose, Polylines };

/// A document being edited, with its scene and its history. All that the benchmark needs to know of
/// the document's interface is in here.
class MeasuredDocument {
public:
    using Selection = app::ObjectRanges;

    /// Objects are appended one by one, as readers of files do.
    MeasuredDocument(Drawn drawn, std::size_t segments) : document_(documentOf(drawn, segments)) {}

    void makeScene() { scene_ = std::make_unique<app::Scene>(document_); }
    void makePicking() { picking_ = std::make_unique<app::Picking>(document_, *scene_); }
    std::size_t segments() const { return scene_->lines().size(); }
    std::size_t objects() const { return document_.now().objects().size(); }

    app::SceneFrame clip()
    {
        return clipping_.clip(scene_->lines(),
                              regionOf(document_.now().windows(), document_.now().page()),
                              {&clipping::exactAlgorithm()});
    }
    app::Picture picture(const app::SceneFrame& frame) const
    {
        app::PictureOptions options;
        options.view.size = {1280, 800};
        const app::Document& now = document_.now();
        options.view.fit(now.page().rectangle());
        return app::picture(now.styles(), scene_->lines(), frame, options);
    }
    void hover(const app::Point& at) const { picking_->nearest(at, 5); }

    Selection neighbours(std::size_t first, std::size_t count) const
    {
        return Selection(app::ObjectRange{first, std::min(first + count, objects())});
    }
    Selection scattered(std::size_t count, unsigned seed) const
    {
        std::mt19937_64 random(seed);
        Selection selection;
        while (selection.size() < std::min(count, objects()))
            selection.insert(random() % objects());
        return selection;
    }
    Selection everything() const { return neighbours(0, objects()); }
    void findBox(const Selection& selection) const { app::boundsOf(scene_->lines(), selection); }

    // Each is one step to undo, and leaves the scene up to date.
    void move(const Selection& selection)
    {
        push(new app::MoveObjects(document_, selection, {1.5, -0.5}));
    }
    void resize(const Selection& selection)
    {
        const clipping::Window to{{0, 0}, {0.999, 0.998}};
        push(new app::ResizeObjects(document_, selection, {{{0, 0}, {1, 1}}}, {to}));
    }
    void restyle(const Selection& selection, double width)
    {
        const auto widen = [width](app::Style& style) { style.width = width; };
        push(new app::SetStyle(document_, selection, widen, QStringLiteral("Width")));
    }
    void remove(const Selection& selection) { push(new app::RemoveObjects(document_, selection)); }
    void undo() { history_.undo(); }
    void redo() { history_.redo(); }
    void forgetHistory() { history_.clear(); }

    /// What autosave and export work on while editing goes on.
    auto snapshot() const { return std::make_unique<app::Document>(document_.snapshot()); }

private:
    static app::Document documentOf(Drawn drawn, std::size_t segments)
    {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> x(0, 1280), y(0, 800), length(3, 17);
        std::uniform_real_distribution<double> angle(0, 2 * M_PI);
        const app::Page page{{0, 0}, {1280, 800}, {1280, app::Unit::Px}, {800, app::Unit::Px}};
        const app::Style style{.stroke = app::Colour{}};
        const std::size_t each = drawn == Drawn::Loose ? 1 : 100;
        app::DocumentBuilder builder;
        builder.open({.name = "Lines"});
        for (std::size_t done = 0; done < segments; done += each) {
            app::Subpath path{{x(random), y(random)}, {}, false};
            app::Point at = path.start;
            for (std::size_t i = 0; i < each; ++i) {
                const double l = length(random), t = angle(random);
                path.segments.push_back({at += l * app::Point(std::cos(t), std::sin(t))});
            }
            builder.add({app::Path(std::span(&path, 1)), style});
        }
        builder.close();
        return builder.take(page, {}, {{{.shape = app::RectangleShape{{{320, 200}, {960, 600}}}}}});
    }
    void push(app::UndoCommand* step) { history_.push(step); }

    app::EditedDocument document_;
    std::unique_ptr<app::Scene> scene_;
    FrameClipping clipping_;
    std::unique_ptr<app::Picking> picking_;
    app::History history_;
};
