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

/// All objects with strokes of another width. Most blocks hold nothing but lines, which are copied
/// without a row for each.
static Objects restroked(const Objects& objects, double factor)
{
    Objects made = objects.slice(0, 0);
    StyleTable& styles = made.styles();
    StyleChanges change([factor](Style& style) { scaleStroke(style, factor); });
    for (std::size_t number = 0; number < objects.blocks().size(); ++number) {
        const ObjectBlock& block = *objects.blocks()[number];
        const std::size_t first = objects.firstOf(number);
        if (!block.paths.empty() || !block.hidden.empty() || !block.particulars.empty()) {
            objects.forEach(first, block.size(), [&](std::size_t, const ObjectView& object) {
                ObjectRow row = object.row();
                change(row, styles);
                made.append(row);
            });
            continue;
        }
        ObjectRow row = objects[first].row();
        StyleIndex last = row.style.index();
        change(row, styles);
        for (std::size_t i = 0; i < block.size(); ++i) {
            if (block.style(i) != last) {
                last = block.style(i);
                row.style = styles.entry(last);
                change(row, styles);
            }
            made.appendLine(block.lines[i], row.style);
        }
    }
    return made;
}

static Edit withPage(const Document& document, const Page& page,
                     std::optional<Containers> containers)
{
    const double factor = document.page().millimetresPerUnit() / page.millimetresPerUnit();
    const auto all = std::uint32_t(document.objects().size());
    Edit edit;
    if (factor != 1 && all > 0) {
        edit.splices = {{0, all, all}};
        edit.objects = restroked(document.objects(), factor);
    }
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
