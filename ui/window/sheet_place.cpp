// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/sheet_place.h"

#include "ui/canvas/canvas.h"
#include "ui/widgets/sheet.h"
#include "ui/window/centre.h"

namespace ui {

SheetPlace::SheetPlace(Centre& centre, Canvas& canvas) : centre_(centre), canvas_(canvas) {}

Sheet* SheetPlace::sheet() const { return centre_.sheet(); }

void SheetPlace::show(Sheet* sheet)
{
    canvas_.endGesture();
    centre_.setSheet(sheet);
    connect(sheet, &Sheet::closeWanted, this, &SheetPlace::close);
    emit changed();
    sheet->focusFirst();
}

void SheetPlace::close()
{
    if (!sheet())
        return;
    centre_.setSheet(nullptr);
    emit changed();
    if (centre_.showsCanvas())
        canvas_.setFocus();
}

} // namespace ui

#include "moc_sheet_place.cpp"
