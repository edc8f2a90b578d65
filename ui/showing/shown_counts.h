// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>
#include <string_view>

namespace ui {

class MainWindow;

/// A number of a drawing and its window that a page of the manual says at the end of its steps.
struct ShownCount {
    std::string_view name;
    double (*count)(const MainWindow& window);
};

std::span<const ShownCount> shownCounts();
const ShownCount* shownCount(const QString& name); ///< null: there is none of this name

} // namespace ui
