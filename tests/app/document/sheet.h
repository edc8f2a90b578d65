// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"
#include "app/scene/compared_window.h"

// A drawing as a plain list of shapes on plain layers: how tests write down what they draw, and
// look at what became of it.

namespace app {

/// An object of a sheet.
struct Shape {
    std::vector<Subpath> paths;
    Style style;
    QString id;              ///< the SVG's, kept through cut and export; may be empty
    std::uint32_t layer = 0; ///< index into Sheet::layers
    bool hidden = false;     ///< stays hidden and is not exported
    friend bool operator==(const Shape&, const Shape&) = default;
};

struct Layer {
    QString name;
    bool visible = true;
    bool locked = false;
    QString id{}; ///< the SVG's; may be empty
    friend bool operator==(const Layer&, const Layer&) = default;
};

/// A whole drawing with one clip window.
struct Sheet {
    Page page;
    std::vector<Layer> layers{{QStringLiteral("Drawing")}}; ///< bottom to top, never empty
    std::vector<Shape> shapes; ///< bottom to top; `layer` never decreases
    clipping::Window window = page.rectangle(); ///< the clip window
    About about{};
    friend bool operator==(const Sheet&, const Sheet&) = default;

    bool shown(const Shape& shape) const { return !shape.hidden && layers[shape.layer].visible; }
};


inline Container containerOf(const Layer& layer)
{
    return {.kind = Container::Kind::Layer,
            .name = layer.name,
            .svgId = layer.id,
            .visible = layer.visible,
            .locked = layer.locked};
}

// The layers of a document in a row, with their objects.
class SheetRow {
public:
    SheetRow(const Document& document, Sheet& sheet) : document_(document), sheet_(sheet)
    {
        for (const ContainerId id : containers().childrenOf(0))
            addLayer(id, {});
    }

private:
    // A layer of the document, and where its last part lies in the sheet.
    struct Open {
        Layer layer;
        int parts = 0;
        std::size_t index = 0;
    };

    const Containers& containers() const { return document_.containers(); }

    void addLayer(ContainerId id, const Layer& around)
    {
        const Container& layer = containers()[id];
        Open open{{layer.name, layer.visible && around.visible, layer.locked || around.locked,
                   layer.svgId}};
        begin(open);
        addContents(id, open, true);
    }

    // Objects and containers in painting order.
    void addContents(ContainerId id, Open& open, bool visible)
    {
        const ObjectRange all = containers().rangeOf(id);
        std::size_t next = all.first;
        for (const ContainerId child : containers().childrenOf(id)) {
            const ObjectRange range = containers().rangeOf(child);
            addObjects({next, range.first}, open, visible);
            const Container& inner = containers()[child];
            if (inner.kind == Container::Kind::Layer)
                addLayer(child, open.layer);
            else
                addContents(child, open, visible && inner.visible);
            next = range.end;
        }
        addObjects({next, all.end}, open, visible);
    }

    void addObjects(const ObjectRange& range, Open& open, bool visible)
    {
        if (range.empty())
            return;
        if (open.index + 1 != sheet_.layers.size())
            begin(open);
        document_.objects().forEach(
            range.first, range.size(), [&](std::size_t, const ObjectView& object) {
                sheet_.shapes.push_back({object.path().subpaths(), object.style(),
                                         object.particulars().id, std::uint32_t(open.index),
                                         object.hidden() || !visible});
            });
    }

    void begin(Open& open)
    {
        Layer layer = open.layer;
        if (open.parts++ > 0) {
            layer.name = QStringLiteral("%1 (%2)").arg(layer.name, QString::number(open.parts));
            layer.id.clear(); // an id is there once
        }
        open.index = sheet_.layers.size();
        sheet_.layers.push_back(layer);
    }

    const Document& document_;
    Sheet& sheet_;
};

/// The same drawing as a document. Its layers follow each other on the first level; its clip window
/// is the only one, a rectangle without a name, and its inside is kept.
inline Document documentOf(const Sheet& sheet)
{
    DocumentBuilder builder;
    auto shape = sheet.shapes.begin();
    for (std::size_t i = 0; i < sheet.layers.size(); ++i) {
        builder.open(containerOf(sheet.layers[i]));
        for (; shape != sheet.shapes.end() && shape->layer == i; ++shape)
            builder.add(Object{Path(shape->paths), shape->style, {.id = shape->id}, shape->hidden});
        builder.close();
    }
    return builder.take(sheet.page, sheet.about, {{{.shape = RectangleShape{sheet.window}}}});
}

/// What a sheet can hold of a document; all of it if it came from one.
/// - Layers in layers become layers that follow each other, hidden or locked where one around them
///   is. One whose objects are interrupted by those of another becomes several: "Roads",
///   "Roads (2)", of which the first has the id.
/// - Groups dissolve. Objects of hidden ones are hidden; whether one was locked is lost.
/// - The clip window is `comparedWindow`'s.
/// - Titles, descriptions and recipes of objects and layers are lost.
inline Sheet sheetOf(const Document& document)
{
    Sheet sheet;
    sheet.page = document.page();
    sheet.about = document.about();
    sheet.window = comparedWindow(document.windows(), document.page()).window;
    sheet.layers.clear();
    sheet.shapes.reserve(document.objects().size());
    SheetRow(document, sheet);
    return sheet;
}

} // namespace app
