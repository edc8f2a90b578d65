// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/tools/kept_choices.h"
#include "ui/tools/node_chain.h"

namespace ui {
namespace {

/// Draws a polyline with a corner at every click; a closed one, if that is chosen.
class PolylineTool final : public ChainTool {
public:
    void end(Workbench& bench) override
    {
        corrects() ? cancel(bench) : finish(bench, nodes_.size() > 2 && closes(bench));
    }
    QString stepText() const override { return Text::tr("Place corner"); }

protected:
    bool closes(const Workbench& bench) const override
    {
        return nodes_.size() > 1 && keptBy(keptPolyline, bench, usualPolyline)[0] != 0;
    }
    QString undoText() const override { return Text::tr("Draw polyline"); }
};

} // namespace

std::unique_ptr<Tool> makePolylineTool() { return std::make_unique<PolylineTool>(); }

} // namespace ui
