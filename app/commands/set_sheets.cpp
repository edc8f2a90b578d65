// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_sheets.h"

namespace app {

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
