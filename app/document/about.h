// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// What a file says about itself: title, author, licence … It is kept as the file has it: XML in
/// which every prefix is declared; "" where the file says nothing.
struct About {
    QString id;          ///< plain text: the root's
    QString comments;    ///< <!-- … --> before and after the root, where licences often stand
    QString title;       ///< the root's <title> elements
    QString description; ///< its <desc> elements
    QString metadata;    ///< its <metadata> elements, apart from Clearcut's own
    friend bool operator==(const About&, const About&) = default;
};

} // namespace app
