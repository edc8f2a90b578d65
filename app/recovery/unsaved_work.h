// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edited_document.h"
#include "app/recovery/leftover.h"

namespace app {

/// What would be lost if the program ended now. The thread that edits tells it; any thread may
/// write it, also while the other is busy.
class UnsavedWork {
public:
    explicit UnsavedWork(const EditedDocument& document) : edited_(document) {}

    /// What is known of the document apart from the drawing.
    struct Document {
        QString file; ///< to write it to
        Origin origin;
        QString sample;                ///< the key of the sample that it was; empty: none
        bool changed = false;          ///< since it was saved
        std::optional<ObjectInHand> inHand{}; ///< that is being drawn
    };
    void tell(Document document);

    /// Writes to the document's file what is not saved, if anything is.
    struct Written {
        bool unsaved = false;
        std::optional<QString> error{};
    };
    Written write() const;

private:
    const EditedDocument& edited_;
    Document document_;
    mutable std::mutex lock_;
};

} // namespace app
