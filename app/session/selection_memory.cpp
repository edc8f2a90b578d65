// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/selection_memory.h"

#include "app/document/hidden_objects.h"
#include "app/session/session.h"

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace app {

SelectionMemory::SelectionMemory(Session& session) : QObject(&session), session_(session)
{
    connect(&session.document, &EditedDocument::changed, this, &SelectionMemory::follow);
    connect(&session, &Session::selectionChanged, this,
            [this] { selected_ = session_.selection(); });
    connect(&session.history, &History::pushed, this,
            [this](const UndoCommand&, bool joined) { pushed(joined); });
    connect(&session.history, &History::indexChanged, this, &SelectionMemory::go);
    connect(&session.history, &History::forgot, this, [this](int steps) {
        const auto count = std::min(std::size_t(steps), steps_.size());
        steps_.erase(steps_.begin(), steps_.begin() + std::ptrdiff_t(count));
    });
    connect(&session.history, &History::restored, this, [this] { steps_.clear(); });
}

// The session has followed the change, but not said so yet: selected_ is the selection before.
void SelectionMemory::follow(const DocumentChange& change)
{
    if (change.everything)
        return;
    if (change.again) {
        changing_ = false;
        return;
    }
    if (!std::exchange(changing_, true))
        before_ = selected_;
    replaces_ =
        std::ranges::any_of(change.splices, [](const Splice& s) { return s.removed != s.added; });
}

// The history does not count the step yet.
void SelectionMemory::pushed(bool joined)
{
    changing_ = false;
    if (joined)
        return;
    const auto index = std::size_t(session_.history.index());
    index_ = int(index) + 1;
    try {
        steps_.resize(index);
        steps_.push_back({replaces_ ? std::move(before_) : ObjectRanges(), {}, replaces_});
    } catch (const std::bad_alloc&) { // the step is done; what was selected is not worth it
        steps_.clear();
    }
}

void SelectionMemory::go(int index)
{
    const int from = std::exchange(index_, index);
    if (!std::exchange(changing_, false) || from == index)
        return;
    try {
        restore(from, index);
    } catch (const std::bad_alloc&) { // as in pushed()
        steps_.clear();
    }
}

void SelectionMemory::restore(int from, int index)
{
    steps_.resize(std::size_t(session_.history.count()));
    std::vector<Step*> passed; // those that remember: the others leave the selection alone
    for (int i = std::min(from, index); i < std::max(from, index); ++i)
        if (steps_[std::size_t(i)].remembers)
            passed.push_back(&steps_[std::size_t(i)]);
    if (passed.empty())
        return;
    if (index < from) { // as if each step were undone
        passed.back()->after = std::move(before_);
        for (std::size_t i = 1; i < passed.size(); ++i)
            passed[i - 1]->after = passed[i]->before;
    }
    const ObjectRanges& kept = index < from ? passed.front()->before : passed.back()->after;
    session_.select(common(kept, editableObjects(session_.now())));
}

} // namespace app

#include "moc_selection_memory.cpp"
