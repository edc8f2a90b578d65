// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>
#include <string>
#include <string_view>

// Attributes as they are written: ` name="value"`, appended to a text.

namespace app::svg {

/// Characters that XML cannot hold at all are left out.
std::string escaped(const QString& text);

/// The same for what stands between tags, where line ends and quotes are themselves.
std::string escapedContent(const QString& text);

/// `value` is escaped already.
void appendAttribute(std::string& text, std::string_view name, std::string_view value);
void appendAttribute(std::string& text, std::string_view name, double value);
void appendAttribute(std::string& text, std::string_view name, std::span<const double> values);

} // namespace app::svg
