// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/tools/node_chain.h"

namespace ui {
namespace {

/// Draws a polyline with a corner at every click.
class PolylineTool final : public ChainTool {
public:
    QString stepText() const override { return Text::tr("Place corner"); }

protected:
    QString undoText() const override { return Text::tr("Draw polyline"); }
};

} // namespace

std::unique_ptr<Tool> makePolylineTool() { return std::make_unique<PolylineTool>(); }

} // namespace ui
