// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <QStringList>

#include <span>

namespace app {

/// "KWC as published"; of a corrected form "KWC".
QString shortNameOf(const Variant& variant);

/// The name among others: without its form if all have the same.
QString nameAmong(std::span<const Variant> all, std::size_t i);

/// "Cohen-Sutherland (CS)"; "Skala", whose name is as short as it gets.
QString introducedName(const clipping::Algorithm& algorithm);

/// "CS, LB and MD".
QString listText(const QStringList& names);

/// The same, but of more than seven only the first three: "Skala, NLN, CS and 17 others".
QString briefListText(const QStringList& names);

/// "22.30 ns a line".
QString timeText(double nanoseconds);

} // namespace app
