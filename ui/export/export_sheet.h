// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_export.h"
#include "ui/widgets/sheet.h"

class QLineEdit;

namespace ui {

class AreaSection;
class ExportPreview;
class Files;
class FormatTiles;
class LookLabel;
class OptionsSection;
class ResultSection;

/// The sheet *Export*: format, area, what the format can do, and what would be written; the file at
/// the foot. The preview stands in place of the drawing.
class ExportSheet : public Sheet {
    Q_OBJECT

public:
    ExportSheet(app::Session& session, Files& files);

    ExportPreview& shown() { return *preview_; }
    app::LiveExport& live() { return *live_; }

signals:
    void summed(const QString& summary); ///< "PNG, 941 paths"
    void printWanted(const app::ExportArea& area);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addFile();
    void addButtons();
    void begin();
    void propose(const QString& path);
    void follow();
    void takeFormat(const app::Format& format);
    void chooseFile();
    void showFile();
    QString path() const; ///< absolute, with the ending of the format
    void write();

    app::Session& session_;
    Files& files_;
    std::shared_ptr<app::LiveExport> live_;
    ExportPreview* preview_;
    FormatTiles* formats_;
    AreaSection* area_;
    OptionsSection* options_;
    ResultSection* result_;
    QLineEdit* file_;
    LookLabel* remark_;
    QPushButton *copy_, *export_;
    QString proposed_;        ///< the name that the sheet gave the file
    app::ExportArea named_{}; ///< what it says
};

} // namespace ui
