// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// How selected objects are arranged with one command: one row of a catalogue, from which the menu
/// Object and the panel Selection are made. Each is one undo step.
struct Arrangement {
    enum class Kind : std::uint8_t { Align, Turn, Spread, SameSize };
    Kind kind;
    std::string_view key;  ///< also of its icon, if it has a button
    QString text;          ///< in its menu, with the mnemonic
    QString name;          ///< by itself: "Align left sides"
    QString shortcut = {}; ///< empty: none
    std::size_t least = 1; ///< how many objects must be selected
    bool button = true;    ///< also in the panel Selection
    void (*run)(Session& session);
};

std::span<const Arrangement> arrangements();

/// Why it is impossible now, in one sentence; empty: it is possible.
QString refusal(const Arrangement& how, const Session& session);

} // namespace app
