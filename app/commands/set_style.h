// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

namespace app {

/// Changes how shapes are painted.
class SetStyle : public UndoCommand {
public:
    static constexpr CommandKind row{"set-style", "Changes how shapes are painted"};

    /// `change` is called once for each shape's style.
    SetStyle(Drawing& drawing, const ObjectRanges& shapes,
             const std::function<void(Style&)>& change, const QString& text,
             Merging merging = Merging::Never);

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }
    bool mergeWith(const UndoCommand& next) override;
    std::size_t bytes() const override { return heapBlock(sizeof *this) + heapBytes(patches_); }

private:
    Drawing& drawing_;
    Patches patches_;
};

} // namespace app
