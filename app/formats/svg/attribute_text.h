// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <span>
#include <string>
#include <string_view>

// Functions that append attributes in the form ` name="value"` to a text.

namespace app::svg {

/// Escapes text for an attribute value. Characters that XML cannot contain are left out.
std::string escaped(const QString& text);

/// Escapes text for element content, where line ends and quotes stay as they are.
std::string escapedContent(const QString& text);

/// `value` must already be escaped.
void appendAttribute(std::string& text, std::string_view name, std::string_view value);
void appendAttribute(std::string& text, std::string_view name, double value);
void appendAttribute(std::string& text, std::string_view name, std::span<const double> values);

} // namespace app::svg
