// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/selection_memory.h"

#include "app/document/editable.h"
#include "app/session/session.h"

#include <algorithm>
#include <utility>

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
    if (!std::exchange(changing_, true))
        before_ = selected_;
    replaces_ =
        std::ranges::any_of(change.splices, [](const Splice& s) { return s.removed != s.added; });
}

// The history does not count the step yet.
void SelectionMemory::pushed(bool joined)
{
    if (!joined) {
        steps_.resize(std::size_t(session_.history.index()));
        steps_.push_back({replaces_ ? std::move(before_) : ObjectRanges(), {}, replaces_});
        index_ = int(steps_.size());
    }
    changing_ = false;
}

void SelectionMemory::go(int index)
{
    const int from = std::exchange(index_, index);
    if (!std::exchange(changing_, false) || from == index)
        return;
    steps_.resize(std::size_t(session_.history.count()));
    const auto remembers = [](const Step& step) { return step.remembers; };
    const auto first = steps_.begin() + std::min(from, index);
    const auto end = steps_.begin() + std::max(from, index);
    if (!std::any_of(first, end, remembers))
        return;
    if (index < from)
        std::prev(end)->after = std::move(before_);
    const ObjectRanges& kept = index < from ? first->before : std::prev(end)->after;
    if (index < from ? first->remembers : std::prev(end)->remembers)
        session_.select(common(kept, editableObjects(session_.now())));
}

} // namespace app
