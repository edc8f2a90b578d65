// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/pane_widget.h"

#include "app/base/short_names.h"
#include "app/base/variant.h"
#include "app/scene/left_alone.h"
#include "app/session/window_in_hand.h"
#include "app/session/window_words.h"
#include "ui/look/text.h"
#include "ui/widgets/spoken_role.h"

namespace ui {

PaneWidget::PaneWidget(Controller& controller, Backend backend, QWidget* parent)
    : QWidget(parent), controller_(controller), session_(controller.session()),
      fromExact_(session_.document, session_.scene), pane_{{&app::usualAlgorithm()}},
      heading_(new PaneHeading(this)),
      surface_((backend == Backend::OpenGL ? makeGlSurface : makeRasterSurface)(
          controller, pane_,
          [this](const app::FrameTimes& times) {
              heading_->note(times);
              emit frameShown(times);
          },
          this))
{
    QWidget& drawing = surface_->widget();
    setSpokenRole(drawing, QAccessible::Canvas);
    drawing.setFocusPolicy(Qt::StrongFocus);
    drawing.setMouseTracking(true);
    drawing.setAccessibleName(Text::tr("Drawing"));
    heading_->hide();
    connect(&fromExact_, &app::LiveDifferences::changed, this, [this, &drawing] {
        ++pane_.revision;
        drawing.update();
        sayWhereItClips();
    });
    connect(&session_, &app::Session::previewChanged, this, &PaneWidget::followWindow);
    for (const auto changed : {&app::Session::selectionChanged, &app::Session::loaded})
        connect(&session_, changed, this, &PaneWidget::sayWhatIsChosen);
    connect(&controller.held(), &HeldTool::chosen, this, &PaneWidget::sayWhatIsChosen);
    connect(&session_.nodes, &app::NodeEditing::changed, this, &PaneWidget::sayWhatIsChosen);
    connect(&session_.document, &app::EditedDocument::changed, this, &PaneWidget::sayWhatIsChosen,
            Qt::QueuedConnection); // the selection may not be updated yet
    sayWhatIsChosen();
}

// Corrected forms rarely differ, so they are compared only after a gesture. Where another algorithm
// clips in the place of this one, no difference is its own.
void PaneWidget::followWindow()
{
    heading_->setNeeds(app::needsOf(session_.region()));
    pane_.leftAlone = pane_.among > 1 ? app::leftAlone(session_.region(), pane_.choice)
                                      : std::vector<std::size_t>();
    pane_.region.reset();
    if (!pane_.leftAlone.empty())
        pane_.region = app::shownRegionOf(app::without(session_.windows(), pane_.leftAlone),
                                          session_.now().page());
    sayWhereItClips();
    if (!clipsItself())
        fromExact_.setWindow(std::nullopt);
    else if (pane_.choice.form == clipping::Form::Published || !session_.preview().windows)
        fromExact_.setWindow(session_.comparedAt());
}

// Screen readers read a new description of what has the focus.
void PaneWidget::sayWhatIsChosen()
{
    surface_->widget().setAccessibleDescription(
        app::chosenText(session_, controller_.actsOnWindow()));
}

bool PaneWidget::clipsItself() const
{
    return app::usedAt(pane_.region.value_or(session_.region()), pane_.choice) == pane_.choice;
}

void PaneWidget::sayWhereItClips()
{
    if (pane_.leftAlone.empty())
        return heading_->setLimits({}, {});
    QStringList clipped, left;
    const std::vector<app::NamedNeeds> windows = app::needsByName(session_);
    for (std::size_t i = 0; i < windows.size(); ++i)
        (std::ranges::binary_search(pane_.leftAlone, i) ? left : clipped) << windows[i].name;
    const QString compared = app::comparedName(session_);
    const bool agrees = fromExact_.asked() && fromExact_.upToDate() && session_.comparedAt()
                        && fromExact_.found().list.empty() && fromExact_.found().lines > 0;
    heading_->setLimits(
        clipped.isEmpty() ? QString()
        : agrees && !compared.isEmpty()
            ? Text::tr("agrees in %1").arg(compared)
            : Text::tr("in %1 only", "clip windows").arg(app::briefListText(clipped)),
        app::briefListText(left));
}

void PaneWidget::show(const Pane& pane, Heading heading)
{
    const bool marks = pane.among > 1 && pane.choice != app::exactVariant();
    const auto revision = pane_.revision;
    pane_ = pane;
    pane_.revision = revision;
    pane_.fromExact = marks ? &fromExact_ : nullptr;
    fromExact_.ask(marks ? std::optional(app::Comparison{pane.choice}) : std::nullopt);
    followWindow();
    heading_->show(pane);
    heading_->setVisible(heading == Heading::Shown);
    place();
    setVisible(true);
    surface_->widget().update();
}

void PaneWidget::rest()
{
    hide();
    fromExact_.ask(std::nullopt);
    surface_->forget();
}

void PaneWidget::settle()
{
    fromExact_.finish();
    surface_->settle();
}

void PaneWidget::place()
{
    const int top = heading_->isHidden() ? 0 : heading_->height();
    heading_->setGeometry(0, 0, width(), heading_->height());
    surface_->widget().setGeometry(0, top, width(), height() - top);
}

void PaneWidget::resizeEvent(QResizeEvent*) { place(); }

} // namespace ui

#include "moc_pane_widget.cpp"
