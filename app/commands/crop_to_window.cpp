// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/crop_to_window.h"

#include "app/base/text.h"

namespace app {

CropToWindow::CropToWindow(EditedDocument& document, const CutOptions& options)
    : CropToWindow(document, cut(document.now(), options))
{
}

CropToWindow::CropToWindow(EditedDocument& document, Cut cut, const PermanentCut& kind)
    : EditCommand(row, document, cut.edit, Text::tr(kind.name)), counts_(cut.counts),
      changes_(!cut.edit.splices.empty())
{
}

} // namespace app
