// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_export.h"
#include "ui/export/export_section.h"

#include <QTimer>

namespace ui {

class LookLabel;

/// What would be written: paths, drawn length, size, and what the file cannot hold. While it is
/// worked on for more than a tenth of a second, it says so.
class ResultSection : public ExportSection {
    Q_OBJECT

public:
    ResultSection(app::Session& session, app::LiveExport& live, QWidget* parent = nullptr);

    void follow();

private:
    QLabel* addFact(const QString& name, const char* key);
    void showFacts();
    QString realSizeText(const app::ExportFacts& facts) const;
    void showLosses();

    app::Session& session_;
    app::LiveExport& live_;
    QLabel *paths_, *length_, *size_, *pixels_, *file_;
    Row pixelsRow_{};
    LookLabel *losses_, *error_;
    QTimer patience_;
    bool late_ = false;
};

} // namespace ui
