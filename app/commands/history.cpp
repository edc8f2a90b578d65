// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/history.h"

#include "app/base/memory.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <utility>

namespace app {

// Room for the step is reserved before redo(): when memory runs out, nothing was done yet.
void History::push(UndoCommand* command)
{
    std::unique_ptr<UndoCommand> done(command);
    const auto now = clock_();
    const bool mayJoin = lastPush_ && now - *lastPush_ < mergingTime && mayJoinLast(*done);
    if (steps_.size() == steps_.capacity())
        steps_.reserve(2 * steps_.size() + 1);
    done->redo();
    const bool joins = mayJoin && steps_.back().command->mergeWith(*done);
    lastPush_ = now;
    emit pushed(*done, joins);
    if (joins) {
        measure(steps_.back());
        notify(false, forgetOldest());
    } else {
        append({std::move(done)});
    }
}

// Requires lastPush_ to be set: then the last command pushed is the last of all steps, and done.
bool History::mayJoinLast(const UndoCommand& command) const
{
    const QString key = steps_.back().command->mergeKey();
    return !key.isEmpty() && key == command.mergeKey();
}

void History::append(Step step)
{
    const bool wasClean = isClean();
    while (count() > index_) {
        bytes_ -= steps_.back().bytes;
        steps_.pop_back();
    }
    for (auto* clean : {&clean_, &cleanNext_})
        if (*clean > index_)
            clean->reset(); // that state was undone and can no longer be redone
    steps_.push_back(std::move(step));
    ++index_;
    measure(steps_.back());
    notify(wasClean, forgetOldest());
}

// A command may use different amounts of memory when done and when undone, so each undo and redo
// calls this.
void History::measure(Step& step)
{
    bytes_ -= step.bytes;
    step.bytes = sizeof(Step) + heapBytes(step.command->text()) + step.command->bytes();
    bytes_ += step.bytes;
}

int History::forgetOldest()
{
    int gone = 0;
    for (; bytes_ > limit_ && index_ > 1; --index_, ++gone)
        bytes_ -= steps_[std::size_t(gone)].bytes;
    steps_.erase(steps_.begin(), steps_.begin() + gone);
    for (auto* clean : {&clean_, &cleanNext_})
        if (*clean)
            *clean = **clean >= gone ? std::optional(**clean - gone) : std::nullopt;
    forgotten_ += gone;
    return gone;
}

// Emits each signal, even if a listener of another one throws.
void History::notify(bool wasClean, int gone)
{
    std::exception_ptr failure;
    const auto say = [&failure](const auto& emitSignal) {
        try {
            emitSignal();
        } catch (...) {
            failure = std::current_exception();
        }
    };
    emit indexSet(index_);
    say([&] { emit indexChanged(index_); });
    if (wasClean != isClean())
        say([&] { emit cleanChanged(!wasClean); });
    if (gone > 0)
        say([&] { emit forgot(gone); });
    if (failure)
        std::rethrow_exception(failure);
}

void History::undo() { setIndex(index_ - 1); }

void History::redo() { setIndex(index_ + 1); }

void History::setIndex(int index)
{
    index = std::clamp(index, 0, count());
    if (index == index_)
        return;
    const bool wasClean = isClean();
    lastPush_.reset();
    try {
        while (index_ > index)
            undoOne();
        while (index_ < index)
            redoOne();
    } catch (...) { // the steps up to there are done
        notify(wasClean);
        throw;
    }
    notify(wasClean);
}

void History::undoOne()
{
    Step& step = steps_[std::size_t(index_ - 1)];
    step.command->undo();
    --index_;
    measure(step);
}

void History::redoOne()
{
    Step& step = steps_[std::size_t(index_)];
    step.command->redo();
    ++index_;
    measure(step);
}

QString History::text(int step) const
{
    return step >= 0 && step < count() ? steps_[std::size_t(step)].command->text() : QString();
}

void History::setClean()
{
    beginClean();
    endClean();
}

void History::beginClean()
{
    cleanNext_ = index_;
    lastPush_.reset(); // a command that merged with the last step would lose the saved state
}

void History::endClean()
{
    const bool wasClean = isClean();
    clean_ = std::exchange(cleanNext_, std::nullopt);
    emit cleanIndexChanged();
    if (wasClean != isClean())
        emit cleanChanged(!wasClean);
}

void History::setCleanIndex(int index)
{
    cleanNext_ = index;
    endClean();
}

void History::resetClean()
{
    const bool wasClean = isClean();
    clean_.reset();
    lastPush_.reset();
    emit cleanIndexChanged();
    if (wasClean)
        emit cleanChanged(false);
}

void History::clear()
{
    const bool wasClean = isClean();
    steps_.clear();
    lastPush_.reset();
    index_ = forgotten_ = 0;
    bytes_ = 0;
    clean_ = 0;
    cleanNext_.reset();
    notify(wasClean);
}

void History::restore(std::vector<std::unique_ptr<UndoCommand>> commands, int index,
                      std::optional<int> clean)
{
    assert(index >= 0 && index <= int(commands.size()));
    const bool wasClean = isClean();
    steps_.clear();
    lastPush_.reset();
    cleanNext_.reset();
    bytes_ = 0;
    forgotten_ = 0;
    for (auto& command : commands) {
        steps_.push_back({std::move(command)});
        measure(steps_.back());
    }
    index_ = index;
    clean_ = clean;
    const int gone = forgetOldest();
    emit restored();
    notify(wasClean, gone);
}

void History::setLimit(std::size_t bytes)
{
    const bool wasClean = isClean();
    limit_ = bytes;
    if (const int gone = forgetOldest(); gone > 0)
        notify(wasClean, gone);
}

} // namespace app

#include "moc_history.cpp"
