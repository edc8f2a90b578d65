// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/container_splicing.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace app {

ContainerSplicing::ContainerSplicing(const ContainerTable& table, std::vector<ContainerMark> marks,
                                     std::size_t end)
    : table_(table), marks_(std::move(marks)), lost_(marks_.size()), at_(marks_.size() - 1),
      start_(end - marks_.back().objects), end_(end), top_(at_)
{
}

void ContainerSplicing::splice(const Splice& s, ContainerId into)
{
    const std::size_t first = s.first;
    if (s.removed > 0) {
        goBelow(first + s.removed);
        const Owner owner = ownerFrom(first);
        if (s.removed == s.added && owner.onlyOne)
            return;
        into = owner.lowest;
    }
    exchange(first, s.removed, s.added, into);
}

void ContainerSplicing::exchange(std::size_t first, std::size_t removed, std::size_t added,
                                 ContainerId into)
{
    goBelow(first + removed);
    for (;; step()) {
        const std::size_t from = std::max(start_, first);
        if (from < end_) {
            marks_[at_].objects -= std::uint32_t(end_ - from);
            lost_[at_] = true;
            end_ = from;
        }
        if (start_ < first || at_ == 0)
            break;
    }
    if (added > 0) {
        for (; ownerOf(marks_[top_]) != into; --top_)
            assert(top_ > at_); // otherwise `into` neither contains nor touches the place
        marks_[top_].objects += std::uint32_t(added);
    }
    changed_ = changed_ || removed + added > 0;
}

// Moves to the mark that keeps the object directly below `object`.
void ContainerSplicing::goBelow(std::size_t object)
{
    for (; at_ > 0 && start_ >= object; step())
        if (start_ < end_)
            top_ = at_;
    if (end_ > object) {
        top_ = at_;
        end_ = object;
    }
}

void ContainerSplicing::step()
{
    --at_;
    end_ = start_;
    start_ -= marks_[at_].objects;
}

ContainerId ContainerSplicing::ownerOf(const ContainerMark& mark) const
{
    return mark.closes ? table_[mark.id].parent : ContainerId(mark.id);
}

// The container of the objects from number `first` up to the current place, and whether it is the
// only one; there must be at least one object.
ContainerSplicing::Owner ContainerSplicing::ownerFrom(std::size_t first) const
{
    Owner owner{ownerOf(marks_[at_])};
    for (std::size_t at = at_, start = start_; start > first;) {
        start -= marks_[--at].objects;
        if (marks_[at].objects > 0 && ownerOf(marks_[at]) != owner.lowest)
            owner = {ownerOf(marks_[at]), false};
    }
    return owner;
}

std::vector<ContainerMark> ContainerSplicing::take(std::vector<ContainerId>& gone) const
{
    struct Open {
        std::size_t at;            // index in `left`
        std::size_t objects, lost; // the objects, and the marks that lost some, before it
    };
    std::vector<ContainerMark> left;
    std::vector<Open> open;
    std::size_t objects = 0, lost = 0;
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        const ContainerMark& mark = marks_[i];
        if (!mark.closes)
            open.push_back({left.size(), objects, lost});
        left.push_back(mark);
        if (mark.closes && !open.empty()) {
            const Open opened = open.back();
            open.pop_back();
            const bool isGroup = table_[mark.id].container->kind == Container::Kind::Group;
            if (isGroup && opened.objects == objects && opened.lost < lost) {
                for (std::size_t k = opened.at; k < left.size(); ++k)
                    if (!left[k].closes)
                        gone.push_back(left[k].id);
                left.resize(opened.at);
                left.back().objects += mark.objects; // these belong to the parent
            }
        }
        objects += mark.objects;
        lost += lost_[i];
    }
    return left;
}

} // namespace app
