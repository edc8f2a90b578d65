// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/workspaces.h"

#include "ui/look/text.h"

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr std::size_t usualWorkspace = 1; // Cut

} // namespace

std::span<const Workspace> workspaces()
{
    // THE CATALOGUE. The panels are named by their keys (panels.cpp).
    static const std::array all{
        Workspace{.key = "workspace-draw",
                  .name = Text::tr("Draw"),
                  .tip = Text::tr("Layers, properties of the selection, history"),
                  .column = {"layers", "properties", "history"},
                  .folds = {"history"},
                  .draws = true},
        Workspace{.key = "workspace-cut",
                  .name = Text::tr("Cut"),
                  .tip = Text::tr("Clip windows, the algorithm, and how edges are cut"),
                  .column = {"window", "algorithm", "cut-edges", "layers"},
                  .folds = {"algorithm", "cut-edges"}},
        Workspace{.key = "workspace-compare",
                  .name = Text::tr("Compare"),
                  .tip = Text::tr("All algorithms beside each other"),
                  .column = {"compare", "difference", "window"},
                  .folds = {"difference", "window"},
                  .compares = true},
        Workspace{.key = "workspace-learn",
                  .name = Text::tr("Learn"),
                  .tip = Text::tr("Algorithm, and the line that it clips"),
                  .column = {"algorithm", "line"}},
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
