// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_style.h"

namespace app {

void StyleChanges::operator()(ObjectRow& object, StyleTable& styles)
{
    const auto [at, isNew] = known_.try_emplace(object.style.index(), object.style);
    if (isNew) {
        Style style = *object.style;
        change_(style);
        at->second = styles.entryOf(style);
    }
    object.style = at->second;
}

SetStyle::SetStyle(EditedDocument& document, const ObjectRanges& objects,
                   const std::function<void(Style&)>& change, const QString& text, Merging merging)
    : EditCommand(row, document, changed(document.now(), objects, StyleChanges(change)), text,
                  merging, {Derivation::How::Restyled})
{
}

} // namespace app
