// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/node_chain.h"

#include <QCoreApplication>

namespace ui {
namespace {

/// Draws a polyline with a corner at every click.
class PolylineTool final : public ChainTool {
public:
    QString stepText() const override
    {
        return QCoreApplication::translate("Commands", "Place corner");
    }

protected:
    QString undoText() const override
    {
        return QCoreApplication::translate("Commands", "Draw polyline");
    }
};

} // namespace

std::unique_ptr<Tool> makePolylineTool() { return std::make_unique<PolylineTool>(); }

} // namespace ui
