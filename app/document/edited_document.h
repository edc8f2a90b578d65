// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QObject>

#include <mutex>

namespace app {

/// What has changed in a document, so that listeners need not start anew.
struct DocumentChange {
    bool everything = false; ///< it is another document; all below are true then
    bool objects = false, containers = false, windows = false, page = false;
    /// Where objects were exchanged, unless everything changed; valid during the signal.
    std::span<const Splice> splices{};
    /// What is to be seen of the objects may differ, not only the clip windows.
    bool drawing() const { return objects || containers || page; }
};

/// The document that is being edited, by one thread. Only commands and `load` write to it. An edit
/// works on a further owner, which is then published: the lock is held while two pointers are
/// exchanged, never while something is edited, copied or freed, nor while listeners run.
class EditedDocument : public QObject {
    Q_OBJECT

public:
    explicit EditedDocument(Document document = {}, QObject* parent = nullptr);

    const Document& now() const { return document_; } ///< for the thread that edits it
    /// The document as it is, for any thread and for as long as it is kept. O(1); allocates
    /// nothing.
    Document snapshot() const;

    /// Another document altogether (New, Open).
    void load(Document document);
    /// Changes the document, emits `changed` once, and gives the edit that undoes it. If memory
    /// runs out, nothing has changed.
    Edit apply(const Edit& edit);

signals:
    /// The document has changed; `now()` is the new one.
    void changed(const app::DocumentChange& change);

private:
    void publish(Document& next); // exchanges it with document_

    Document document_;
    mutable std::mutex publishing_;
};

} // namespace app
