// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/edited_document.h"

namespace app {

EditedDocument::EditedDocument(Document document, QObject* parent)
    : QObject(parent), document_(std::move(document))
{
}

Document EditedDocument::snapshot() const
{
    const std::lock_guard reading(publishing_);
    return document_;
}

void EditedDocument::publish(Document& next)
{
    const std::lock_guard writing(publishing_);
    std::swap(document_, next);
}

void EditedDocument::load(Document document)
{
    {
        Document next = std::move(document);
        publish(next);
    } // the old document is freed before listeners need memory
    emit changed({true, true, true, true, true});
}

Edit EditedDocument::apply(const Edit& edit)
{
    const std::vector<Splice> splices = edit.splices; // a listener may overwrite `edit`
    DocumentChange change{false, !splices.empty(), edit.containers.has_value(),
                          edit.windows.has_value(), edit.page.has_value()};
    change.splices = splices;
    Edit back;
    {
        Document next = document_;
        back = next.apply(edit);
        publish(next);
    }
    emit changed(change);
    return back;
}

} // namespace app
