// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/undo_command.h"

#include <QObject>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace app {

/// The steps to undo and redo, with QUndoStack's function names. Unlike QUndoStack, it merges steps
/// only if they follow each other within a second, and it limits its memory.
class History : public QObject {
    Q_OBJECT

public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// Commands pushed within this time of each other form one step if they can be merged.
    static constexpr std::chrono::milliseconds mergingTime{1000};
    static constexpr std::size_t usualLimit = 1'000'000'000; ///< bytes

    using QObject::QObject;

    /// Executes the command and takes ownership. Discards all undone steps. The command joins the
    /// last step if the two can be merged, unless something happened in between: undo, redo or
    /// save. If memory runs out while it is executed, nothing has changed; later, it is done. The
    /// same holds for each step of undo, redo and setIndex.
    void push(UndoCommand* command);
    void undo();
    void redo();

    int index() const { return index_; }             ///< the number of steps that are done
    int count() const { return int(steps_.size()); } ///< done and undone
    void setIndex(int index);                        ///< undoes or redoes until index() is `index`
    QString text(int step) const;                    ///< step 0 is the oldest; empty if none
    int stepsDone() const { return forgotten_ + index_; } ///< with those that were forgotten
    bool canUndo() const { return index_ > 0; }
    bool canRedo() const { return index_ < count(); }
    QString undoText() const { return canUndo() ? text(index_ - 1) : QString(); }
    QString redoText() const { return canRedo() ? text(index_) : QString(); }

    /// Whether the document is in its state at the last setClean(), or at the start of the history.
    bool isClean() const { return clean_ == index_; }
    void setClean();
    /// setClean() in two parts, for a state that is saved while the history may go on: the state at
    /// beginClean() becomes the clean one at endClean().
    void beginClean();
    void endClean();
    void resetClean(); ///< no step leads back to a clean state any more
    /// Makes the state at that index() the clean one, for a history that is being restored.
    void setCleanIndex(int index);
    /// The index() at which the document is clean; empty: no step leads to a clean state.
    std::optional<int> cleanIndex() const { return clean_; }
    void clear(); ///< forgets all steps, for a new document, which is clean

    const UndoCommand& command(int step) const { return *steps_[std::size_t(step)].command; }
    /// Replaces all steps, for a document that was restored together with them. The first `index`
    /// commands are done: their next call is undo().
    void restore(std::vector<std::unique_ptr<UndoCommand>> commands, int index,
                 std::optional<int> clean);

    /// The memory of all steps. If a new step or a new limit makes it exceed the limit, the oldest
    /// done steps are forgotten. The newest step always stays, whatever its size. Undo forgets no
    /// step.
    std::size_t bytes() const { return bytes_; }
    std::size_t limit() const { return limit_; }
    void setLimit(std::size_t bytes);
    int forgotten() const { return forgotten_; } ///< the number of steps forgotten since clear()

    /// Replaces the clock, for tests.
    void setClock(Clock clock) { clock_ = std::move(clock); }

signals:
    /// The command was just done, before the history counts it; `joined`: it is part of the last
    /// step.
    void pushed(const app::UndoCommand& command, bool joined);
    void restored();          ///< after restore()
    void cleanIndexChanged(); ///< by a save or resetClean(); not by steps, which lead away from it
    /// Before indexChanged, for listeners that must miss nothing. They must not throw.
    void indexSet(int index);
    void indexChanged(int index); ///< after every change of the steps
    void cleanChanged(bool clean);
    void forgot(int steps); ///< the `steps` oldest can no longer be undone

private:
    struct Step {
        std::unique_ptr<UndoCommand> command;
        std::size_t bytes = 0;
    };

    bool mayJoinLast(const UndoCommand& command) const;
    void append(Step step);
    void measure(Step& step);
    void undoOne();
    void redoOne();
    int forgetOldest();
    void notify(bool wasClean, int gone = 0);

    std::vector<Step> steps_;
    int index_ = 0;
    std::optional<int> clean_ = 0; ///< the index at which the document is clean
    std::optional<int> cleanNext_; ///< that index after endClean()
    std::size_t bytes_ = 0, limit_ = usualLimit;
    int forgotten_ = 0;
    Clock clock_ = std::chrono::steady_clock::now;
    std::optional<std::chrono::steady_clock::time_point> lastPush_; ///< empty: nothing merges
};

} // namespace app
