// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/typed_entry.h"
#include "app/session/session.h"
#include "app/view/handles.h"

#include <span>
#include <string_view>

namespace app {

/// How the numbers of the selection are meant.
struct SelectionFrame {
    Handle reference{-1, -1}; ///< the point of its box that X and Y are, and that stays
    bool keepsRatio = false;  ///< a width or height changes the other one as well
};

/// One number of the selection, such as its width: a row of a catalogue.
struct SelectionNumber {
    std::string_view key;
    QString label; ///< "W"
    QString name;  ///< "Width"
    Quantity quantity;
    /// In user units or degrees; empty: the selection has no such number.
    std::optional<double> (*value)(const Session& session, const SelectionFrame& frame);
    /// The map that gives the selection this number; empty: there is none.
    std::optional<AffineMap> (*map)(const Session& session, const SelectionFrame& frame,
                                    double value);
    QString refusal; ///< the sentence if there is no such map
};

// THE CATALOGUE. To add a number: add its row.
std::span<const SelectionNumber> selectionNumbers();

/// Gives the selection the number, as one undo step. Nothing, or why it cannot.
std::optional<QString> setSelectionNumber(Session& session, const SelectionNumber& number,
                                          const SelectionFrame& frame, double value,
                                          Merging merging = Merging::Never);

} // namespace app
