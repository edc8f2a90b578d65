// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_sheets.h"
#include "ui/tiles/section.h"

class QCheckBox;

namespace ui {

/// What is drawn in the margins of the sheets.
class MarksSection : public Section {
    Q_OBJECT

public:
    explicit MarksSection(app::LiveSheets& sheets, QWidget* parent = nullptr);

signals:
    void refused(const QString& sentence);
    void taken();

private:
    void add(const QString& text, const char* name, bool app::SheetMarks::*member);
    void follow();

    app::LiveSheets& sheets_;
    std::vector<std::pair<QCheckBox*, bool app::SheetMarks::*>> boxes_;
};

} // namespace ui
