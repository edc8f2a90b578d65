// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/verdict_list.h"

#include "ui/look/focus_ring.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/icon_sign.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/spoken_role.h"

#include <QEvent>
#include <QScrollBar>
#include <QVBoxLayout>

#include <array>

namespace ui {

namespace {

using Kind = app::RaceStatement::Kind;

constexpr int signSide = 16;
constexpr int ring = 2; // of the focus, around what scrolls
constexpr int lineHeightPercent = 120;

struct Sign {
    Kind kind;
    std::string_view icon; ///< empty: the marker of the algorithm
    QColor Look::*colour;
};
constexpr std::array signs{
    Sign{Kind::Agreement, "tick", &Look::good}, Sign{Kind::Differences, "warning", &Look::differs},
    Sign{Kind::Limits, "window", &Look::text}, Sign{Kind::Ties, "chart", &Look::text},
    Sign{Kind::Untimed, "warning", &Look::muted}};

void showSign(IconSign& sign, const app::RaceStatement& statement)
{
    if (statement.variant)
        return sign.show(markerIcon(*statement.variant));
    const auto* found = std::ranges::find(signs, statement.kind, &Sign::kind);
    sign.show(found->icon, found->colour);
}

QString htmlOf(const app::RaceStatement& statement, const Look& look)
{
    const QString colour =
        statement.kind == Kind::Differences ? "color: " + look.differs.name() : QString();
    return QStringLiteral("<p style='line-height: %1%'><b style='%2'>%3</b> %4</p>")
        .arg(QString::number(lineHeightPercent), colour, statement.first.toHtmlEscaped(),
             statement.rest.toHtmlEscaped());
}

} // namespace

VerdictList::VerdictList(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::dockMargin - ring, space::labelToField - ring,
                               space::dockMargin - ring, space::labelToField - ring);
    column->setSpacing(6);
    column->addStretch();
}

VerdictList::Paragraph VerdictList::added()
{
    const Paragraph made{new QWidget, new IconSign("tick", signSide), new LookLabel};
    made.text->setTextFormat(Qt::RichText);
    made.text->setWordWrap(true);
    made.text->setFont(captionFont(font()));
    made.text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* row = new QHBoxLayout(made.row);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    row->addWidget(made.sign, 0, Qt::AlignTop);
    row->addWidget(made.text, 1);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->insertWidget(column->count() - 1, made.row); // above the stretch
    return made;
}

void VerdictList::show(std::vector<app::RaceStatement> statements)
{
    if (statements == statements_)
        return;
    statements_ = std::move(statements);
    while (paragraphs_.size() < statements_.size())
        paragraphs_.push_back(added());
    paint();
}

void VerdictList::paint()
{
    const Look& look = lookOf(QApplication::palette());
    for (std::size_t i = 0; i < paragraphs_.size(); ++i) {
        const Paragraph& paragraph = paragraphs_[i];
        paragraph.row->setVisible(i < statements_.size());
        if (i >= statements_.size())
            continue;
        showSign(*paragraph.sign, statements_[i]);
        const QString html = htmlOf(statements_[i], look);
        if (html != paragraph.text->text())
            paragraph.text->setText(html);
        paragraph.text->setAccessibleName(
            (statements_[i].first + u' ' + statements_[i].rest).trimmed());
    }
}

QString VerdictList::text() const
{
    QStringList lines;
    for (const app::RaceStatement& one : statements_)
        lines << (one.first + u' ' + one.rest).trimmed();
    return lines.join(u'\n');
}

int VerdictList::lineHeight() const
{
    return QFontMetrics(captionFont(font())).lineSpacing() * lineHeightPercent / 100;
}

void VerdictList::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        paint();
}

VerdictArea::VerdictArea(VerdictList* verdict)
{
    setSpokenRole(*this, QAccessible::Grouping);
    setAccessibleName(Text::tr("Verdict"));
    setFrameShape(QFrame::NoFrame);
    setWidget(verdict);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setViewportMargins(ring, ring, ring, ring);
    // The table above gets its height first.
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
    setMinimumHeight(2 * verdict->lineHeight());
    setFocusPolicy(Qt::NoFocus);
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this,
            [this](int, int most) { setFocusPolicy(most > 0 ? Qt::StrongFocus : Qt::NoFocus); });
}

/// The ring is around the viewport, so that it does not scroll.
bool VerdictArea::event(QEvent* event)
{
    const bool handled = QScrollArea::event(event);
    if (event->type() == QEvent::Paint && hasFocus())
        paintFocusRing(*this);
    return handled;
}

void VerdictArea::focusInEvent(QFocusEvent* event)
{
    QScrollArea::focusInEvent(event);
    update();
}

void VerdictArea::focusOutEvent(QFocusEvent* event)
{
    QScrollArea::focusOutEvent(event);
    update();
}

} // namespace ui

#include "moc_verdict_list.cpp"
