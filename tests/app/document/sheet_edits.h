// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/add_and_remove.h"
#include "app/commands/set_containers.h"
#include "app/scene/scene_lines.h"

#include "tests/app/document/sheet.h"

// Edits of a document in the words of a sheet.

inline app::Sheet sheetOf(const app::EditedDocument& document)
{
    return app::sheetOf(document.now());
}

/// In one array.
inline std::vector<clipping::Segment> segmentsOf(const app::SceneLines& lines)
{
    std::vector<clipping::Segment> all;
    for (const auto& run : lines.runs())
        all.insert(all.end(), run.segments.begin(), run.segments.end());
    return all;
}

inline void load(app::EditedDocument& document, const app::Sheet& sheet)
{
    document.load(app::documentOf(sheet));
}

/// Their styles are added to those of `like`.
inline app::Objects objectsOf(const app::Objects& like, const std::vector<app::Shape>& shapes)
{
    app::Objects objects = like.slice(0, 0);
    for (const app::Shape& shape : shapes)
        objects.append({app::Path(shape.paths), shape.style, {.id = shape.id}, shape.hidden});
    return objects;
}

/// What is added goes to the container of the first object that goes; else to `shapes`' layer.
inline void splice(app::EditedDocument& document, std::size_t first, std::size_t removed,
                   const std::vector<app::Shape>& shapes)
{
    const app::Document& now = document.now();
    app::Edit edit;
    edit.splices = {{std::uint32_t(first), std::uint32_t(removed), std::uint32_t(shapes.size())}};
    edit.objects = objectsOf(now.objects(), shapes);
    const auto layers = now.containers().childrenOf(0);
    const app::ContainerId into = shapes.empty() ? 0 : layers.at(shapes.front().layer);
    edit.containers = now.containers().spliced(edit.splices, into);
    document.apply(edit);
}

inline void setWindow(app::EditedDocument& document, const clipping::Window& window)
{
    app::Edit edit;
    edit.windows = app::ClipWindows{{{.shape = app::RectangleShape{window}}}};
    document.apply(edit);
}

/// As many layers as there are.
inline void setLayers(app::EditedDocument& document, const std::vector<app::Layer>& layers)
{
    app::Edit edit;
    app::Containers containers = document.now().containers();
    const auto ids = containers.childrenOf(0);
    for (std::size_t i = 0; i < layers.size(); ++i)
        containers = containers.with({.id = ids.at(i),
                                      .name = layers[i].name,
                                      .svgId = layers[i].id,
                                      .visible = layers[i].visible,
                                      .locked = layers[i].locked});
    edit.containers = containers;
    document.apply(edit);
}

inline void setPage(app::EditedDocument& document, const app::Page& page)
{
    app::Edit edit;
    edit.page = page;
    document.apply(edit);
}

/// The command that adds shapes of one layer.
inline app::UndoCommand* addShapes(app::EditedDocument& document,
                                   const std::vector<app::Shape>& shapes, const QString& text)
{
    const auto layers = document.now().containers().childrenOf(0);
    return new app::AddObjects(document, objectsOf(document.now().objects(), shapes),
                               layers.at(shapes.front().layer), text);
}

/// The command that adds a layer above all others.
inline app::UndoCommand* addLayer(app::EditedDocument& document, const QString& name)
{
    const app::Containers& containers = document.now().containers();
    const std::size_t top = containers.objects();
    return new app::SetContainers(
        document,
        *containers.inserted({.name = name}, 0, containers.childrenOf(0).size(), {top, top}),
        QStringLiteral("Add layer"));
}
