// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_page_parts.h"

#include "app/base/text.h"
#include "app/commands/set_style.h"

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

static Edit withPage(const Document& document, const Page& page,
                     std::optional<Containers> containers)
{
    const double factor = document.page().millimetresPerUnit() / page.millimetresPerUnit();
    const ObjectRanges all(ObjectRange{0, document.objects().size()});
    Edit edit;
    if (factor != 1 && !document.objects().empty())
        edit = changed(document, all,
                       StyleChanges([factor](Style& style) { scaleStroke(style, factor); }));
    edit.page = page;
    edit.containers = std::move(containers);
    return edit;
}

ChangePage::ChangePage(EditedDocument& document, const Page& page,
                       std::optional<Containers> containers)
    : EditCommand(row, document, withPage(document.now(), page, std::move(containers)),
                  Text::tr("Change page"), Merging::Never, {Derivation::How::Restyled})
{
}

} // namespace app
