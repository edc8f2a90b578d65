// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/add_and_remove.h"
#include "app/commands/catalogue.h"
#include "app/commands/change_paths.h"
#include "app/commands/crop_to_window.h"
#include "app/commands/move_objects.h"
#include "app/commands/name_object.h"
#include "app/commands/outline_strokes.h"
#include "app/commands/rearrange_objects.h"
#include "app/commands/resize_objects.h"
#include "app/commands/set_containers.h"
#include "app/commands/set_hidden.h"
#include "app/commands/set_page_parts.h"
#include "app/commands/set_style.h"
#include "app/commands/transform_objects.h"
#include "app/cut/stroke_area.h"
#include "app/document/regrouping.h"
#include "app/document/stacking.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <vector>

#include "tests/app/document/random_documents.h"

/// Commands at random, drawn from the catalogue by their keys. What a new command needs here is a
/// maker; tests fail without one (neverDrawn).
class RandomCommands {
public:
    explicit RandomCommands(app::EditedDocument& document, unsigned seed = 7)
        : document_(document), random_(seed)
    {
    }

    /// One that can be done now; whoever pushes it owns it.
    app::UndoCommand* next()
    {
        const auto kinds = app::commandKinds();
        for (;;) {
            const auto& key = kinds[random_.below(kinds.size())].key;
            const auto maker = std::ranges::find(makers, key, &Maker::key);
            if (maker == makers.end())
                continue;
            if (std::unique_ptr<app::UndoCommand> made(maker->make(*this)); made) {
                ++drawn_[made->kind().key]; // may run out of memory
                return made.release();
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
    static const std::vector<Maker> makers;

    const app::Document& now() const { return document_.now(); }
    app::ContainerId container()
    {
        const auto all = now().containers().inOrder();
        return all[random_.below(all.size())];
    }
    app::ObjectRanges some()
    {
        app::ObjectRanges chosen;
        const std::size_t count = now().objects().size();
        for (auto n = count == 0 ? 0 : 1 + random_.below(3); n > 0; --n) {
            const std::size_t first = random_.below(count);
            const std::size_t end = std::min(count, first + 1 + random_.below(12));
            chosen.insert(app::ObjectRange{first, end});
        }
        return chosen;
    }
    clipping::Window rectangle()
    {
        const app::Point p = random_.point(), q = random_.point();
        return {glm::min(p, q), glm::max(p, q)};
    }

    app::UndoCommand* add()
    {
        app::Objects objects = now().objects().slice(0, 0);
        for (auto n = 1 + random_.below(60); n > 0; --n)
            objects.append(random_.object());
        return new app::AddObjects(document_, objects, container(), "Add");
    }
    // It grows and shrinks alike, so that numbers stay within reason.
    app::UndoCommand* resize()
    {
        const auto factor = [&] { return std::array{0.5, 1.0, 2.0}[random_.below(3)]; };
        const app::Point corner = random_.point();
        const app::Point size{factor(), factor()};
        const double angle = random_.below(2) ? 0.5 : 0;
        return new app::ResizeObjects(document_, some(), {{{0, 0}, {1, 1}}, angle},
                                      {{corner, corner + size}, angle},
                                      app::StrokeScaling(random_.below(2)));
    }
    app::AffineMap map()
    {
        const auto factor = [&] { return std::array{-1.0, 0.5, 2.0}[random_.below(3)]; };
        const app::Point about = random_.point();
        const std::array maps{
            app::rotation(15.0 * double(random_.below(24)), about),
            app::scaling({factor(), factor()}, about),
            app::horizontalSkew(10, about),
        };
        return maps[random_.below(maps.size())];
    }
    app::UndoCommand* transform()
    {
        return new app::TransformObjects(document_, some(), map(),
                                         app::StrokeScaling(random_.below(2)), "Transform");
    }
    app::UndoCommand* copy()
    {
        const std::vector maps{map(), map()};
        const app::ObjectRanges chosen = some();
        if (chosen.empty() || now().objects().size() > 3000)
            return nullptr;
        return new app::CopyObjects(document_, app::copying(now(), chosen, maps), "Copy");
    }
    // Some objects take the path of another one, some as a text; a few lose it and are removed.
    app::UndoCommand* changePaths()
    {
        std::vector<app::ChangedPath> paths;
        for (const std::size_t object : some())
            paths.push_back({object, random_.below(20) == 0 ? app::Path() : random_.object().path,
                             random_.below(3) == 0 ? text() : app::Recipe{}});
        return new app::ChangePaths(document_, paths, "Nodes");
    }
    // Of a font that is not installed: replaying needs none.
    app::Recipe text()
    {
        return app::TextRecipe{random_.text(),
                               "No such font",
                               3,
                               {1, 2},
                               0.5,
                               random_.below(2) == 0,
                               {random_.below(2) == 0, true}};
    }
    app::UndoCommand* restyle()
    {
        const app::Style style = random_.style();
        return new app::SetStyle(
            document_, some(), [&](app::Style& each) { each = style; }, "Style");
    }
    app::UndoCommand* setWindows()
    {
        app::ClipWindows windows = now().windows();
        if (random_.below(4) == 0)
            windows.list.clear();
        windows.list.push_back({.name = random_.text(),
                                .shape = app::RectangleShape{rectangle()},
                                .operation = app::WindowOperation(random_.below(4)),
                                .visible = random_.below(2) == 0});
        windows.keep = app::Keep(random_.below(2));
        return new app::SetWindows(document_, windows, "Windows");
    }
    // The scale goes to and fro, so that it stays within its limits.
    app::UndoCommand* changePage()
    {
        app::Page page = now().page();
        const double factor = page.scale.ratio > 8 ? 0.5 : std::array{1.0, 2.0}[random_.below(2)];
        page.size *= factor;
        page.scale.ratio *= factor;
        page.margins = random_.margins();
        return new app::ChangePage(document_, page, std::nullopt);
    }
    app::UndoCommand* setContainers()
    {
        const app::Containers& tree = now().containers();
        if (random_.below(4) > 0)
            return new app::SetContainers(document_, random_.changed(tree), "Container");
        const std::size_t top = tree.objects();
        return new app::SetContainers(
            document_, *tree.inserted({.name = "new"}, 0, tree.childrenOf(0).size(), {top, top}),
            "Add layer");
    }
    app::UndoCommand* rearrange()
    {
        const app::Document& drawing = now();
        const app::ObjectRanges chosen = some();
        const auto overlaps = [](const app::ObjectRange& range) { return range.first % 3 == 0; };
        std::optional<app::Rearranged> result;
        switch (const auto kind = random_.below(9); kind) {
        case 0:
            result = app::grouped(drawing, chosen, 0);
            break;
        case 1:
            result = app::ungrouped(drawing, chosen, container());
            break;
        case 2:
            result = app::movedTo(drawing, chosen, 0, drawing.containers().childrenOf(0).front());
            break;
        case 3:
            result = app::movedContainer(drawing, container(), {container(), container()});
            break;
        case 8:
            result = app::movedBetween(drawing, chosen, 0, container(),
                                       random_.below(drawing.objects().size() + 1));
            break;
        default:
            result = app::stacked(drawing, chosen, 0, app::Stacking(kind - 4), overlaps);
        }
        if (!result || !result->changes())
            return nullptr;
        return new app::RearrangeObjects(document_, std::move(result->edit), "Rearrange");
    }
    app::UndoCommand* removeLayer()
    {
        const app::Containers& tree = now().containers();
        const app::ContainerId id = container();
        const bool last = tree.parentOf(id) == 0 && tree.childrenOf(0).size() == 1;
        if (last || tree[id].kind != app::Container::Kind::Layer || random_.below(2) > 0)
            return nullptr;
        return new app::RemoveLayer(document_, id);
    }
    app::UndoCommand* outline()
    {
        const std::size_t count = now().objects().size();
        if (count == 0 || random_.below(4) > 0) // there would soon be no strokes
            return nullptr;
        const app::ObjectRanges one{random_.below(count)}; // and many corners, which take time
        const app::Edit edit = app::strokesAsAreas(now(), one).edit;
        return edit.splices.empty() ? nullptr : new app::OutlineStrokes(document_, edit, "Outline");
    }
    app::UndoCommand* crop()
    {
        if (random_.below(8) > 0) // there would soon be nothing left
            return nullptr;
        app::CutOptions options;
        options.clipAll = clipping::algorithms().front().corrected.clipAll;
        options.region = app::regionOf(now().windows(), now().page());
        options.leaveLocked = true;
        options.leaveHidden = random_.below(2) == 0;
        options.closeAreas = random_.below(2) == 0;
        return new app::CropToWindow(document_, options);
    }

    app::EditedDocument& document_;
    RandomDocuments random_;
    std::map<std::string_view, int> drawn_;
};

inline const std::vector<RandomCommands::Maker> RandomCommands::makers{
    {"add-objects", [](RandomCommands& r) { return r.add(); }},
    {"remove-objects",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::RemoveObjects(r.document_, r.some());
     }},
    {"move-objects",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::MoveObjects(r.document_, r.some(), r.random_.point());
     }},
    {"name-object",
     [](RandomCommands& r) -> app::UndoCommand* {
         const app::ObjectRanges some = r.some();
         return some.empty() ? nullptr
                             : new app::NameObject(r.document_, some.first(),
                                                   QString("name-%1").arg(r.random_.below(1000)));
     }},
    {"set-hidden",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::SetHidden(r.document_, r.some(), r.random_.below(2) == 0, "Hide");
     }},
    {"resize-objects", [](RandomCommands& r) { return r.resize(); }},
    {"transform-objects", [](RandomCommands& r) { return r.transform(); }},
    {"copy-objects", [](RandomCommands& r) { return r.copy(); }},
    {"change-paths", [](RandomCommands& r) { return r.changePaths(); }},
    {"outline-strokes", [](RandomCommands& r) { return r.outline(); }},
    {"rearrange-objects", [](RandomCommands& r) { return r.rearrange(); }},
    {"set-style", [](RandomCommands& r) { return r.restyle(); }},
    {"set-guides",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::SetGuides(r.document_, r.random_.guides(), "Guides");
     }},
    {"set-sheets",
     [](RandomCommands& r) -> app::UndoCommand* {
         return new app::SetSheets(r.document_, r.random_.sheets(), "Sheets");
     }},
    {"change-page", [](RandomCommands& r) { return r.changePage(); }},
    {"set-windows", [](RandomCommands& r) { return r.setWindows(); }},
    {"set-containers", [](RandomCommands& r) { return r.setContainers(); }},
    {"remove-layer", [](RandomCommands& r) { return r.removeLayer(); }},
    {"crop-to-window", [](RandomCommands& r) { return r.crop(); }},
};
