// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QSet>

namespace app {

/// Ids for the further pieces of objects that a cut divides: "wall-2", "wall-3", none of which the
/// document has already.
class FreshIds {
public:
    explicit FreshIds(const Document& document) : document_(document) {}

    /// Empty if `id` is: an object without an id does not get one.
    QString next(const QString& id);

private:
    const Document& document_;
    bool known_ = false;
    QSet<QString> taken_; ///< read at the first call: most cuts need none
};

} // namespace app
