// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/name_match.h"

#include <QIcon>

#include <functional>
#include <optional>
#include <vector>

namespace ui {

class MainWindow;
class OtherWindows;

/// A line of the palette: what Enter does, with the name by which it is found.
struct PaletteRow {
    enum class Part : std::uint8_t { Commands, Drawing, Help };
    Part part = Part::Commands;
    bool isRecent = false; ///< listed because it was run not long ago
    QString key{};         ///< by which it is remembered; empty: it is not
    QIcon icon{};
    QString before{}; ///< the name, where that alone says little: "Theme"
    QString name{};
    QString what{}; ///< the menu; "layer, 64 objects"
    QString note{}; ///< its keys, or why it cannot be run
    bool enabled = true;
    app::NameMatch match{};
    std::function<void()> run{};
};

/// Everything that the palette can find: every command of the menus, windows, layers, groups and
/// objects of the drawing, and the pages of the manual. Whether a command can be run is judged when
/// this is made, before the palette has the keyboard.
class PaletteRows {
public:
    PaletteRows(MainWindow& window, OtherWindows& others);

    /// Those that fit, part by part, the best first; what cannot be run is last in its part.
    /// Nothing typed: the last ten that were run, or all if none was. `only`: of this part.
    std::vector<PaletteRow> matching(const QString& typed,
                                     std::optional<PaletteRow::Part> only) const;
    void remember(const PaletteRow& row) const; ///< it was run

private:
    std::vector<PaletteRow> recent() const;
    std::vector<PaletteRow> ofDrawing(const QString& typed) const;

    MainWindow& window_;
    std::vector<PaletteRow> commands_, pages_;
};

} // namespace ui
