// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/contents.h"
#include "app/document/flatten.h"
#include "app/document/hidden_objects.h"
#include "app/export/export_drawing.h"
#include "app/formats/painted.h"
#include "app/formats/png.h"

#include <unordered_set>

namespace app {

ExportFacts factsOf(const ExportDrawing& drawing, const Format& format)
{
    const Document& document = drawing.document;
    const Page& page = document.page();
    const ObjectRanges hidden = hiddenObjects(document);
    std::unordered_set<ContainerId> layers;
    Contents stroked;
    ExportFacts facts{.paper = paperOf(page).millimetres};
    document.objects().forEach(0, document.objects().size(),
                               [&](std::size_t i, const ObjectView& object) {
                                   if (hidden.contains(i))
                                       return;
                                   ++facts.paths;
                                   layers.insert(document.containers().layerOf(i));
                                   if (object.style().stroke)
                                       add(stroked, object, usualTolerance(page));
                               });
    facts.layers = layers.size();
    facts.length = stroked.length * page.millimetresPerUnit();
    if (format.takes.dpi)
        facts.pixels = pixelsOf(page, drawing.options.dpi);
    return facts;
}

} // namespace app
