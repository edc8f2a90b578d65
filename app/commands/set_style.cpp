// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_style.h"

#include <unordered_map>

namespace app {
namespace {

Edit restyled(const Document& document, const ObjectRanges& objects,
              const std::function<void(Style&)>& change)
{
    std::unordered_map<StyleIndex, StyleIndex> known; // the new style of each old style
    return changed(document, objects, [&](ObjectRow& object, StyleTable& styles) {
        const auto [at, isNew] = known.try_emplace(object.style, 0);
        if (isNew) {
            Style style = styles[object.style];
            change(style);
            at->second = styles.indexOf(style);
        }
        object.style = at->second;
    });
}

} // namespace

SetStyle::SetStyle(EditedDocument& document, const ObjectRanges& objects,
                   const std::function<void(Style&)>& change, const QString& text, Merging merging)
    : EditCommand(row, document, restyled(document.now(), objects, change), text, merging)
{
}

} // namespace app
