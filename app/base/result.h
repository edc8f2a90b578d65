// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <utility>

namespace app {

/// A value, or one sentence for the person: what happened, where, and what to do.
template <class T>
struct Result {
    std::optional<T> value;
    QString error;

    static Result of(T v) { return {std::move(v), {}}; }
    static Result failure(QString sentence) { return {std::nullopt, std::move(sentence)}; }
    explicit operator bool() const { return value.has_value(); }
};

} // namespace app
