// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view_history.h"

namespace app {

constexpr long long stay = 700; // milliseconds without a change
constexpr std::size_t most = 200;

void ViewHistory::leave(const View& view, long long now)
{
    if (now - last_ >= stay) {
        before_.push_back(view);
        after_.clear();
        if (before_.size() > most)
            before_.erase(before_.begin());
    }
    last_ = now;
}

static std::optional<View> turn(std::vector<View>& from, std::vector<View>& to, const View& present)
{
    if (from.empty())
        return std::nullopt;
    View view = from.back();
    from.pop_back();
    view.size = present.size;
    to.push_back(present);
    return view;
}

std::optional<View> ViewHistory::back(const View& present)
{
    return turn(before_, after_, present);
}
std::optional<View> ViewHistory::forth(const View& present)
{
    return turn(after_, before_, present);
}

} // namespace app
