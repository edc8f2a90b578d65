// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_sheets.h"
#include "ui/tiles/section.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;

namespace ui {

class ElidedLabel;
class RefusalFrame;
class Segments;

/// The files that the sheets are written to.
class FilesSection : public Section {
    Q_OBJECT

public:
    explicit FilesSection(app::LiveSheets& sheets, QWidget* parent = nullptr);
    /// The button that writes the files. It belongs below all sections, where it is always seen.
    QPushButton* exportButton() const { return export_; }

signals:
    void exportWanted();
    void entered(); ///< a name was typed

private:
    void addFormat();
    void addName();
    void change(app::SheetSettings next);
    void takeName();
    void follow();
    void showFiles(const QStringList& files);

    app::LiveSheets& sheets_;
    std::vector<const app::Format*> formats_;
    Segments* format_;
    QRadioButton *each_, *one_;
    QLineEdit* name_;
    RefusalFrame* frame_;
    ElidedLabel* files_;
    QCheckBox *overview_, *empty_;
    QPushButton* export_;
};

} // namespace ui
