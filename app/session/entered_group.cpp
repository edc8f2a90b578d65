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

std::vector<ContainerId> EnteredGroup::chainOf(ContainerId group) const
{
    const Containers& tree = session_.now().containers();
    std::vector<ContainerId> chain;
    for (; group != 0 && tree[group].kind == Container::Kind::Group; group = tree.parentOf(group))
        chain.insert(chain.begin(), group);
    return chain;
}

void EnteredGroup::enter(ContainerId group) { set(chainOf(group)); }

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
    std::size_t left = change.everything ? 0 : chain_.size();
    while (left > 0 && !tree.contains(chain_[left - 1]))
        --left;
    chain_ = chainOf(left > 0 ? chain_[left - 1] : 0);
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

#include "moc_entered_group.cpp"
