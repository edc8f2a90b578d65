// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

namespace ui {
namespace {

/// A click moves the view so that the point is in the middle.
class CentreTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        bench.view.centre = pointer.raw;
    }
    app::SnapTo snapsTo() const override { return app::SnapTo::Nothing; }
};

} // namespace

std::unique_ptr<Tool> makeCentreTool() { return std::make_unique<CentreTool>(); }

} // namespace ui
