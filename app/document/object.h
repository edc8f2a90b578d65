// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/shared.h"
#include "app/document/path.h"
#include "app/document/recipe.h"
#include "app/document/style_table.h"

namespace app {

/// What few objects have.
struct Particulars {
    QString id{};                   ///< the SVG's; unique in a document
    QString title{}, description{}; ///< as XML, as About keeps them
    Recipe recipe{};
    friend bool operator==(const Particulars&, const Particulars&) = default;
};
/// Those of an object that has none; shared, so that they cost nothing.
const Shared<Particulars>& noParticulars();

/// One path with all that belongs to it, as a value of its own: how objects enter and leave.
struct Object {
    Path path;
    Style style;
    Particulars particulars{};
    bool hidden = false; ///< stays hidden and is not exported
    friend bool operator==(const Object&, const Object&) = default;
};

/// An object as a block holds it: its style by number, its particulars shared. It copies neither.
struct ObjectRow {
    Path path;
    StyleIndex style = 0;
    bool hidden = false;
    Shared<Particulars> particulars = noParticulars();
};

} // namespace app
