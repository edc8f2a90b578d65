// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/exhibits/exhibit.h"
#include "app/comparison/ulps.h"

namespace app {

/// What can be compared: one form of an algorithm, which it has, or an exhibit.
struct Clipper {
    const clipping::Algorithm* algorithm = nullptr;  ///< of an exhibit: what it was meant to be
    clipping::Form form = clipping::Form::Corrected; ///< of an exhibit: published
    const Exhibit* exhibit = nullptr;

    friend bool operator==(const Clipper&, const Clipper&) = default;
};

/// All there are, in menu order: the forms of each row, then the exhibits.
std::vector<Clipper> clippers();
Clipper exactClipper();

/// "exact", "MD", "KWC as published", "MD with Step 2 as printed".
QString nameOf(const Clipper& clipper);
/// "KWC  Kodituwakku-Wijeweera-Chamikara, as published".
QString titleOf(const Clipper& clipper);

/// For files and the command line: "matthes-drakopoulos", "skala:published", "md-step-2".
QString keyOf(const Clipper& clipper);
/// By such a key; abbreviations in any case do as well. Nothing: there is no such algorithm, form
/// or exhibit.
std::optional<Clipper> findClipper(const QString& key);

/// As in `clipping::Uses`.
std::size_t clipAll(const Clipper& clipper, std::span<const clipping::Segment> in,
                    const clipping::Window& window, std::span<clipping::Clipped> out);
/// All that it leaves, in the order of the lines.
std::vector<clipping::Clipped> clipped(const Clipper& clipper,
                                       std::span<const clipping::Segment> in,
                                       const clipping::Window& window);
std::optional<clipping::Segment> clipped(const Clipper& clipper, const clipping::Segment& line,
                                         const clipping::Window& window);

/// Only corrected forms promise that a piece runs the way its line does.
Ends endsOf(const Clipper& one, const Clipper& other);

/// What the contract lets both be off together; a published form is held to its row's. An exhibit
/// too.
double contractUlps(const Clipper& one, const Clipper& other);

} // namespace app
