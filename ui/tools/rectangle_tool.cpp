// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/corner_tool.h"

#include <QCoreApplication>

namespace ui {
namespace {

class RectangleTool final : public CornerTool {
protected:
    app::Subpath pathIn(const clipping::Window& r) const override
    {
        return {r.min, {{{r.max.x, r.min.y}}, {r.max}, {{r.min.x, r.max.y}}}, true};
    }
    app::Recipe recipeIn(const clipping::Window& r) const override
    {
        return app::RectangleRecipe{r.min, r.max - r.min};
    }
    QString undoText() const override
    {
        return QCoreApplication::translate("Commands", "Draw rectangle");
    }
};

} // namespace

std::unique_ptr<Tool> makeRectangleTool() { return std::make_unique<RectangleTool>(); }

} // namespace ui
