// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <memory>
#include <optional>

class QWidget;

namespace ui {

/// Runs `work` on a thread of its own while the window stays alive; after half a second a dialog
/// says `label` and can cancel. False: cancelled; `work` is then left to end unseen, so everything
/// it touches must belong to it.
bool runInBackground(QWidget* parent, const QString& label, std::function<void()> work);

/// The same for a pure function; nothing if cancelled.
template <class Work>
auto inBackground(QWidget* parent, const QString& label, Work work)
    -> std::optional<decltype(work())>
{
    auto result = std::make_shared<std::optional<decltype(work())>>();
    if (!runInBackground(parent, label, [result, work = std::move(work)] { *result = work(); }))
        return std::nullopt;
    return std::move(*result);
}

} // namespace ui
