// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"
#include "app/view/snapping/snapper.h"

#include <QTest>

// A drawing whose places are asked for.

/// An object of one subpath.
inline app::Object objectOf(const app::Subpath& path)
{
    return {app::Path(std::vector{path}), {.stroke = app::Colour{}}};
}
inline app::Object objectOf(const app::Recipe& recipe)
{
    app::Object object = objectOf(*app::outlineOf(recipe));
    object.particulars.recipe = recipe;
    return object;
}
inline app::Object lineFrom(const app::Point& a, const app::Point& b)
{
    return objectOf(app::Subpath{a, {{b}}, false});
}

struct SnapStage {
    explicit SnapStage(const std::vector<app::Object>& objects, app::ClipWindows windows = {})
        : document(documentOf(objects, std::move(windows)))
    {
    }
    static app::Document documentOf(const std::vector<app::Object>& objects,
                                    app::ClipWindows windows)
    {
        app::DocumentBuilder builder;
        builder.open({.name = "layer"});
        for (const app::Object& object : objects)
            builder.add(object);
        builder.close();
        return builder.take({}, {}, std::move(windows));
    }
    /// Snapping with a radius of 3 units; "ends middles": only to these.
    std::optional<app::Snap> at(const app::Point& pointer, const char* kinds,
                                std::optional<app::Point> from = {}) const
    {
        app::SnapTo to = app::SnapTo::Nothing;
        for (const QString& kind : QString(kinds).split(u' ', Qt::SkipEmptyParts))
            to = to.with(kind.toStdString());
        app::SnapQuery query{pointer, 3, to, from};
        query.guides = &guides;
        return snapper.at(query);
    }
    /// The point and the word at it: "10 20 end".
    QString textAt(const app::Point& pointer, const char* kinds,
                   std::optional<app::Point> from = {}) const
    {
        const auto snap = at(pointer, kinds, from);
        return snap ? QStringLiteral("%1 %2 %3")
                          .arg(snap->point.x)
                          .arg(snap->point.y)
                          .arg(snap->word())
                    : QStringLiteral("nothing");
    }

    app::EditedDocument document;
    app::Scene scene{document};
    app::Picking picking{document, scene};
    app::Snapper snapper{document, scene, picking};
    app::Guides guides{};
};
