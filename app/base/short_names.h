// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <QStringList>

#include <span>

namespace app {

/// "KWC as published"; "KWC" for a corrected form.
QString shortNameOf(const Variant& variant);

/// The name of all[i] within a list: without its form if all have the same form.
QString nameAmong(std::span<const Variant> all, std::size_t i);

/// "Cohen-Sutherland (CS)"; only "Skala" where there is no shorter name.
QString introducedName(const clipping::Algorithm& algorithm);

/// "CS, LB and MD".
QString listText(const QStringList& names);

/// Like listText(), but a list of more than seven names shows only the first three: "Skala, NLN, CS
/// and 17 others".
QString briefListText(const QStringList& names);

/// "22.30 ns a line".
QString timeText(double nanoseconds);

} // namespace app
