// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edited_document.h"
#include "app/document/object_in_hand.h"
#include "app/recovery/leftover.h"

#include <mutex>

namespace app {

/// The work that would be lost if the program ended now. The editing thread updates it; any thread
/// may write it to a file, even while the editing thread is busy.
class UnsavedWork {
public:
    explicit UnsavedWork(const EditedDocument& document) : edited_(document) {}

    /// The document's state apart from the drawing.
    struct Document {
        QString file; ///< the file to write
        Origin origin;
        QString sample;       ///< key of the sample that it was opened from; empty: none
        bool changed = false; ///< since the last save
        std::optional<ObjectInHand> inHand{}; ///< the object being drawn or edited
    };
    void tell(Document document);

    bool unsaved() const; ///< whether there is any
    /// Writes unsaved work, if any, to the document's file.
    struct Written {
        bool unsaved = false;
        std::optional<QString> error{};
    };
    Written write() const;

private:
    bool unsaved(const app::Document& document) const;

    const EditedDocument& edited_;
    Document document_;
    mutable std::mutex lock_;
};

} // namespace app
