// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QObject>

#include <mutex>

namespace app {

/// What changed in a document, so that listeners can update incrementally.
struct DocumentChange {
    bool everything = false; ///< a different document was loaded; all members below are true too
    bool objects = false, containers = false, windows = false, page = false;
    /// Where objects were replaced; empty if `everything`. Valid during the signal.
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

    const Document& now() const { return document_; } ///< for the editing thread only
    /// The current document, for any thread; valid as long as the caller keeps it. O(1); allocates
    /// nothing.
    Document snapshot() const;

    /// Replaces the whole document (New, Open).
    void load(Document document);
    /// Changes the document, emits `changed` once, and returns the edit that undoes the change. If
    /// memory runs out, nothing has changed.
    Edit apply(const Edit& edit);

signals:
    /// The document has changed; `now()` is the new document.
    void changed(const app::DocumentChange& change);

private:
    void publish(Document& next); // swaps it with document_

    Document document_;
    mutable std::mutex publishing_;
};

} // namespace app
