// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/print_section.h"

#include "app/base/numbers.h"
#include "app/document/paper.h"
#include "app/tiles/sheet_settings.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/tool_list.h"

#include <QCheckBox>
#include <QSettings>
#include <QSpinBox>

namespace ui {

namespace {

constexpr const char* lastPaper = "print/paper";
constexpr int mostMargin = 100, mostOverlap = 200; // millimetres

QSpinBox* millimetres(const QString& name, const char* key, int most, double now)
{
    auto* field = new QSpinBox;
    field->setAccessibleName(name);
    field->setObjectName(QString::fromLatin1(key));
    field->setRange(0, most);
    field->setValue(int(now));
    field->setFixedSize(64, space::fieldHeight);
    return field;
}

QString firstPaper(const app::Page& page)
{
    const QString last = QSettings().value(lastPaper).toString();
    if (app::papers().contains(last))
        return last;
    const app::NamedPaper* own = app::namedPaperOf(page);
    return own ? app::latin(own->name) : QStringLiteral("A4");
}

} // namespace

PrintSection::PrintSection(const app::Page& page, QWidget* parent)
    : ExportSection(Text::tr("Paper"), parent), paper_(new ToolList),
      turn_(new Segments(Text::tr("Orientation"),
                         {Text::tr("Automatic"), Text::tr("Portrait"), Text::tr("Landscape")})),
      overlap_(millimetres(Text::tr("Overlap of sheets in mm"), "print-overlap", mostOverlap,
                           choice_.overlap)),
      margin_(millimetres(Text::tr("Margin of sheets in mm"), "print-margin", mostMargin,
                          choice_.margin)),
      marks_(new QCheckBox(Text::tr("Marks where sheets fit together")))
{
    paper_->setObjectName(QStringLiteral("print-paper"));
    paper_->setAccessibleName(Text::tr("Size of the paper"));
    paper_->addItems(app::papers());
    paper_->setCurrentText(firstPaper(page));
    turn_->setObjectName(QStringLiteral("print-turn"));
    turn_->setTips(
        {Text::tr("As needs fewer sheets"), Text::tr("Upright"), Text::tr("On its side")});
    turn_->choose(0);
    marks_->setObjectName(QStringLiteral("print-marks"));
    marks_->setChecked(choice_.marks);
    addRow(Text::tr("Size"), {paper_});
    addRow(Text::tr("Orientation"), {turn_});
    ofSeveral_ = {addRow(Text::tr("Overlap"), {overlap_, quietLabel(Text::tr("mm"))}),
                  addRow(Text::tr("Margin"), {margin_, quietLabel(Text::tr("mm"))}),
                  addRow(Text::tr("Marks"), {marks_})};
    connect(paper_, &QComboBox::activated, this, [this] {
        QSettings().setValue(lastPaper, paper_->currentText());
        take();
    });
    connect(turn_, &Segments::picked, this, &PrintSection::take);
    connect(overlap_, &QSpinBox::valueChanged, this, &PrintSection::take);
    connect(margin_, &QSpinBox::valueChanged, this, &PrintSection::take);
    connect(marks_, &QCheckBox::clicked, this, &PrintSection::take);
    take();
}

void PrintSection::take()
{
    choice_.paper = app::paperSize(paper_->currentText()).value_or(choice_.paper);
    choice_.turn = app::PaperTurn(turn_->chosen());
    choice_.overlap = overlap_->value();
    choice_.margin = margin_->value();
    choice_.marks = marks_->isChecked();
    emit changed();
}

void PrintSection::showDivided(bool divided)
{
    for (const Row& row : ofSeveral_)
        row.setVisible(divided);
}

} // namespace ui

#include "moc_print_section.cpp"
