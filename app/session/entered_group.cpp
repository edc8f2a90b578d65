// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/entered_group.h"

#include "app/session/session.h"

#include <algorithm>

namespace app {

EnteredGroup::EnteredGroup(Session& session) : session_(session)
{
    connect(&session.document, &EditedDocument::changed, this, &EnteredGroup::follow);
}

bool EnteredGroup::contains(ContainerId group) const
{
    return std::ranges::find(chain_, group) != chain_.end();
}

void EnteredGroup::enter(ContainerId group)
{
    const Containers& tree = session_.now().containers();
    std::vector<ContainerId> chain;
    for (; group != 0 && tree[group].kind == Container::Kind::Group; group = tree.parentOf(group))
        chain.insert(chain.begin(), group);
    set(std::move(chain));
}

void EnteredGroup::leave()
{
    if (id() != 0)
        enter(session_.now().containers().parentOf(id()));
}

// The group may be gone, for example after undo.
void EnteredGroup::follow(const DocumentChange& change)
{
    if (!change.containers || chain_.empty())
        return;
    const Containers& tree = session_.now().containers();
    while (!change.everything && !chain_.empty() && !tree.contains(chain_.back()))
        chain_.pop_back();
    const ContainerId left = change.everything || chain_.empty() ? 0 : chain_.back();
    chain_.clear();
    enter(left);
    emit changed();
}

void EnteredGroup::set(std::vector<ContainerId> chain)
{
    if (chain == chain_)
        return;
    chain_ = std::move(chain);
    emit changed();
}

} // namespace app
