// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_sheets.h"
#include "ui/tiles/section.h"
#include "ui/widgets/look_label.h"

#include <QHash>

#include <functional>

class QDoubleSpinBox;
class QSpinBox;

namespace ui {

class LengthField;
class RefusalFrame;
class Segments;
class ToolList;

/// The paper, how many sheets there are, and how they overlap. A refused value gives its field a
/// red border; the sentence below says why, and the old value stays.
class SheetsSection : public Section {
    Q_OBJECT

public:
    SheetsSection(app::Session& session, app::LiveSheets& sheets, QWidget* parent = nullptr);

    const QString& refusal() const { return refused_; } ///< empty: none
    void say(const QString& sentence);                  ///< why something else was refused
    void withdraw();

signals:
    void entered(); ///< a value was typed: the focus may return to the sheets

private:
    void addPaper();
    void addNumbers();
    void addLengths();
    LengthField* addLength(const QString& name, double app::TilePlan::*member,
                           const QString& remark);
    void change(QWidget* field, const std::function<void(app::SheetSettings&)>& edit);
    void refuse(QWidget* field, const QString& sentence);
    void showRemark();
    void follow();

    app::Session& session_;
    app::LiveSheets& sheets_;
    ToolList* paper_;
    Segments *turn_, *by_;
    QSpinBox *columns_, *rows_;
    LengthField *overlap_, *margin_;
    QDoubleSpinBox* scale_;
    ElidedLabel* size_;
    LookLabel* remark_;
    QString refused_;
    QHash<QWidget*, RefusalFrame*> frames_;
    bool following_ = false;
};

} // namespace ui
