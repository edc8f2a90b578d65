// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

#include <QString>

#include <span>
#include <string_view>
#include <vector>

namespace app {

/// An operation of clip windows with its names, sign, key and look: a row of a catalogue.
struct WindowOperationInfo {
    WindowOperation operation;
    std::string_view word;      ///< in files and on the command line: "cut-out"
    std::string_view key;       ///< of the command: "window-cuts-out"
    std::string_view icon;      ///< "window-cut-out"
    QString letter;             ///< the key for the chosen window on the canvas: "-"
    QString sign;               ///< in formulas: "−"
    QString name;               ///< "Cut out"
    QString verb;               ///< "cuts out"
    QString entry;              ///< in a menu, with its mnemonic: "Cut out of t&hose above"
    QString tip;                ///< "Cut the window out of those above it"
    QString step;               ///< of undo, with a place for the window's name: "Cut out %1"
    QString phrase;             ///< the same in a sentence: "cut out %1"
    std::vector<double> dashes; ///< of the window's outline, in pixels; empty: it is solid
    bool needsOneAbove = false; ///< the first window cannot get it
};

// THE CATALOGUE, in the order of WindowOperation.
std::span<const WindowOperationInfo> windowOperations();
const WindowOperationInfo& infoOf(WindowOperation operation);

/// The operation with this word; empty: there is none.
std::optional<WindowOperation> windowOperation(std::string_view word);

} // namespace app
