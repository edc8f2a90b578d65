// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/dock.h"

namespace ui {

/// The docks of a window by their part in its layout.
struct PanelDocks {
    Dock* start;         ///< in front until a drawing is opened or changed
    QList<Dock*> narrow; ///< the working panels
    QList<Dock*> wide;   ///< the comparison panels: above the others, in a wider column

    QList<Dock*> all() const { return QList<Dock*>{start} + narrow + wide; }
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

namespace app {
class Session;
}

namespace ui {

class AlgorithmPanel;
class Canvas;
class ComparePanel;
class CostMapPanel;
class CutOptionsBox;
class DifferencePanel;
class ExactnessPanel;
class HistoryPanel;
class LayersPanel;
class LinePanel;
class PropertiesPanel;
class StartPanel;
class WindowPanel;

/// The panels of a window, each in its dock. The window that the docks are added to owns them.
struct Panels {
    Panels(app::Session& session, Canvas& canvas);

    StartPanel* start;
    AlgorithmPanel* algorithm;
    WindowPanel* window;
    CutOptionsBox* cutEdges;
    PropertiesPanel* properties;
    LinePanel* line;
    LayersPanel* layers;
    HistoryPanel* history;
    ComparePanel* compare;
    DifferencePanel* difference;
    CostMapPanel* costMap;
    ExactnessPanel* exactness;
    PanelDocks docks;

    /// In the heading of the algorithm: whether lines differ from `exact`, and the time.
    void showResult(const app::Session& session, const QString& time, std::size_t differing) const;

private:
    void nameSections();
};

} // namespace ui
