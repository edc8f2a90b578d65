// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/report.h"

#include <QXmlStreamReader>

namespace app::svg {

/// Reads the names of characters in HTML, such as &nbsp;, where a file does not declare them, and
/// reports them.
class HtmlEntities : public QXmlStreamEntityResolver {
public:
    /// For a reader that reads the file from the line after the first `linesBefore`.
    HtmlEntities(const QXmlStreamReader& xml, qint64 linesBefore, Report& report)
        : xml_(xml), linesBefore_(linesBefore), report_(report)
    {
    }
    QString resolveUndeclaredEntity(const QString& name) override;

private:
    const QXmlStreamReader& xml_;
    qint64 linesBefore_;
    Report& report_;
};

} // namespace app::svg
