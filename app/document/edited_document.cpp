// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/edited_document.h"

#include <utility>

namespace app {

EditedDocument::EditedDocument(Document document, QObject* parent)
    : QObject(parent), document_(std::move(document)), numbers_(document_.objects().size())
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
    const DocumentChange change{
        .everything = true, .objects = true, .containers = true, .windows = true, .page = true};
    Document empty;
    {
        Document next = std::move(document);
        publish(next);
    } // the old document is freed before listeners need memory
    owed_ = {};
    ++revision_;
    try {
        numbers_ = ObjectNumbers(document_.objects().size());
        emit changed(change);
    } catch (...) {
        takeBack(std::move(empty), {}, change);
        throw;
    }
}

Edit EditedDocument::apply(const Edit& edit)
{
    if (owed_.objects)
        sayOwed();
    const std::vector<Splice> splices = edit.splices; // a listener may overwrite `edit`
    DocumentChange change{.objects = !splices.empty(),
                          .containers = edit.containers.has_value(),
                          .windows = edit.windows.has_value(),
                          .page = edit.page.has_value(),
                          .splices = splices};
    Document before = document_;
    std::optional<ObjectNumbers> numbersBefore; // null: they stay
    Edit back;
    {
        Document next = document_;
        std::optional<ObjectNumbers::Changed> named = numbers_.after(edit);
        back = next.apply(edit);
        if (named) {
            back.numbers = std::move(named->removed);
            numbersBefore = std::exchange(numbers_, std::move(named->numbers));
        }
        publish(next);
    }
    ++revision_;
    try {
        emit changed(change);
    } catch (...) {
        --revision_;
        takeBack(
            std::move(before), std::move(numbersBefore ? *numbersBefore : numbers_),
            {.again = true, .objects = true, .containers = true, .windows = true, .page = true});
        throw;
    }
    return back;
}

void EditedDocument::takeBack(Document to, ObjectNumbers numbers,
                              const DocumentChange& change) noexcept
{
    numbers_ = std::move(numbers);
    publish(to);
    owed_ = change;
    try {
        sayOwed();
    } catch (...) { // said before the next change
    }
}

void EditedDocument::sayOwed()
{
    emit changed(owed_);
    owed_ = {};
}

} // namespace app

#include "moc_edited_document.cpp"
