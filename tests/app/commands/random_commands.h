// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/catalogue.h"
#include "app/commands/crop_to_window.h"
#include "app/commands/move_objects.h"
#include "app/commands/remove_objects.h"
#include "app/commands/resize_objects.h"
#include "app/commands/set_containers.h"
#include "app/commands/set_style.h"
#include "app/commands/set_window.h"
#include "app/commands/set_windows.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "tests/app/document/sheet_edits.h"

// Commands at random, drawn from the catalogue by their keys. What a new command needs here is a
// maker; tests fail without one (neverDrawn).

inline app::Shape line(app::Point a, app::Point b, std::uint32_t layer)
{
    app::Shape shape;
    shape.paths.push_back({a, {{b}}, false});
    shape.style.stroke = app::Colour{};
    shape.layer = layer;
    return shape;
}

class RandomCommands {
public:
    explicit RandomCommands(app::EditedDocument& document, std::uint64_t seed = 7)
        : document_(document), random_(seed)
    {
    }

    /// One that can be done now; whoever pushes it owns it.
    app::UndoCommand* next()
    {
        const auto kinds = app::commandKinds();
        for (;;) {
            const auto& key = kinds[random_() % kinds.size()].key;
            const auto maker = std::ranges::find(makers, key, &Maker::key);
            if (app::UndoCommand* made = maker == makers.end() ? nullptr : maker->make(*this)) {
                ++drawn_[made->kind().key];
                return made;
            }
        }
    }
    /// The first command of the catalogue that next() has not given yet; empty: it has given all.
    std::string_view neverDrawn() const
    {
        for (const app::CommandKind& kind : app::commandKinds())
            if (!drawn_.contains(kind.key))
                return kind.key;
        return {};
    }

private:
    struct Maker {
        std::string_view key;
        app::UndoCommand* (*make)(RandomCommands&); ///< null: not now
    };
    static const std::array<Maker, 10> makers;

    double number() { return double(random_() % 1000) / 16; }
    std::uint32_t layer() { return std::uint32_t(random_() % sheetOf(document_).layers.size()); }
    app::ContainerId layerId() { return document_.now().containers().childrenOf(0)[layer()]; }
    app::ObjectRanges some()
    {
        app::ObjectRanges chosen;
        for (std::size_t i = 0; i < sheetOf(document_).shapes.size(); ++i)
            if (random_() % 3 == 0)
                chosen.insert(i);
        return chosen;
    }
    app::UndoCommand* crop()
    {
        if (random_() % 4 != 0) // there would soon be nothing left
            return nullptr;
        app::CutOptions options;
        options.clipAll = clipping::algorithms().front().corrected.clipAll;
        options.region = app::regionOf(document_.now().windows());
        options.reach = app::Reach::Editable;
        return new app::CropToWindow(document_, options);
    }
    app::UndoCommand* addLayer()
    {
        const app::Containers& containers = document_.now().containers();
        app::Container first = containers[containers.childrenOf(0).front()];
        first.locked = !first.locked;
        const std::size_t top = containers.objects();
        return new app::SetContainers(
            document_,
            *containers.with(first).inserted({.name = "new"}, 0, containers.childrenOf(0).size(),
                                             {top, top}),
            "Layers");
    }
    app::UndoCommand* addTwo()
    {
        const std::uint32_t to = layer();
        return addShapes(
            document_, {line({1, 1}, {number(), 2}, to), line({3, number()}, {4, 4}, to)}, "Add");
    }

    app::EditedDocument& document_;
    std::mt19937_64 random_;
    std::map<std::string_view, int> drawn_;
};

inline const std::array<RandomCommands::Maker, 10> RandomCommands::makers{{
    {"add-objects", [](RandomCommands& r) { return r.addTwo(); }},
    {"remove-objects",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::RemoveObjects(r.document_, r.some());
     }},
    {"move-objects",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::MoveObjects(r.document_, r.some(), {r.number(), r.number()});
     }},
    {"resize-objects",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::ResizeObjects(r.document_, r.some(), {{0, 0}, {1, 0}},
                                      {{r.number(), 1}, {9, r.number()}});
     }},
    {"set-style",
     [](RandomCommands& r) -> app::UndoCommand* {
         const double width = r.number();
         return new app::SetStyle(
             r.document_, r.some(), [&](app::Style& style) { style.width = width; }, "Width");
     }},
    {"set-window",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::SetWindow(r.document_, {{0, 0}, {r.number(), 5}});
     }},
    {"set-windows",
     [](RandomCommands& r) -> app::UndoCommand* {
         app::ClipWindows windows = r.document_.now().windows();
         if (r.random_() % 4 == 0)
             windows.list.clear();
         windows.list.push_back({.name = "new",
                                 .shape = app::RectangleShape{{{0, 0}, {r.number(), r.number()}}},
                                 .operation = app::WindowOperation(r.random_() % 3),
                                 .visible = r.random_() % 2 == 0});
         windows.keep = app::Keep(r.random_() % 2);
         return new app::SetWindows(r.document_, windows, "Windows");
     }},
    {"set-containers", [](RandomCommands& r) { return r.addLayer(); }},
    {"remove-layer",
     [](RandomCommands& r) -> app::UndoCommand* {
         return sheetOf(r.document_).layers.size() > 1 ? new app::RemoveLayer(r.document_, r.layerId())
                                                     : nullptr;
     }},
    {"crop-to-window", [](RandomCommands& r) { return r.crop(); }},
}};
