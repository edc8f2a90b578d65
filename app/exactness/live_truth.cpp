// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/live_truth.h"

namespace app {

using clipping::Clipped;
using clipping::Window;

constexpr std::size_t sliceLines = 250; // a millisecond or two

LiveTruth::LiveTruth(const EditedDocument& document, const Scene& scene, QObject* parent)
    : LiveFinding(document, scene, {mostAtOnce, sliceLines}, parent)
{
}

void LiveTruth::ask(const std::optional<Question>& question)
{
    if (question == asked_)
        return;
    const bool same = question && asked_ && question->variant == asked_->variant;
    asked_ = question;
    if (!same || !upToDate())
        return askAnew(asked_.has_value());
    measure();
    emit changed();
}

void LiveTruth::start(const Window& window) { growing_ = {window}; }

void LiveTruth::look(const SceneLines& lines, std::size_t count)
{
    growing_ = extended(std::move(growing_), asked_->variant, lines, count);
}

void LiveTruth::keep()
{
    found_ = std::exchange(growing_, {});
    measure();
}

void LiveTruth::forget()
{
    found_ = growing_ = {};
    counts_ = {};
    pieces_.clear();
}

void LiveTruth::measure()
{
    counts_ = counted(found_, asked_->yardstick);
    pieces_.assign(errorClasses().size(), {});
    for (const LineTruth& line : found_.list)
        pieces_[errorClassOf(line, asked_->yardstick)].push_back({line.piece, line.source, 0});
}

std::span<const std::vector<Clipped>> LiveTruth::piecesAt(const Window& window) const
{
    if (!asked_ || !upToDate() || found_.window != window)
        return {};
    return pieces_;
}

} // namespace app
