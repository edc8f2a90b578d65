// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/undo_command.h"

#include <QObject>

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace app {

/// The steps that can be undone and redone, with QUndoStack's names. Unlike QUndoStack, it joins
/// steps only if they follow each other within a second, and it limits its memory.
class History : public QObject {
    Q_OBJECT

public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// Two pushes less than this apart are one step if their commands can be merged.
    static constexpr std::chrono::milliseconds mergingTime{1000};
    static constexpr std::size_t usualLimit = 1'000'000'000; ///< bytes

    using QObject::QObject;

    /// Takes the command and does it. What was undone can no longer be redone. The command joins
    /// the last step instead of being one if it can be merged, unless something else came in
    /// between: undoing, redoing, saving, a macro.
    void push(UndoCommand* command);
    void undo();
    void redo();

    /// Until the end of the macro, what is pushed becomes one step, which nothing joins; none if
    /// nothing is pushed. Macros may be nested: the outermost counts. While one is open nothing can
    /// be undone or redone.
    void beginMacro(const QString& text);
    void endMacro();

    int index() const { return index_; }             ///< how many steps are done
    int count() const { return int(steps_.size()); } ///< done and undone
    void setIndex(int index);                        ///< undoes or redoes until so many are done
    QString text(int step) const;                    ///< from 0, the oldest; empty for none
    bool canUndo() const { return macros_ == 0 && index_ > 0; }
    bool canRedo() const { return macros_ == 0 && index_ < count(); }
    QString undoText() const { return canUndo() ? text(index_ - 1) : QString(); }
    QString redoText() const { return canRedo() ? text(index_) : QString(); }

    /// Whether the document is as it was at the last setClean(), or when the history was empty.
    bool isClean() const { return macros_ == 0 && clean_ == index_; }
    void setClean();
    void resetClean(); ///< no step leads to a clean state any more
    void clear();      ///< for another document, which is clean; forgets all steps

    /// The memory of all steps. If a new step, or a new limit, finds it beyond the limit, the oldest
    /// done ones go; the newest stays, however large it is. Undoing lets none go.
    std::size_t bytes() const { return bytes_; }
    std::size_t limit() const { return limit_; }
    void setLimit(std::size_t bytes);
    int forgotten() const { return forgotten_; } ///< how many steps have gone since clear()

    /// For tests: another clock.
    void setClock(Clock clock) { clock_ = std::move(clock); }

signals:
    void indexChanged(int index); ///< after whatever changed the steps
    void cleanChanged(bool clean);
    void forgot(int steps); ///< so many of the oldest can no longer be undone

private:
    struct Step {
        QString text;
        std::vector<std::unique_ptr<UndoCommand>> commands{}; ///< in the order they were done
        std::size_t bytes = 0;
    };

    bool joinsLast(const UndoCommand& command) const;
    void append(Step step);
    void measure(Step& step);
    void undoOne();
    void redoOne();
    int forgetOldest();
    void notify(bool wasClean, int gone = 0);

    std::deque<Step> steps_;
    int index_ = 0;
    std::optional<int> clean_ = 0; ///< the index at which the document is clean
    Step macro_;                   ///< in the making while macros_ > 0
    int macros_ = 0;               ///< open ones, each inside the one before
    std::size_t bytes_ = 0, limit_ = usualLimit;
    int forgotten_ = 0;
    Clock clock_ = std::chrono::steady_clock::now;
    std::optional<std::chrono::steady_clock::time_point> lastPush_; ///< none: nothing joins
};

} // namespace app
