// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/print_job.h"
#include "app/session/live_export.h"
#include "ui/widgets/sheet.h"

namespace ui {

class AreaSection;
class ExportPreview;
class Files;
class LookLabel;
class PrintSection;

/// The sheet *Print*: what, on which paper, on how many sheets, always at its true size; on a
/// printer or into a PDF file. The preview shows the sheets.
class PrintSheet : public Sheet {
    Q_OBJECT

public:
    PrintSheet(app::Session& session, Files& files);
    void choose(const app::ExportArea& area);

    ExportPreview& shown() { return *preview_; }
    app::LiveExport& live() { return *live_; }

signals:
    void summed(const QString& summary); ///< "6 sheets"

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addResult();
    void addButtons();
    void begin();
    void follow();
    app::PrintChoice choice() const;
    void print();
    void printToFile();

    app::Session& session_;
    Files& files_;
    std::shared_ptr<app::LiveExport> live_;
    ExportPreview* preview_;
    AreaSection* area_;
    PrintSection* paper_;
    LookLabel *sheets_, *error_;
    QPushButton *print_, *toFile_;
};

} // namespace ui
