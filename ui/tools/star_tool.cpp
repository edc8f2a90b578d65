// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/tools/centre_tool.h"

namespace ui {
namespace {

/// Draws a star; the fourth number is its inner radius as a share of the outer one.
class StarTool final : public CentreTool {
protected:
    const app::GestureMeasure& measure(Qt::KeyboardModifiers) const override
    {
        return app::starMeasure();
    }
    app::Numbers usual() const override { return app::usualStar(); }
    std::string_view keeps() const override { return "star"; }
    app::StarRecipe starOf(const Gesture& gesture) const override
    {
        return app::starTo(gesture.from, gesture.to, gesture.numbers);
    }
    QString undoText() const override { return Text::tr("Draw star"); }
};

} // namespace

std::unique_ptr<Tool> makeStarTool() { return std::make_unique<StarTool>(); }

} // namespace ui
