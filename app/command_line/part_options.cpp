// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/part_options.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/document/hidden_objects.h"
#include "app/export/drawn_box.h"
#include "app/export/export_area.h"
#include "app/export/part_of_drawing.h"

namespace app {

std::vector<Option> partOptions()
{
    return {
        {{"layer"}, "NAME", Text::tr("Take only what is seen of this layer.")},
        {{"fit-paper"},
         {},
         Text::tr("Make the page just as large as what the windows keep, or, if nothing is cut, "
                  "as what is drawn, with its strokes.")}};
}

static DrawingPart only(const Imported& imported, ContainerId layer)
{
    const Document& all = imported.document;
    const ObjectRanges objects =
        without(ObjectRanges(all.containers().rangeOf(layer)), hiddenObjects(all));
    DrawingPart part{onlyObjects(onlyImagesIn(all, layer), objects), {}};
    if (!imported.rows.empty())
        for (const ObjectRange& range : objects.ranges())
            part.rows.insert(part.rows.end(), imported.rows.begin() + std::ptrdiff_t(range.first),
                             imported.rows.begin() + std::ptrdiff_t(range.end));
    return part;
}

DrawingPart chosenPart(const ParsedArguments& arguments, const Imported& imported)
{
    const auto name = arguments.text(QStringLiteral("layer"));
    if (!name)
        return {imported.document, imported.rows};
    const Containers& tree = imported.document.containers();
    QStringList names;
    for (const ContainerId id : tree.inOrder())
        if (tree[id].kind == Container::Kind::Layer) {
            names << tree[id].name;
            if (tree[id].name == *name)
                return only(imported, id);
        }
    throw Failure{Text::tr("There is no layer “%1”. The layers are: %2.")
                      .arg(*name, names.join(QStringLiteral(", ")))};
}

void fitPaper(const ParsedArguments& arguments, const ClipWindows& windows, Document& drawing)
{
    if (!arguments.has(QStringLiteral("fit-paper")))
        return;
    auto box = boxAround(windows);
    if (!box)
        box = drawnBox(drawing);
    if (!box)
        throw Failure{Text::tr("Nothing is seen of the drawing, so the page cannot be fitted to "
                               "it.")};
    drawing.apply({.page = paperAround(drawing.page(), *box)});
}

} // namespace app
