// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/crop_to_window.h"

#include <QCoreApplication>

namespace app {

CropToWindow::CropToWindow(EditedDocument& document, const CutOptions& options)
    : CropToWindow(document, cut(document.now(), options))
{
}

CropToWindow::CropToWindow(EditedDocument& document, Cut cut)
    : EditCommand(row, document, std::move(cut.edit),
                  QCoreApplication::translate("Commands", "Crop to window")),
      counts_(cut.counts)
{
}

} // namespace app
