// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/document/recipe_outline.h"
#include "ui/look/text.h"
#include "ui/tools/corner_tool.h"

#include <algorithm>

namespace ui {
namespace {

/// Draws a rectangle. The radius of its corners is typed, and kept for the next rectangle.
class RectangleTool final : public CornerTool {
public:
    QString hint(const Workbench& bench) const override
    {
        if (const QString again = CornerTool::hint(bench); !again.isEmpty())
            return again;
        const double radius = keptBy(keeps(), bench, {})[2];
        if (radius <= 0)
            return {};
        const double size = bench.session.now().page().realMillimetresPerUnit();
        return Text::tr("The corner radius %1 is kept. Tab, Tab, 0, Enter while drawing: sharp "
                        "corners.")
            .arg(app::lengthText(radius, bench.session.display().unit, size));
    }

protected:
    const app::GestureMeasure& measure(Qt::KeyboardModifiers modifiers) const override
    {
        return app::widthHeightAndRadius(proportionOf(modifiers), anchorOf(modifiers));
    }
    std::string_view keeps() const override { return "rectangle"; }
    app::Subpath pathIn(const clipping::Window& r, const app::Numbers& numbers) const override
    {
        if (radiusIn(r, numbers) > 0)
            return *app::outlineOf(recipeIn(r, numbers));
        return {r.min, {{{r.max.x, r.min.y}}, {r.max}, {{r.min.x, r.max.y}}}, true};
    }
    app::Recipe recipeIn(const clipping::Window& r, const app::Numbers& numbers) const override
    {
        return app::RectangleRecipe{r.min, r.max - r.min, radiusIn(r, numbers)};
    }
    QString undoText() const override { return Text::tr("Draw rectangle"); }

private:
    /// At most half the shorter side, as in SVG.
    static double radiusIn(const clipping::Window& r, const app::Numbers& numbers)
    {
        const app::Point half = (r.max - r.min) * 0.5;
        return std::clamp(numbers[2], 0.0, std::min(half.x, half.y));
    }
};

} // namespace

std::unique_ptr<Tool> makeRectangleTool() { return std::make_unique<RectangleTool>(); }

} // namespace ui
