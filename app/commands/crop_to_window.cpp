// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/crop_to_window.h"

#include "app/document/legacy.h"

#include <QCoreApplication>

namespace app {
namespace {

// Objects that are whole keep their place; for each other one what is left of it comes.
Edit cropped(const Document& document, const Cut& cut)
{
    const Objects left = documentOf(cut.sheet).objects();
    Edit edit;
    edit.objects = document.objects().slice(0, 0);
    std::size_t next = 0;
    for (std::size_t i = 0; i < document.objects().size(); ++i) {
        const std::size_t first = next;
        while (next < cut.sources.size() && cut.sources[next] == i)
            ++next;
        const bool whole = next - first == 1 && left[first].copy() == document.objects()[i].copy();
        if (whole)
            continue;
        edit.splices.push_back({std::uint32_t(i), 1, std::uint32_t(next - first)});
        edit.objects.append(left.slice(first, next - first));
    }
    edit.containers = spliced(document.containers(), edit.splices);
    return edit;
}

} // namespace

CropToWindow::CropToWindow(EditedDocument& document, const CutOptions& options)
    : CropToWindow(document, cut(sheetOf(document.now()), options))
{
}

CropToWindow::CropToWindow(EditedDocument& document, const Cut& cut)
    : EditCommand(row, document, cropped(document.now(), cut),
                  QCoreApplication::translate("Commands", "Crop to window")),
      counts_(cut.counts)
{
}

} // namespace app
