// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace app {
namespace {

// Replaces `value` if there is a new one, and returns the old one.
template <class T>
std::optional<T> exchange(T& value, std::optional<T> by) noexcept
{
    if (!by)
        return std::nullopt;
    std::optional<T> old(std::move(value));
    value = std::move(*by);
    return old;
}

} // namespace

Document::Document(DocumentParts parts) : parts_(std::move(parts))
{
    assert(containers().objects() == objects().size());
    assert(windows().list.size() <= ClipWindows::most);
}

bool Document::shown(std::size_t object) const
{
    return !objects()[object].hidden() && containers().shown(containers().containerOf(object));
}

bool Document::editable(std::size_t object) const
{
    return shown(object) && !containers().locked(containers().containerOf(object));
}

Edit Document::apply(const Edit& edit)
{
    DocumentParts& parts = parts_.own();
    Edit back;
    Edit by{{}, {}, edit.containers, edit.windows, edit.page};
    if (by.containers)
        by.containers->startIdsAt(parts.containers.nextId());
    if (!edit.splices.empty()) {
        back.splices = inverse(edit.splices);
        back.objects = parts.objects.splice(edit.splices, edit.objects);
    }
    // Nothing below can fail.
    back.containers = exchange(parts.containers, std::move(by.containers));
    back.windows = exchange(parts.windows, std::move(by.windows));
    back.page = exchange(parts.page, std::move(by.page));
    assert(parts.containers.objects() == parts.objects.size());
    assert(parts.windows.list.size() <= ClipWindows::most);
    return back;
}

Document withOwnStyles(const Document& document)
{
    Objects objects = document.objects();
    objects.separateStyles();
    return Document({document.page(), document.about(), std::move(objects), document.containers(),
                     document.windows()});
}

Edit adding(const Document& document, const Objects& objects, ContainerId into)
{
    const std::size_t top = document.containers().rangeOf(into).end;
    Edit edit;
    edit.splices = {{std::uint32_t(top), 0, std::uint32_t(objects.size())}};
    edit.objects = objects;
    edit.containers = document.containers().spliced(top, 0, objects.size(), into);
    return edit;
}

Edit adding(const Document& document, std::span<const PendingObject> objects)
{
    const Containers& containers = document.containers();
    std::vector<const PendingObject*> sorted;
    for (const PendingObject& object : objects)
        sorted.push_back(&object);
    std::ranges::stable_sort(sorted, [&](const PendingObject* a, const PendingObject* b) {
        return containers.endsBefore(a->into, b->into);
    });
    Edit edit{.objects = document.objects().slice(0, 0)};
    std::vector<ContainerId> into;
    for (const PendingObject* one : sorted) {
        if (into.empty() || into.back() != one->into) {
            into.push_back(one->into);
            edit.splices.push_back({std::uint32_t(containers.rangeOf(one->into).end), 0, 0});
        }
        ++edit.splices.back().added;
        edit.objects.append(one->object);
    }
    edit.containers = containers.spliced(edit.splices, into);
    return edit;
}

} // namespace app
