// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/tools/centre_tool.h"

namespace ui {
namespace {

/// Draws a regular polygon. Alt: the pointer is at the middle of a side instead of a corner.
class PolygonTool final : public CentreTool {
protected:
    const app::GestureMeasure& measure(Qt::KeyboardModifiers) const override
    {
        return app::polygonMeasure();
    }
    app::Numbers usual() const override { return app::usualPolygon(); }
    std::string_view keeps() const override { return "polygon"; }
    app::StarRecipe starOf(const Gesture& gesture) const override
    {
        return app::polygonTo(gesture.from, gesture.to, gesture.numbers,
                              anchorOf(gesture.modifiers));
    }
    QString undoText() const override { return Text::tr("Draw polygon"); }
};

} // namespace

std::unique_ptr<Tool> makePolygonTool() { return std::make_unique<PolygonTool>(); }

} // namespace ui
