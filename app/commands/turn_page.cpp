// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/turn_page.h"

#include <QCoreApplication>

#include <utility>

namespace app {
namespace {

Edit turned(Page page)
{
    std::swap(page.size.x, page.size.y);
    std::swap(page.width, page.height);
    Edit edit;
    edit.page = page;
    return edit;
}

} // namespace

TurnPage::TurnPage(EditedDocument& document)
    : EditCommand(row, document, turned(document.now().page()),
                  QCoreApplication::translate("Commands", "Turn page"))
{
}

} // namespace app
