// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/style_panel.h"

#include "app/document/styles_in_use.h"
#include "app/drawing/dash_patterns.h"
#include "app/session/units.h"
#include "app/view/colour_chart.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/properties/dash_list.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/swatches.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace ui {
namespace {

constexpr int betweenRows = 4;

QLabel* captionFor(QWidget* field, const QString& text)
{
    auto* caption = new QLabel(text);
    caption->setForegroundRole(QPalette::PlaceholderText);
    caption->setBuddy(field);
    return caption;
}

/// Its place stays empty meanwhile, so that nothing below it moves.
void showWithCaption(QWidget& field, bool shown)
{
    for (QLabel* label : field.parentWidget()->findChildren<QLabel*>(Qt::FindDirectChildrenOnly))
        if (label->buddy() == &field)
            label->setVisible(shown);
    field.setVisible(shown);
}

/// For showWithCaption().
void keepPlace(QWidget& field)
{
    QSizePolicy policy = field.sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    field.setSizePolicy(policy);
}

QHBoxLayout* row()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(space::labelToField);
    return row;
}

} // namespace

StylePanel::StylePanel(app::Session& session, Canvas& canvas, QWidget* parent)
    : QWidget(parent), session_(session),
      part_(new Segments(Text::tr("Colour of"), {Text::tr("Stroke"), Text::tr("Fill")})),
      colour_(new ColourChoice(session, canvas, &app::Style::stroke)),
      swatches_(new Swatches(Text::tr("Colours of the drawing"), app::coloursInRow, 1)),
      width_(makeField(Text::tr("Stroke width"), LengthField::Suffix::Unit)), dashes_(new DashList),
      pattern_(new QLineEdit),
      caps_(new Segments(Text::tr("Caps"),
                         {Text::tr("Butt"), Text::tr("Round"), Text::tr("Square")})),
      joins_(new Segments(Text::tr("Joins"),
                          {Text::tr("Miter"), Text::tr("Round"), Text::tr("Bevel")})),
      fillRule_(new Segments(Text::tr("Fill rule"), {Text::tr("Nonzero"), Text::tr("Even-odd")})),
      miterLimit_(makeField(Text::tr("Miter limit"), LengthField::Suffix::None)),
      ofLayer_(new QCheckBox)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                               space::labelToField);
    column->setSpacing(betweenRows);
    column->addLayout(makeColour());
    column->addWidget(swatches_);
    column->addLayout(makeWidth());
    column->addLayout(makePattern());
    column->addLayout(makeCorners());
    column->addLayout(makeFillRule());
    makeLayer();
    column->addWidget(ofLayer_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &StylePanel::follow);
    const auto follow = [this] {
        if (isVisible()) // else showEvent() does it
            soon_.start(0);
    };
    connect(&session, &app::Session::selectionChanged, this, follow);
    connect(&session, &app::Session::displayChanged, this, follow);
    connect(&session.document, &app::EditedDocument::changed, this, follow);
}

void StylePanel::focusFirst()
{
    width_->setFocus(Qt::PopupFocusReason);
    width_->selectAll();
}

LengthField* StylePanel::makeField(const QString& name, LengthField::Suffix suffix)
{
    auto* field = new LengthField(name, LengthField::Range::NotNegative, suffix);
    field->setToolTip(name);
    connect(field, &LengthField::entered, this, &StylePanel::entered);
    connect(field, &LengthField::refused, this, &StylePanel::refused);
    connect(field, &LengthField::taken, this, &StylePanel::taken);
    return field;
}

QLayout* StylePanel::makeColour()
{
    colour_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    colour_->setIconSize({16, 16});
    colour_->setProperty("framed", true);
    colour_->setAutoRaise(false);
    colour_->setFixedHeight(space::fieldHeight);
    colour_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    colour_->setFocusPolicy(Qt::StrongFocus);
    auto* eyedropper = new QToolButton;
    eyedropper->setObjectName(QStringLiteral("eyedropper"));
    eyedropper->setIcon(icon("eyedropper"));
    eyedropper->setAutoRaise(true);
    eyedropper->setFocusPolicy(Qt::StrongFocus);
    eyedropper->setFixedSize(space::fieldHeight, space::fieldHeight);
    setKeyTip(*eyedropper, Text::tr("Take the colour of a line in the drawing ({take-stroke}; for "
                                    "the fill {take-fill})"));
    eyedropper->setAccessibleName(Text::tr("Take the colour of a line in the drawing"));
    connect(part_, &Segments::picked, this, [this](int part) {
        colour_->setPart(part == 0 ? &app::Style::stroke : &app::Style::fill);
        follow();
    });
    connect(swatches_, &Swatches::picked, colour_, &ColourChoice::choose);
    connect(eyedropper, &QToolButton::clicked, colour_, &ColourChoice::startEyedropper);
    connect(colour_, &ColourChoice::eyedropperStarted, this, &StylePanel::eyedropperStarted);
    auto* line = row();
    line->addWidget(part_);
    line->addWidget(colour_, 1);
    line->addWidget(eyedropper);
    return line;
}

QLayout* StylePanel::makeWidth()
{
    connect(width_, &LengthField::edited, this, [this](double width, app::Merging merging) {
        change([width](app::Style& style) { app::setWidth(style, width); },
               Text::tr("Stroke width"), merging);
    });
    connect(dashes_, &DashList::picked, this, [this](const auto& pattern) {
        change(pattern, Text::tr("Dashes"), app::Merging::WithLast);
    });
    connect(dashes_, &ToolList::done, this, &StylePanel::entered);
    auto* line = row();
    line->addWidget(captionFor(width_, Text::tr("Width")));
    line->addWidget(width_, 1);
    line->addWidget(captionFor(dashes_, Text::tr("Dashes")));
    line->addWidget(dashes_, 1);
    return line;
}

QLayout* StylePanel::makePattern()
{
    pattern_->setAccessibleName(Text::tr("Dash pattern"));
    pattern_->setToolTip(
        Text::tr("Your own pattern: alternating lengths of dashes and gaps, such as 3 1 "
                 "0.5 1, or 2mm 1mm. Empty: solid."));
    pattern_->setFixedHeight(space::fieldHeight);
    connect(pattern_, &QLineEdit::returnPressed, this, [this] {
        enterPattern();
        emit entered();
    });
    connect(pattern_, &QLineEdit::editingFinished, this, &StylePanel::enterPattern);
    miterLimit_->setToolTip(Text::tr(
        "Miter limit: sharper corners are cut off. It is the longest corner, in stroke widths."));
    connect(miterLimit_, &LengthField::edited, this, [this](double limit, app::Merging merging) {
        if (limit < 1) {
            emit refused(Text::tr("The miter limit must be at least 1."));
            soon_.start(0);
            return;
        }
        change([limit](app::Style& style) { style.miterLimit = limit; }, Text::tr("Miter limit"),
               merging);
    });
    auto* line = row();
    line->addWidget(captionFor(pattern_, Text::tr("Pattern")));
    line->addWidget(pattern_, 1);
    line->addWidget(captionFor(miterLimit_, Text::tr("Limit")));
    keepPlace(*miterLimit_);
    miterLimit_->setFixedWidth(miterLimit_->fontMetrics().horizontalAdvance(u'0') * 5 + 28);
    line->addWidget(miterLimit_);
    return line;
}

void StylePanel::makeLayer()
{
    ofLayer_->setAccessibleName(Text::tr("For new objects of the layer"));
    ofLayer_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // a name may be long
    connect(ofLayer_, &QCheckBox::clicked, this, [this](bool on) {
        app::setLayerStyle(session_,
                           on ? std::optional(app::copiedStyle(session_).style) : std::nullopt);
        soon_.start(0);
    });
}

void StylePanel::followLayer()
{
    const QString name = session_.now().containers()[app::layerForNew(session_)].name;
    const QString text = Text::tr("For new objects of the layer “%1”").arg(name);
    constexpr int box = 24; // logical pixels, with its distance
    ofLayer_->setText(
        fontMetrics().elidedText(text, Qt::ElideRight, swatches_->sizeHint().width() - box));
    ofLayer_->setToolTip(
        Text::tr("What is drawn in the layer “%1” gets this style. It is saved with the "
                 "drawing.")
            .arg(name));
    ofLayer_->setChecked(app::layerStyle(session_).has_value());
}

QLayout* StylePanel::makeCorners()
{
    caps_->setIcons({"cap-butt", "cap-round", "cap-square"});
    joins_->setIcons({"join-miter", "join-round", "join-bevel"});
    connect(caps_, &Segments::picked, this, [this](int cap) {
        change([cap](app::Style& style) { style.cap = app::Cap(cap); }, Text::tr("Caps"));
    });
    connect(joins_, &Segments::picked, this, [this](int join) {
        change([join](app::Style& style) { style.join = app::Join(join); }, Text::tr("Joins"));
    });
    auto* line = row();
    line->addWidget(captionFor(caps_, Text::tr("Caps")));
    line->addWidget(caps_);
    line->addStretch(1);
    line->addWidget(captionFor(joins_, Text::tr("Joins")));
    line->addWidget(joins_);
    return line;
}

QLayout* StylePanel::makeFillRule()
{
    connect(fillRule_, &Segments::picked, this, [this](int rule) {
        change([rule](app::Style& style) { style.fillRule = app::FillRule(rule); },
               Text::tr("Fill rule"));
    });
    fillRule_->setToolTip(
        Text::tr("What is filled where a path crosses itself. Nonzero: all that it winds "
                 "around. Even-odd: every second area stays empty."));
    keepPlace(*fillRule_);
    auto* line = row();
    line->addWidget(captionFor(fillRule_, Text::tr("Fill rule")));
    line->addStretch(1);
    line->addWidget(fillRule_);
    return line;
}

app::Scale StylePanel::scale() const
{
    const app::Page& page = session_.now().page();
    return {page.paperUnit(session_.display().unit), page.millimetresPerUnit()};
}

void StylePanel::change(const app::ChangeStyle& change, const QString& text, app::Merging merging)
{
    app::restyle(session_, change, text, merging);
    soon_.start(0);
}

void StylePanel::enterPattern()
{
    if (!pattern_->isModified())
        return;
    pattern_->setModified(false);
    const auto dashes = app::typedDashes(pattern_->text(), scale());
    if (!dashes) {
        emit refused(dashes.error);
        soon_.start(0);
        return;
    }
    emit taken();
    change([&](app::Style& style) { style.dashes = *dashes.value; }, Text::tr("Dashes"));
}

void StylePanel::follow()
{
    const std::vector<app::Style> styles = app::shownStyles(session_);
    const auto colour = app::common(styles, colour_->part());
    swatches_->setColours(app::coloursInUse(session_.now().objects(), app::coloursInRow));
    swatches_->mark(colour.value_or(std::nullopt));
    followLines(styles);
    followLayer();
}

void StylePanel::followLines(std::span<const app::Style> styles)
{
    const auto [unit, size] = scale();
    const app::Style& first = styles.front();
    if (app::common(styles, &app::Style::width))
        width_->show(first.width, unit, size);
    else
        width_->showMixed(first.width, unit, size);
    if (app::common(styles, &app::Style::miterLimit))
        miterLimit_->show(first.miterLimit, app::Unit::User, 1);
    else
        miterLimit_->showMixed(first.miterLimit, app::Unit::User, 1);
    dashes_->follow(styles);
    const auto dashes = app::common(styles, &app::Style::dashes);
    if (!pattern_->isModified()) {
        pattern_->setText(dashes ? app::dashesText(*dashes, scale()) : QString());
        pattern_->setPlaceholderText(dashes ? Text::tr("solid") : Text::tr("mixed"));
    }
    const auto show = [](Segments& segments, const auto& value) {
        value ? segments.choose(int(*value)) : segments.chooseNone();
    };
    show(*caps_, app::common(styles, &app::Style::cap));
    show(*joins_, app::common(styles, &app::Style::join));
    show(*fillRule_, app::common(styles, &app::Style::fillRule));
    showWithCaption(*miterLimit_, std::ranges::any_of(styles, [](const app::Style& style) {
        return style.join == app::Join::Miter;
    }));
    showWithCaption(*fillRule_, std::ranges::any_of(styles, [](const app::Style& style) {
        return style.fill.has_value();
    }));
}

void StylePanel::showEvent(QShowEvent* event)
{
    follow();
    QWidget::showEvent(event);
}

} // namespace ui

#include "moc_style_panel.cpp"
