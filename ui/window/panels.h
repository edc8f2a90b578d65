// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/panel_docks.h"

namespace app {
class Session;
}

namespace ui {

class AlgorithmPanel;
class Canvas;
class ComparePanel;
class CostMapPanel;
class DifferencePanel;
class ExactnessPanel;
class HistoryPanel;
class LayersPanel;
class LinePanel;
class SelectionPanel;
class StartPanel;
class StylePanel;
class WindowPanel;

/// The panels of a window, each in its dock. The window that the docks are added to owns them.
struct Panels {
    Panels(app::Session& session, Canvas& canvas);

    StartPanel* start;
    AlgorithmPanel* algorithm;
    WindowPanel* window;
    SelectionPanel* selection;
    StylePanel* style;
    LinePanel* line;
    LayersPanel* layers;
    HistoryPanel* history;
    ComparePanel* compare;
    DifferencePanel* difference;
    CostMapPanel* costMap;
    ExactnessPanel* exactness;
    PanelDocks docks;
};

} // namespace ui
