// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_preview.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/icon_sign.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"

#include <QKeyEvent>
#include <QVBoxLayout>

namespace ui {

ExportPreview::ExportPreview(app::Session& session, std::shared_ptr<app::LiveExport> live,
                             QWidget* parent)
    : QWidget(parent), size_(new Segments(Text::tr("Size on the screen"),
                                          {Text::tr("True size"), Text::tr("Whole")})),
      view_(new ExportView(session, std::move(live)))
{
    setAccessibleName(Text::tr("Preview"));
    auto* title = new QLabel(Text::tr("Preview"));
    title->setFont(semiBold(font()));
    size_->setObjectName(QStringLiteral("export-size-on-screen"));
    size_->setTips({Text::tr("A millimetre on paper is a millimetre on the screen"),
                    Text::tr("All of the paper (double click)")});
    auto* bar = new QWidget;
    bar->setFixedHeight(space::optionsHeight);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    row->setSpacing(space::labelToField);
    for (QWidget* part : std::initializer_list<QWidget*>{new IconSign("export", 18), title, size_})
        row->addWidget(part);
    auto* remark = new ElidedLabel;
    remark->setForegroundRole(QPalette::PlaceholderText);
    remark->setWhole(Text::tr("only what is written is shown"));
    row->addWidget(remark, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar);
    column->addWidget(rule(Qt::Horizontal));
    column->addWidget(view_, 1);
    connect(size_, &Segments::picked, this,
            [this](int chosen) { view_->showAt(ExportView::Size(chosen)); });
    const auto follow = [this] {
        const auto size = view_->sizeShown();
        size ? size_->choose(int(*size)) : size_->chooseNone();
    };
    connect(view_, &ExportView::sizeChanged, this, follow);
    follow();
}

/// What no part took.
void ExportPreview::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        return emit closeWanted();
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        return emit entered();
    QWidget::keyPressEvent(event);
}

} // namespace ui

#include "moc_export_preview.cpp"
