// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/comparison/misprints/misprint.h"
#include "app/comparison/ulps.h"

namespace app {

/// All variants, in menu order: the forms of each algorithm, then the known misprints.
std::vector<Variant> variants();
Variant exactVariant();

/// "exact", "MD", "KWC as published", "MD with Step 2 as printed".
QString nameOf(const Variant& variant);
/// "KWC  Kodituwakku-Wijeweera-Chamikara, as published".
QString titleOf(const Variant& variant);

/// For files and the command line: "matthes-drakopoulos", "skala:published", "md-step-2".
QString keyOf(const Variant& variant);
/// Finds a variant by such a key, or by an abbreviation in upper or lower case. Empty if there is
/// no such algorithm, form or known misprint.
std::optional<Variant> findVariant(const QString& key);

/// The variant of a known misprint.
Variant variantOf(const Misprint& misprint);
/// The row of a variant's algorithm; of a known misprint, a row of its own, whose published form it
/// is.
const clipping::Algorithm& rowOf(const Variant& variant);
/// The functions by which the variant clips, counts operations and traces.
const clipping::Functions<clipping::Segment, clipping::Window>& functionsOf(const Variant& variant);

/// As in `clipping::Functions`.
std::size_t clipAll(const Variant& variant, std::span<const clipping::Segment> in,
                    const clipping::Window& window, std::span<clipping::Clipped> out);
/// All visible pieces, in the order of the lines.
std::vector<clipping::Clipped> clipped(const Variant& variant,
                                       std::span<const clipping::Segment> in,
                                       const clipping::Window& window);
std::optional<clipping::Segment> clipped(const Variant& variant, const clipping::Segment& line,
                                         const clipping::Window& window);

/// Only corrected forms promise that a piece has the direction of its line.
Ends endsOf(const Variant& one, const Variant& other);

/// By how many ulps the contracts of both together allow results to differ. A published form or a
/// known misprint is held to the contract of its algorithm.
double contractUlps(const Variant& one, const Variant& other);

} // namespace app
