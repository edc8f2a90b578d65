// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe_outline.h"
#include "ui/look/text.h"
#include "ui/tools/corner_tool.h"

namespace ui {
namespace {

class EllipseTool final : public CornerTool {
protected:
    app::Subpath pathIn(const clipping::Window& r, const app::Numbers& numbers) const override
    {
        return *app::outlineOf(recipeIn(r, numbers));
    }
    app::Recipe recipeIn(const clipping::Window& r, const app::Numbers&) const override
    {
        const app::Point radii = (r.max - r.min) * 0.5;
        return app::EllipseRecipe{r.min + radii, radii};
    }
    QString undoText() const override { return Text::tr("Draw ellipse"); }
};

} // namespace

std::unique_ptr<Tool> makeEllipseTool() { return std::make_unique<EllipseTool>(); }

} // namespace ui
