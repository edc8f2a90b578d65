// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_page_parts.h"

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

static Page withSheets(Page page, std::optional<PageSheets> sheets)
{
    page.sheets = std::move(sheets);
    return page;
}

SetSheets::SetSheets(EditedDocument& document, std::optional<PageSheets> sheets,
                     const QString& text)
    : EditCommand(row, document, {.page = withSheets(document.now().page(), std::move(sheets))},
                  text)
{
}

} // namespace app
