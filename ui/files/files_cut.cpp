// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/crop_to_window.h"
#include "app/commands/outline_strokes.h"
#include "app/comparison/cut_text.h"
#include "app/cut/stroke_area.h"
#include "app/scene/window_needs.h"
#include "app/session/arrange_selection.h"
#include "app/session/comparing.h"
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <new>

namespace ui {

app::CutOptions Files::cutAs(MakeOptions make) const
{
    const app::Document& document = session_.now();
    app::CutOptions options = make(session_.display().cutting, document.page());
    options.clipAll = session_.uses().clipAll;
    app::cutAt(options, document.windows(), document.page());
    return options;
}

void Files::cutPermanently(const app::PermanentCut& kind)
{
    const auto plan = [this, &kind] {
        return Cutting{Text::tr("Cutting…"),
                       [options = cutAs(app::permanentOptions),
                        &kind](const app::Document& document, const app::Follower& follower) {
                           return kind.make(document, options, follower);
                       },
                       [this, &kind](app::Cut cut) { showCut(std::move(cut), kind); }};
    };
    background_.inTurn([this, plan](const Turn& turn) { cutNow(plan, turn); });
}

void Files::outlineStrokes()
{
    const auto plan = [this] {
        return Cutting{Text::tr("Outlining strokes…"),
                       [selected = session_.selection()](const app::Document& document,
                                                         const app::Follower& follower) {
                           return app::strokesAsAreas(document, selected, follower);
                       },
                       [this](const app::Cut& cut) { showAreas(cut); }};
    };
    background_.inTurn([this, plan](const Turn& turn) { cutNow(plan, turn); });
}

void Files::cutNow(const std::function<Cutting()>& plan, const Turn& turn)
{
    emit documentWanted();
    const Cutting cutting = plan();
    using Made = std::optional<app::Cut>; // empty: not enough memory
    background_.run(
        cutting.doing,
        [document = session_.now(), make = cutting.make](const app::Follower& follower) -> Made {
            try {
                return make(document, follower);
            } catch (const std::bad_alloc&) {
                return std::nullopt;
            }
        },
        [this, plan, turn, show = cutting.show,
         document = session_.now()](std::optional<Made> cut) {
            if (!cut)
                return;
            if (!*cut)
                return emit told({Message::Kind::Warning,
                                  Text::tr("Nothing was changed: there is not enough memory. Close "
                                           "other programs, and try again.")});
            if (!sameAddress(document, session_.now())) // not by the person, who had to wait
                return cutNow(plan, turn);
            show(std::move(**cut));
        },
        InBackground::Cancel::Drops);
}

void Files::showCut(app::Cut cut, const app::PermanentCut& kind)
{
    auto command = std::make_unique<app::CropToWindow>(session_.document, std::move(cut), kind);
    const app::CutCounts counts = command->counts();
    if (!command->changes()) {
        const QString leftAlone = app::leftAloneText(counts);
        return emit told({Message::Kind::Done,
                          Text::tr(kind.nothing)
                              + (leftAlone.isEmpty() ? QStringLiteral(": ") + Text::tr(kind.why)
                                                     : u'.' + leftAlone)});
    }
    session_.history.push(command.release());
    tellCut(Text::tr(kind.done).arg(app::cutText(counts)));
}

/// The person may see the result of another algorithm, or may have chosen a form that is known to
/// lose lines.
void Files::tellCut(const QString& done)
{
    const app::Variant used = app::usedAt(session_.region(), session_.cuts());
    if (used.form != clipping::Form::Published) {
        const QString compared = app::onlyComparedText(session_);
        return emit told(
            {Message::Kind::Done, compared.isEmpty() ? done : done + u' ' + compared + u'.'});
    }
    const QString name = app::latin(used.algorithm->abbreviation);
    emit told({Message::Kind::Warning,
               done + u' '
                   + Text::tr("It was cut by %1 as published, with the faults of that form. Exact "
                              "(0) has none.")
                         .arg(name)});
}

void Files::showAreas(const app::Cut& cut)
{
    if (cut.edit.splices.empty())
        return emit told({Message::Kind::Done,
                          Text::tr("Nothing was outlined: nothing is seen of these strokes.")});
    session_.history.push(
        new app::OutlineStrokes(session_.document, cut.edit, Text::tr("Outline of stroke")));
    session_.select(app::justAdded(session_));
    emit told(
        {Message::Kind::Done,
         Text::tr("Strokes that became filled areas: %1.").arg(app::countText(cut.counts.cut))});
}

} // namespace ui
