// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

#include <span>
#include <string_view>

namespace app {

/// A size of paper that has a name, portrait.
struct NamedPaper {
    std::string_view name;
    Point millimetres;
};

/// A0 to A6, then the sizes of the United States.
std::span<const NamedPaper> namedPapers();

/// The paper of that name, which is not translated; null: unknown.
const NamedPaper* paperNamed(std::string_view name);
/// The paper that the page is as large as, in either direction; null: a size of its own.
const NamedPaper* namedPaperOf(const Page& page);

/// The size of the page on paper in millimetres.
Point millimetresOf(const Page& page);

} // namespace app
