// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/workspaces.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr std::size_t usualWorkspace = 1; // Cut

QString tr(const char* text) { return QCoreApplication::translate("Workspaces", text); }

} // namespace

std::span<const Workspace> workspaces()
{
    // THE CATALOGUE. The panels are named by their keys (panels.cpp).
    static const std::array all{
        Workspace{.key = "workspace-draw",
                  .name = tr("Draw"),
                  .tip = tr("Numbers and style of the selection, layers, history"),
                  .column = {"algorithm", "selection", "style", "layers", "history"},
                  .folds = true},
        Workspace{.key = "workspace-cut",
                  .name = tr("Cut"),
                  .tip = tr("Algorithm and clip window"),
                  .column = {"algorithm", "window", "line", "layers", "selection"},
                  .tiles = true},
        Workspace{.key = "workspace-compare",
                  .name = tr("Compare"),
                  .tip = tr("All algorithms beside each other"),
                  .column = {"algorithm", "window", "line", "layers"},
                  .wide = "compare"},
        Workspace{.key = "workspace-learn",
                  .name = tr("Learn"),
                  .tip = tr("Algorithm, and the line that it clips"),
                  .column = {"algorithm", "line", "window"}},
    };
    return all;
}

const Workspace& findWorkspace(std::string_view key)
{
    const auto all = workspaces();
    const auto found = std::ranges::find(all, key, &Workspace::key);
    return found == all.end() ? all[usualWorkspace] : *found;
}

} // namespace ui
