// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/dock.h"

namespace ui {

/// The docks of a window by their part in its layout.
struct PanelDocks {
    Dock* start;         ///< in front until a drawing is opened or changed
    Dock* algorithm;     ///< may be folded
    QList<Dock*> narrow; ///< the other working panels
    QList<Dock*> wide;   ///< the comparison panels: above the others, in a wider column

    /// The working panels.
    QList<Dock*> working() const { return QList<Dock*>{algorithm} + narrow; }
    QList<Dock*> all() const { return QList<Dock*>{start} + working() + wide; }
    /// Those with these keys, in their order.
    QList<Dock*> named(const QStringList& keys) const
    {
        QList<Dock*> found;
        for (const QString& key : keys)
            for (Dock* dock : all())
                if (dock->objectName() == key)
                    found << dock;
        return found;
    }
};

} // namespace ui
