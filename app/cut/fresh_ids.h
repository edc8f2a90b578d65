// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QSet>

#include <optional>

namespace app {

/// The ids of all objects, layers and groups that have one.
QSet<QString> idsOf(const Document& document);

/// Ids for the further pieces of objects that a cut divides: "wall-2", "wall-3", none of which is
/// taken already.
class FreshIds {
public:
    /// The ids of the document are taken. They are read at the first call: most cuts need none.
    explicit FreshIds(const Document& document) : document_(&document) {}
    explicit FreshIds(QSet<QString> taken) : taken_(std::move(taken)) {}

    /// Empty if `id` is: an object without an id does not get one.
    QString next(const QString& id);

private:
    const Document* document_ = nullptr;
    std::optional<QSet<QString>> taken_{};
};

/// The container tree with a new empty layer above all others, and its id. If the document can have
/// no further layer: the tree as it is, and the topmost layer.
std::pair<Containers, ContainerId> withLayerAbove(const Document& document, const QString& name);

} // namespace app
