// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <string_view>

namespace app {

/// A kind of undoable change: a row of the catalogue (app/commands/catalogue.h).
struct CommandKind {
    std::string_view key;     ///< for programs: "move-objects"
    std::string_view summary; ///< what it does, for those who read a log: "Moves objects"
};

/// Whether a command may join the step before it: repeated keys, and steps of a spin box, that
/// follow each other quickly are one step to undo.
enum class Merging : std::uint8_t { Never, WithLast };

/// One change of the document that can be undone. It is made in the state that it changes, and done
/// and undone in turn, starting with redo(); History owns it.
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

    /// Commands with the same key may join; one without a key joins none.
    QString mergeKey() const;
    /// Takes over `next`, which was done after this command and has its key: undoing this one then
    /// undoes both. False if it changes other objects; nothing has happened then.
    virtual bool mergeWith(const UndoCommand& /*next*/) { return false; }

    /// The memory that it keeps at present, itself included.
    virtual std::size_t bytes() const = 0;

private:
    const CommandKind* kind_;
    QString text_;
    Merging merging_;
};

} // namespace app
