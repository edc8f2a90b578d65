// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

} // namespace app
