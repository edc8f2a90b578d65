// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/shared.h"
#include "app/document/path.h"
#include "app/document/recipe.h"
#include "app/document/style_table.h"

#include <memory>
#include <vector>

namespace app {

struct ClipWindows; // clip_windows.h

/// Areas that hide what is outside of them, outermost first. The windows of one unite.
using KeptClips = std::vector<std::shared_ptr<const ClipWindows>>;

/// Properties that only few objects have.
struct Particulars {
    QString id{};                   ///< the SVG id; unique in a document
    QString title{}, description{}; ///< XML, in the form that About describes
    Recipe recipe{};
    /// Clip paths of an SVG file that were kept instead of cut (ReadOptions::keepsClipPaths): only
    /// SVG files show them, and an edit does not move them.
    KeptClips clips{};
    friend bool operator==(const Particulars&, const Particulars&) = default;
};
/// The empty particulars; shared, so that they use no memory for each object.
const Shared<Particulars>& noParticulars();

/// One path with all its properties, as an independent value: for adding objects to a document and
/// for taking them out.
struct Object {
    Path path;
    Style style;
    Particulars particulars{};
    bool hidden = false; ///< stays hidden and is not exported
    friend bool operator==(const Object&, const Object&) = default;
};

/// An object in nearly the form that a block stores: its style as an entry of a table, its
/// particulars shared. Copying it copies neither. Valid as long as that table.
struct ObjectRow {
    Path path;
    StyleEntry style;
    bool hidden = false;
    Shared<Particulars> particulars = noParticulars();
};

} // namespace app
