// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"

#include <set>

/// Builds a document again as it comes back from a file: a line without length is a point, what has
/// no area has no fill, an id that is there twice stays with the first, and clip windows (which
/// must be rectangles) that are inverted are left out.
class Canonical {
public:
    explicit Canonical(const app::Document& document) : document_(document) {}

    app::Document document()
    {
        idOf(document_.about().id);
        for (const app::ContainerId layer : tree().childrenOf(0))
            add(layer);
        return builder_.take(document_.page(), document_.about(), windows());
    }

private:
    const app::Containers& tree() const { return document_.containers(); }

    app::ClipWindows windows() const
    {
        app::ClipWindows windows = document_.windows();
        std::erase_if(windows.list, [](const app::ClipWindow& window) {
            const auto* rectangle = std::get_if<app::RectangleShape>(&window.shape);
            return rectangle
                   && (rectangle->box.min.x > rectangle->box.max.x
                       || rectangle->box.min.y > rectangle->box.max.y);
        });
        return windows;
    }

    QString idOf(const QString& id) { return ids_.insert(id).second ? id : QString(); }

    void add(app::ContainerId id)
    {
        app::Container container = tree()[id];
        container.svgId = idOf(container.svgId);
        builder_.open(container);
        const app::ObjectRange all = tree().rangeOf(id);
        std::size_t next = all.first;
        for (const app::ContainerId inner : tree().childrenOf(id)) {
            addObjects(next, tree().rangeOf(inner).first);
            add(inner);
            next = tree().rangeOf(inner).end;
        }
        addObjects(next, all.end);
        builder_.close();
    }

    void addObjects(std::size_t first, std::size_t end)
    {
        for (std::size_t i = first; i < end; ++i) {
            app::Object object = document_.objects()[i].copy();
            std::vector<app::Subpath> subpaths = object.path.subpaths();
            for (app::Subpath& subpath : subpaths)
                if (!subpath.closed && subpath.segments.size() == 1
                    && subpath.segments[0] == app::PathSegment{subpath.start})
                    subpath.segments.clear();
            object.path = app::Path(subpaths);
            if (!object.path.hasArea())
                object.style.fill.reset();
            object.particulars.id = idOf(object.particulars.id);
            builder_.add(object);
        }
    }

    const app::Document& document_;
    app::DocumentBuilder builder_;
    std::set<QString> ids_;
};
