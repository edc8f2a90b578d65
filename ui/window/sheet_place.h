// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace ui {

class Canvas;
class Centre;
class Sheet;

/// The place of sheets at the right of the window: one at a time, which gets the focus. It takes
/// the place of the panels, which come back with its end (`Modes`).
class SheetPlace : public QObject {
    Q_OBJECT

public:
    SheetPlace(Centre& centre, Canvas& canvas);

    Sheet* sheet() const; ///< null: none
    /// Shows a sheet, which belongs to the window from now on, instead of the one before.
    void show(Sheet* sheet);
    void close(); ///< the focus returns to the canvas

signals:
    void changed(); ///< a sheet was opened or closed

private:
    Centre& centre_;
    Canvas& canvas_;
};

} // namespace ui
