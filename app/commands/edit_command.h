// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/memory.h"
#include "app/commands/undo_command.h"
#include "app/document/affine_map.h"
#include "app/document/edited_document.h"

#include <functional>

namespace app {

/// How the objects that an edit adds follow from those that it replaces, one for one. It lets a
/// journal record the step without the objects.
struct Derivation {
    enum class How : std::uint8_t {
        Unknown,
        Placed,   ///< `changed` with place() and `where` makes them (move_objects.h)
        Restyled, ///< only their styles differ
        Mapped    ///< `changed` with transform() and `map` makes them (transform_objects.h)
    };
    How how = How::Unknown;
    Placement where{};
    AffineMap map{};
};

/// A command that consists of one edit of the document. It stores the next edit to apply: after
/// redo(), the edit that undoes it.
class EditCommand : public UndoCommand {
public:
    EditCommand(const CommandKind& kind, EditedDocument& document, Edit edit, const QString& text,
                Merging merging = Merging::Never, const Derivation& derivation = {})
        : UndoCommand(kind, text, merging), document_(document), next_(std::move(edit)),
          derivation_(derivation)
    {
    }

    void redo() final { exchange(); }
    void undo() final { exchange(); }
    /// Merges if both commands replace objects at the same places, or if both change only the clip
    /// windows. Undoing this command then undoes both.
    bool mergeWith(const UndoCommand& next) final;
    const Edit& next() const { return next_; }
    /// Counts all memory of the edit, for a command that is restored without redo().
    void measure();
    const Derivation& derivation() const
    {
        return derivation_;
    } ///< of the edit that redo() applies
    std::size_t bytes() const final { return heapBlock(sizeof *this) + editBytes_; }

private:
    void exchange();

    EditedDocument& document_;
    Edit next_;
    Derivation derivation_;
    std::size_t editBytes_ = 0;
};

/// The edit that calls `change` for each of the objects. Their number and containers stay the same.
/// `change` may add styles to the table.
using ChangeRow = std::function<void(ObjectRow& row, StyleTable& styles)>;
Edit changed(const Document& document, const ObjectRanges& objects, const ChangeRow& change);

} // namespace app
