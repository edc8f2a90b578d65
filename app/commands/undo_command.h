// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <string_view>

namespace app {

/// A kind of undoable change: a row of the catalogue (app/commands/catalogue.h).
struct CommandKind {
    std::string_view key;     ///< for programs: "move-objects"
    std::string_view summary; ///< what it does, for readers of a log: "Moves objects"
};

/// Whether a command may merge with the step before it: quickly repeated keys, or clicks of a spin
/// box, form one step to undo.
enum class Merging : std::uint8_t { Never, WithLast };

/// One undoable change of the document. It is created in the state that it changes, and then done
/// and undone in turn, starting with redo(). History owns it.
class UndoCommand {
public:
    /// `text` names the step in menus: "Move selection". Not empty.
    UndoCommand(const CommandKind& kind, const QString& text, Merging merging = Merging::Never)
        : kind_(&kind), text_(text), merging_(merging)
    {
    }
    virtual ~UndoCommand() = default;
    UndoCommand(const UndoCommand&) = delete;
    UndoCommand& operator=(const UndoCommand&) = delete;

    virtual void redo() = 0;
    virtual void undo() = 0;

    const CommandKind& kind() const { return *kind_; }
    const QString& text() const { return text_; }

    /// Commands with the same key may merge; a command with an empty key merges with none.
    QString mergeKey() const;
    /// Absorbs `next`, which was done after this command and has its key: undoing this command then
    /// undoes both. Returns false, without any change, if `next` changes other objects.
    virtual bool mergeWith(const UndoCommand& /*next*/) { return false; }

    /// The memory that this command uses at present, itself included.
    virtual std::size_t bytes() const = 0;

private:
    const CommandKind* kind_;
    QString text_;
    Merging merging_;
};

} // namespace app
