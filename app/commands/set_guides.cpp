// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_guides.h"

namespace app {

static Page withGuides(Page page, Guides guides)
{
    page.guides = std::move(guides);
    return page;
}

SetGuides::SetGuides(EditedDocument& document, Guides guides, const QString& text)
    : EditCommand(row, document, {.page = withGuides(document.now().page(), std::move(guides))},
                  text)
{
}

} // namespace app
