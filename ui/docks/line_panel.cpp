// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/line_panel.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/comparison/line_class.h"
#include "app/session/window_in_hand.h"
#include "app/view/ruler.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QFontDatabase>
#include <QVBoxLayout>

namespace ui {

namespace {

enum Column { Name, XColumn, YColumn, RegionColumn, AfterColumn };
constexpr int leastSteps = 4; // lines of text
enum Row { Verdict, Header, From, To, VisibleA, VisibleB, Cost };

} // namespace

LinePanel::LinePanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), table_(new QWidget), grid_(new QGridLayout(table_)),
      verdict_(new QLabel), cost_(new QLabel), steps_(new QPlainTextEdit),
      microscope_(new QPushButton(icon("microscope"), Text::tr("Open microscope")))
{
    grid_->setContentsMargins(space::dockMargin, 6, space::dockMargin, 0);
    grid_->setHorizontalSpacing(space::labelToField + 2);
    grid_->setVerticalSpacing(3);
    grid_->setColumnStretch(AfterColumn, 1);
    for (const int row : {Verdict, Header, From, To, VisibleA, VisibleB})
        grid_->setRowMinimumHeight(row, fontMetrics().height());
    verdict_->setFont(semiBold(captionFont(font())));
    verdict_->setForegroundRole(QPalette::Link);
    verdict_->setWordWrap(true);
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid_->addWidget(verdict_, Verdict, Name, 1, 5);
    cost_->setFont(captionFont(font()));
    cost_->setAlignment(Qt::AlignRight | Qt::AlignTop);
    // Two lines, because the text may wrap.
    cost_->setMinimumHeight(2 * QFontMetrics(cost_->font()).lineSpacing());
    cost_->setWordWrap(true);
    grid_->addWidget(cost_, Cost, XColumn, 1, 4);
    steps_->setReadOnly(true);
    steps_->setFrameShape(QFrame::NoFrame);
    steps_->setFont(captionFont(font()));
    steps_->setAccessibleName(Text::tr("Steps"));
    steps_->setMinimumHeight(QFontMetrics(steps_->font()).lineSpacing() + 10);
    QPalette quiet = steps_->palette();
    quiet.setColor(QPalette::Base, Qt::transparent);
    steps_->setPalette(quiet);
    microscope_->setIconSize({16, 16});
    setKeyTip(*microscope_, Text::tr("Show how this line is clipped, step by step ({microscope})"));
    connect(microscope_, &QPushButton::clicked, this, &LinePanel::microscopeWanted);
    auto* looking = new QHBoxLayout;
    looking->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    looking->addWidget(microscope_);
    looking->addStretch();
    auto* ofLine = new QWidget;
    auto* column = new QVBoxLayout(ofLine);
    column->setContentsMargins(0, 0, 0, space::labelToField);
    column->setSpacing(6);
    column->addWidget(table_);
    column->addLayout(looking);
    auto* steps = new QHBoxLayout; // the text's own margin is 4
    steps->setContentsMargins(space::dockMargin - 4, 0, 0, 0);
    steps->addWidget(steps_);
    column->addLayout(steps, 1);
    column->addStretch();
    // One above the other, so that the panel needs the same height with and without a line.
    pages_ = new QStackedLayout(this);
    pages_->addWidget(madeNothing());
    pages_->addWidget(ofLine);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);

    soon_.setSingleShot(true);
    soon_.setInterval(30);
    connect(&soon_, &QTimer::timeout, this, &LinePanel::show);
    const auto later = [this] {
        if (!soon_.isActive())
            soon_.start();
    };
    connect(&session, &app::Session::inspectedChanged, this, later);
    connect(&session, &app::Session::displayChanged, this, later);
    connect(&session, &app::Session::previewChanged, this, later);
    connect(&session.scene, &app::Scene::outdated, this, later);
    connect(&session.differences, &app::LiveDifferences::changed, this, later);
    show();
}

/// What to do without a line.
QWidget* LinePanel::madeNothing()
{
    auto* nothing = new QWidget;
    auto* words = new QLabel(Text::tr("Click a line to see how it is clipped."));
    words->setForegroundRole(QPalette::PlaceholderText);
    words->setWordWrap(true);
    auto* lessons = new QPushButton(icon("book"), Text::tr("Lessons"));
    lessons->setObjectName(QStringLiteral("panel-lessons"));
    lessons->setIconSize({16, 16});
    setKeyTip(*lessons, Text::tr("Short lessons about clipping, with questions ({lessons})"));
    connect(lessons, &QPushButton::clicked, this, &LinePanel::lessonsWanted);
    auto* column = new QVBoxLayout(nothing);
    column->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin, 0);
    column->setSpacing(space::labelToField);
    column->addWidget(words);
    column->addWidget(lessons, 0, Qt::AlignLeft);
    column->addStretch();
    return nothing;
}

QSize LinePanel::minimumSizeHint() const
{
    const int lines = Cost + 2 + leastSteps; // the verdict may need two, and the cost
    return {QWidget::minimumSizeHint().width(),
            lines * (fontMetrics().lineSpacing() + 3) + microscope_->sizeHint().height() + 24};
}

void LinePanel::showNow()
{
    if (!soon_.isActive())
        return;
    soon_.stop();
    show();
}

void LinePanel::show()
{
    const auto inspected = session_.inspected();
    const bool some = inspected && *inspected < session_.scene.lines().size();
    pages_->setCurrentIndex(some ? 1 : 0);
    if (some)
        showLine(app::inspect(session_, *inspected));
    else
        emit titled(Text::tr("Line"), {});
}

void LinePanel::showLine(const app::Inspection& line)
{
    const app::Page& page = session_.now().page();
    const double size = page.realMillimetresPerUnit();
    const app::Unit unit = session_.display().unit;
    const app::Point origin = app::originOf(page, unit);
    const auto number = [&](double length) { return app::lengthNumber(length, unit, size, 1); };
    const app::Containers& containers = session_.now().containers();
    const QString layer = containers[containers.layerOf(line.object)].name;

    const auto point = [&](int row, const app::Point& p) {
        put(row, XColumn, number(p.x - origin.x), Qt::AlignRight);
        put(row, YColumn, number(p.y - origin.y), Qt::AlignRight);
    };
    const auto end = [&](int row, const QString& name, const app::Point& p, unsigned code,
                         const app::Point* after) {
        put(row, Name, name);
        point(row, p);
        put(row, RegionColumn,
            Text::tr("%1 (%2)").arg(app::regionText(code, app::YAxis::Down),
                                    app::outcodeText(code)));
        put(row, AfterColumn,
            !after        ? Text::tr("gone")
            : *after == p ? Text::tr("kept")
                          : Text::tr("cut"));
    };
    const QString suffix = app::latin(app::infoOf(unit).suffix);
    const auto inUnit = [&](const QString& name) {
        return suffix.isEmpty() ? name : Text::tr("%1 (%2)").arg(name, suffix);
    };
    put(Header, XColumn, inUnit(Text::tr("x")), Qt::AlignRight);
    put(Header, YColumn, inUnit(Text::tr("y")), Qt::AlignRight);
    put(Header, RegionColumn, Text::tr("region"));
    put(Header, AfterColumn, Text::tr("result"));
    end(From, Text::tr("End 1"), line.segment.a, line.fromCode,
        line.visible ? &line.visible->a : nullptr);
    end(To, Text::tr("End 2"), line.segment.b, line.toCode,
        line.visible ? &line.visible->b : nullptr);
    verdict_->setText(app::verdictText(line));
    put(VisibleA, Name, line.visible ? Text::tr("Visible") : QString());
    for (const int row : {VisibleA, VisibleB})
        for (const int column : {XColumn, YColumn, RegionColumn})
            put(row, column, {});
    if (line.visible) {
        point(VisibleA, line.visible->a);
        point(VisibleB, line.visible->b);
    }
    put(VisibleA, RegionColumn, app::classText(line.lineClass));
    put(Cost, Name, Text::tr("Cost"));
    cost_->setText(app::costText(line.cost));
    steps_->setPlainText(app::stepTexts(line, unit, page).join(u'\n'));
    // With several windows it says at which one.
    const QString at = app::tracedWindow(session_).remark();
    const QString in = Text::tr("in %1").arg(layer);
    emit titled(Text::tr("Line %1").arg(app::countText(line.number + 1)),
                at.isEmpty() ? in : Text::tr("%1, %2").arg(in, at));
}

QLabel* LinePanel::cell(int row, int column)
{
    if (auto* item = grid_->itemAtPosition(row, column))
        return static_cast<QLabel*>(item->widget());
    auto* label = new QLabel;
    label->setFont(captionFont(font()));
    if (row == Header || column == AfterColumn)
        label->setForegroundRole(QPalette::PlaceholderText);
    if (row != Header)
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const bool wide = column == RegionColumn && row == VisibleA;
    grid_->addWidget(label, row, column, 1, wide ? 2 : 1);
    return label;
}

void LinePanel::put(int row, int column, const QString& text, Qt::Alignment alignment)
{
    QLabel* label = cell(row, column);
    label->setAlignment(alignment | Qt::AlignVCenter);
    label->setText(text);
    label->setVisible(!text.isEmpty()); // an empty row takes no room
}

} // namespace ui

#include "moc_line_panel.cpp"
