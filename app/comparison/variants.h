// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/comparison/exhibits/exhibit.h"
#include "app/comparison/ulps.h"

namespace app {

/// All there are, in menu order: the forms of each row, then the exhibits.
std::vector<Variant> variants();
Variant exactVariant();

/// "exact", "MD", "KWC as published", "MD with Step 2 as printed".
QString nameOf(const Variant& variant);
/// "KWC  Kodituwakku-Wijeweera-Chamikara, as published".
QString titleOf(const Variant& variant);

/// For files and the command line: "matthes-drakopoulos", "skala:published", "md-step-2".
QString keyOf(const Variant& variant);
/// By such a key; abbreviations in any case do as well. Nothing: there is no such algorithm, form
/// or exhibit.
std::optional<Variant> findVariant(const QString& key);

/// As in `clipping::Uses`.
std::size_t clipAll(const Variant& variant, std::span<const clipping::Segment> in,
                    const clipping::Window& window, std::span<clipping::Clipped> out);
/// All that it leaves, in the order of the lines.
std::vector<clipping::Clipped> clipped(const Variant& variant,
                                       std::span<const clipping::Segment> in,
                                       const clipping::Window& window);
std::optional<clipping::Segment> clipped(const Variant& variant, const clipping::Segment& line,
                                         const clipping::Window& window);

/// Only corrected forms promise that a piece runs the way its line does.
Ends endsOf(const Variant& one, const Variant& other);

/// What the contract lets both be off together; a published form is held to its row's. An exhibit
/// too.
double contractUlps(const Variant& one, const Variant& other);

} // namespace app
