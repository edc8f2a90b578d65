// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QKeyEvent>
#include <QKeySequence>

#include <string_view>

namespace ui {

/// The command that keeps the other side of the clip windows.
constexpr std::string_view keepOutside = "keep-outside";

/// The keys of commands that the canvas itself understands: those of transformations, which begin
/// in the middle of a gesture, and those of the chosen clip window.
class OwnKeys {
public:
    using Keys = QHash<QString, QList<QKeySequence>>;

    /// What commands have from now on; before, they have the standard ones.
    void tell(const Keys& keys) { keys_ = keys; }
    /// Whether the command has this key; `standard` is the one that it has unless another is told.
    bool isOf(const QKeyEvent& event, std::string_view command, const QKeySequence& standard) const;
    /// Whether it is a key of the chosen clip window.
    bool isOfWindow(const QKeyEvent& event) const;

private:
    Keys keys_;
};

/// Whether the event is this key. A sign is the same with Shift and without, as keyboards differ.
bool isPressed(const QKeySequence& key, const QKeyEvent& event);

} // namespace ui
