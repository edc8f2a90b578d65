// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

#include <QUrl>

namespace app {

/// What a link in a page says is to be looked at through the microscope, y up:
/// `clearcut:trace?a=KEY&line=X1,Y1,X2,Y2&w=XMIN,YMIN,XMAX,YMAX`, as on the command line; KEY is
/// that of an algorithm, with `:published` for the printed form. Nothing: it says something else.
std::optional<Specimen> specimenOf(const QUrl& link);

/// Such a link, bit for bit. Nothing where a number is none, and for an exhibit, which has no
/// steps.
std::optional<QString> traceLink(const Specimen& specimen);

} // namespace app
