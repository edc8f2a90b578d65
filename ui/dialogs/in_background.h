// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <memory>
#include <optional>

class QWidget;

namespace ui {

/// Runs `work` on a thread of its own without blocking the window; after 0.5 s a dialog shows
/// `label` and a Cancel button. False: cancelled; `work` then keeps running unseen, so it must own
/// everything it uses.
bool runInBackground(QWidget* parent, const QString& label, std::function<void()> work);

/// The same for a pure function; returns its result, or nothing if cancelled.
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
