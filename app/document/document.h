// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edit.h"

#include <QString>

namespace app {

/// What a file says about itself: title, author, licence and so on. XML as in the file, with every
/// prefix declared; empty where the file says nothing.
struct About {
    QString id;          ///< plain text: the id of the root element
    QString comments;    ///< <!-- … --> before and after the root element, often the licence
    QString title;       ///< the <title> elements of the root
    QString description; ///< the <desc> elements of the root
    QString metadata;    ///< the <metadata> elements of the root, except Clearcut's own
    friend bool operator==(const About&, const About&) = default;
};

/// All parts of a document.
struct DocumentParts {
    Page page{};
    About about{};
    Objects objects{};
    Containers containers{}; ///< covers all objects
    ClipWindows windows{};
    friend bool operator==(const DocumentParts&, const DocumentParts&) = default;
};

/// A whole drawing as a value. A copy shares the contents, so it is a snapshot, made in O(1), that
/// any thread may read while the original is edited. A moved-from document may only be assigned to
/// or destroyed.
class Document {
public:
    Document() = default; ///< one empty layer on the usual page, no clip windows
    explicit Document(DocumentParts parts);

    const Page& page() const { return parts_->page; }
    const About& about() const { return parts_->about; }
    const Objects& objects() const { return parts_->objects; }
    const Containers& containers() const { return parts_->containers; }
    const ClipWindows& windows() const { return parts_->windows; }
    const StyleTable& styles() const { return objects().styles(); }

    /// Whether the object and all containers around it are visible. O(depth + log objects); loops
    /// over all objects use `Containers::hiddenRanges` instead.
    bool shown(std::size_t object) const;
    /// Whether the object can be picked and edited: it is shown, and no container around it is
    /// locked.
    bool editable(std::size_t object) const;

    /// Changes the document; there is no other way to do so. Returns the edit that undoes the
    /// change: after both edits the document equals its former value, except that ids of undone
    /// containers are not reused. Costs a list of 12 bytes for each block of objects, plus the
    /// blocks that change; other owners and their blocks do not change.
    Edit apply(const Edit& edit);

    /// Whether both share the same contents, not just equal ones.
    friend bool sameAddress(const Document& a, const Document& b)
    {
        return sameAddress(a.parts_, b.parts_);
    }
    friend bool operator==(const Document&, const Document&) = default;

private:
    Shared<DocumentParts> parts_;
};

/// The document with its own copy of the style table, for edits that are discarded: the styles that
/// they add are discarded too. Shares the objects. O(styles).
Document withOwnStyles(const Document& document);

/// An object that is being drawn or copied, and its future container.
struct PendingObject {
    Object object;
    ContainerId into;
};

/// An edit that adds objects to a container, on top of its content.
Edit adding(const Document& document, const Objects& objects, ContainerId into);
/// An edit that adds each object to its own container; objects of the same container keep their
/// order.
Edit adding(const Document& document, std::span<const PendingObject> objects);

/// A drawing without objects; by default on an A3 sheet.
inline Document newDrawing(const Page& page = {
                               {0, 0}, {420, 297}, {420, Unit::Mm}, {297, Unit::Mm}})
{
    Document document;
    document.apply({.page = page});
    return document;
}

} // namespace app
