// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/object_numbers.h"

#include <QObject>

#include <cstdint>
#include <mutex>
#include <span>

namespace app {

/// What changed in a document, so that listeners can update incrementally.
struct DocumentChange {
    bool everything = false; ///< a different document was loaded; all members below are true too
    /// The document is again as it was before a change that failed. Some listeners may have seen
    /// that change, others not. `objects` to `page` are true too.
    bool again = false;
    bool objects = false, containers = false, windows = false, page = false;
    /// Where objects were replaced; empty if `everything` or `again`. Valid during the signal.
    std::span<const Splice> splices{};
    /// Whether the picture may differ apart from the clip windows.
    bool drawing() const { return objects || containers || page; }
};

/// The document that is edited, by one thread. Only commands and `load` write to it. An edit
/// changes a second copy, which is then published: the lock is held only while two pointers are
/// swapped, not while an edit, a copy, a release of memory or a listener runs.
class EditedDocument : public QObject {
    Q_OBJECT

public:
    explicit EditedDocument(Document document = {}, QObject* parent = nullptr);

    const Document& now() const { return document_; }         ///< for the editing thread only
    const ObjectNumbers& numbers() const { return numbers_; } ///< of its objects, for names
    /// The current document, for any thread; valid as long as the caller keeps it. O(1); allocates
    /// nothing.
    Document snapshot() const;

    /// Replaces the whole document (New, Open). If memory runs out in a listener, the document is
    /// empty: the old one is gone by then.
    void load(Document document);
    /// Changes the document, emits `changed` once, and returns the edit that undoes the change. If
    /// memory runs out, in a listener too, nothing has changed: the document is what it was, and
    /// `changed` says so (`again`).
    Edit apply(const Edit& edit);
    /// Counts the changes that were done, so that one can tell whether anything has changed since.
    std::uint64_t revision() const { return revision_; }

signals:
    /// The document has changed; `now()` is the new document.
    void changed(const app::DocumentChange& change);

private:
    void publish(Document& next); // swaps it with document_
    void takeBack(Document to, ObjectNumbers numbers, const DocumentChange& change) noexcept;
    void sayOwed();

    Document document_;
    ObjectNumbers numbers_;
    std::uint64_t revision_ = 0;
    DocumentChange owed_{}; ///< what some listeners do not know yet, because memory ran out
    mutable std::mutex publishing_;
};

} // namespace app
