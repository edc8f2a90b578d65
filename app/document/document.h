// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/about.h"
#include "app/document/edit.h"

namespace app {

/// All that a document consists of.
struct DocumentParts {
    Page page{};
    About about{};
    Objects objects{};
    Containers containers{}; ///< spans all objects
    ClipWindows windows{};
    friend bool operator==(const DocumentParts&, const DocumentParts&) = default;
};

/// A whole drawing as a value. A copy is one more owner, so a snapshot is a copy: made in O(1), and
/// any thread may read it while the document that it was taken from is edited. One that was moved
/// from may only be assigned to or destroyed.
class Document {
public:
    Document() = default; ///< an empty layer on the usual page, without clip windows
    explicit Document(DocumentParts parts);

    const Page& page() const { return parts_->page; }
    const About& about() const { return parts_->about; }
    const Objects& objects() const { return parts_->objects; }
    const Containers& containers() const { return parts_->containers; }
    const ClipWindows& windows() const { return parts_->windows; }
    const StyleTable& styles() const { return objects().styles(); }

    /// Whether neither the object nor a container around it is hidden. O(depth + log objects);
    /// loops over all objects go by `Containers::hiddenRanges`.
    bool shown(std::size_t object) const;
    /// Whether it can be picked and edited: it is shown, and no container around it is locked.
    bool editable(std::size_t object) const;

    /// The only way to change a document. Gives the edit that undoes it: after both, the document
    /// equals what it was, but ids of containers that were undone are not given again. Costs a list
    /// of 12 bytes a block of objects, and the blocks touched; other owners, and the blocks that
    /// they have, are left as they are.
    Edit apply(const Edit& edit);

    /// They have the same contents, not just equal ones.
    friend bool sameAddress(const Document& a, const Document& b)
    {
        return sameAddress(a.parts_, b.parts_);
    }
    friend bool operator==(const Document&, const Document&) = default;

private:
    Shared<DocumentParts> parts_;
};

/// The same document with a table of styles of its own, for edits that are thrown away: the styles
/// that they add go with it. Shares the objects. O(styles).
Document withOwnStyles(const Document& document);

/// An object that is being drawn or copied, and the container that it will go to.
struct ObjectInHand {
    Object object;
    ContainerId into;
};

/// Objects that come to a container, above all that is in it.
Edit adding(const Document& document, const Objects& objects, ContainerId into);
/// Objects that come each to its container; those of one container in their order.
Edit adding(const Document& document, std::span<const ObjectInHand> objects);

} // namespace app
