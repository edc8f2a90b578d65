// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/formats/svg/outline_text.h"

#include <map>

namespace app::svg {

/// The clip paths that objects of a document have kept (Particulars::clips), as elements.
class ClipText {
public:
    /// Appends a <defs> with all clip paths of the document; nothing if there are none.
    void append(std::string& text, const Document& document, const OutlineText& outlines);
    /// Appends the attribute that refers to them.
    void appendReference(std::string& text, const KeptClips& clips) const;

private:
    void define(std::string& text, KeptClips clips, const OutlineText& outlines);

    std::map<KeptClips, std::string> ids_;       ///< of what is inside all of these
    std::map<std::string, std::string> written_; ///< ids by what elements have in them
};

} // namespace app::svg
