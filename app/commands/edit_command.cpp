// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/edit_command.h"

#include <algorithm>
#include <new>
#include <utility>

namespace app {
namespace {

// If true, undoing `first` alone has the same result as undoing `second` and then `first`.
bool samePlaces(const Edit& first, const Edit& second)
{
    const auto exchanges = [](const Splice& s) { return s.removed == s.added; };
    return first.splices == second.splices && std::ranges::all_of(first.splices, exchanges)
           && first.windows.has_value() == second.windows.has_value() && !first.containers
           && !second.containers && !first.page && !second.page
           && second.numbers.empty(); // they change no places
}

} // namespace

void EditCommand::exchange()
{
    Edit done = document_.apply(next_);
    std::swap(done, next_); // from here on nothing may fail: the document has changed
    try {
        editBytes_ = next_.bytesNotIn(done);
    } catch (const std::bad_alloc&) {
        editBytes_ = 0; // unknown; without memory, no step should be forgotten for it
    }
}

void EditCommand::measure()
{
    Edit nothing;
    if (next_.containers)
        nothing.containers.emplace();
    if (next_.windows)
        nothing.windows.emplace();
    editBytes_ = next_.bytesNotIn(nothing);
}

bool EditCommand::mergeWith(const UndoCommand& next)
{
    return samePlaces(next_, static_cast<const EditCommand&>(next).next_);
}

Edit changed(const Document& document, const ObjectRanges& objects, const ChangeRow& change)
{
    const Objects& all = document.objects();
    Edit edit;
    edit.objects = all.slice(0, 0);
    StyleTable& styles = edit.objects.styles();
    for (const ObjectRange& range : objects.ranges()) {
        const auto count = std::uint32_t(range.size());
        edit.splices.push_back({std::uint32_t(range.first), count, count});
        all.forEach(range.first, range.size(), [&](std::size_t, const ObjectView& object) {
            ObjectRow row = object.row();
            change(row, styles);
            edit.objects.append(row);
        });
    }
    return edit;
}

} // namespace app
