// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/report.h"

#include <QByteArray>

#include <set>
#include <string>

namespace app::svg {

/// The text of a file with the names of characters in HTML, such as &nbsp;, as numbers, except
/// those that the file declares itself. Reports each; the lines of the text are numbered from
/// `linesBefore` + 1.
QByteArray withHtmlCharacters(const QByteArray& text,
                              const std::set<std::string, std::less<>>& declared,
                              qint64 linesBefore, Report& report);

} // namespace app::svg
