// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"

#include <algorithm>

namespace app::svg {

/// Counts the shapes, chords and dashes of a drawing. A large file may have as many as it has
/// bytes, but no small file may grow into one with more than `mostParts`.
class PartCount {
public:
    /// `bytes`: of all attributes of the file.
    PartCount(double tolerance, std::size_t bytes) : tolerance_(tolerance), bytes_(bytes) {}

    /// Throws Refused beyond the limit, and for strokes that are too large.
    void add(const Object& object);
    void remove(const Object& object);
    /// A limit for small files, for this one.
    std::size_t allowed(std::size_t most) const { return std::max(most, bytes_); }

private:
    std::size_t partsOf(const Object& object) const;

    double tolerance_;
    std::size_t bytes_, parts_ = 0;
};

} // namespace app::svg
