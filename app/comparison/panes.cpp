// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/panes.h"

#include <QStringList>

#include <algorithm>

namespace app {

namespace {

constexpr auto published = clipping::Form::Published;

Variant rowOf(std::string_view key, clipping::Form form = clipping::Form::Corrected)
{
    return {clipping::findAlgorithm(key), form};
}

/// The variant whose published form loses visible lines of usual drawings: near-vertical ones.
Variant publishedKwc() { return rowOf("kwc", published); }

/// Like findVariant, but without known misprints.
std::optional<Variant> choiceOf(const QString& key)
{
    const auto found = findVariant(key);
    return found && !found->misprint ? found : std::nullopt;
}

} // namespace

Panes::Panes(const Variant& only)
    : choices_{only}, remembered_{rowOf("exact"), rowOf("cs"), publishedKwc(), rowOf("md")}
{
}

std::optional<std::size_t> Panes::find(const Variant& choice) const
{
    const auto found = std::ranges::find(choices_, choice);
    return found == choices_.end() ? std::nullopt
                                   : std::optional(std::size_t(found - choices_.begin()));
}

/// The variants shown now go before those remembered earlier.
void Panes::remember()
{
    if (all_ || size() == 1)
        return;
    std::vector<Variant> order = choices_;
    for (const Variant& choice : remembered_)
        if (!find(choice))
            order.push_back(choice);
    std::copy_n(order.begin(), most, remembered_.begin());
}

void Panes::show(std::size_t count)
{
    remember();
    const Variant chosen = this->chosen();
    all_ = false;
    active_ = std::size_t(std::ranges::find(remembered_, chosen) - remembered_.begin());
    if (count > 1 && active_ >= count) {
        if (active_ < most)
            std::swap(remembered_[active_], remembered_[count - 1]);
        else
            remembered_[count - 1] = chosen;
        active_ = count - 1;
    }
    if (count > 1) {
        choices_.assign(remembered_.begin(), remembered_.begin() + std::ptrdiff_t(count));
    } else {
        choices_ = {chosen};
        active_ = 0;
    }
}

void Panes::showAll()
{
    remember();
    const Variant chosen = this->chosen();
    all_ = true;
    choices_ = {rowOf("exact")};
    for (const clipping::Algorithm& row : clipping::algorithms()) {
        if (&row != choices_.front().algorithm)
            choices_.push_back({&row});
        if (&row == publishedKwc().algorithm)
            choices_.push_back(publishedKwc());
    }
    choose(chosen);
}

void Panes::activate(std::size_t pane)
{
    if (pane < size())
        active_ = pane;
}

void Panes::choose(const Variant& choice)
{
    const auto there = find(choice);
    if (there && all_) {
        active_ = *there;
    } else if (there) {
        std::swap(choices_[*there], choices_[active_]);
    } else {
        const auto same = [&](const Variant& c) { return c.algorithm == choice.algorithm; };
        const auto place = std::ranges::find_if(choices_, same);
        if (all_ && !same(chosen()) && place != choices_.end())
            active_ = std::size_t(place - choices_.begin());
        choices_[active_] = choice;
    }
}

void Panes::close(std::size_t pane)
{
    if (size() == 1 || pane >= size())
        return;
    remember();
    choices_.erase(choices_.begin() + std::ptrdiff_t(pane));
    if (active_ > pane || active_ == size())
        --active_;
    all_ = all_ && size() > most;
}

std::vector<std::size_t> Panes::shown(std::size_t room) const
{
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < std::min(room, size()); ++i)
        result.push_back(i);
    if (active_ >= result.size())
        result.back() = active_;
    return result;
}

QString Panes::text() const
{
    Panes now = *this;
    now.remember();
    QStringList words{all_ ? QStringLiteral("all") : QString::number(size()),
                      QString::number(active_)};
    for (const Variant& choice : now.remembered_)
        words << keyOf(choice);
    return words.join(u' ');
}

std::optional<Panes> Panes::fromText(const QString& text, const Variant& chosen)
{
    const QStringList words = text.split(u' ');
    if (words.size() != 2 + qsizetype(most))
        return std::nullopt;
    Panes panes(chosen);
    for (std::size_t i = 0; i < most; ++i) {
        const auto choice = choiceOf(words[2 + qsizetype(i)]);
        if (!choice
            || std::count(panes.remembered_.begin(), panes.remembered_.begin() + std::ptrdiff_t(i),
                          *choice))
            return std::nullopt;
        panes.remembered_[i] = *choice;
    }
    const std::size_t count = words[0].toUInt(), active = words[1].toUInt();
    if (words[0] == u"all")
        panes.showAll();
    else if (count < 1 || count > most || active >= count)
        return std::nullopt;
    else if (count > 1)
        panes.choices_.assign(panes.remembered_.begin(),
                              panes.remembered_.begin() + std::ptrdiff_t(count));
    if (panes.size() > 1)
        panes.activate(active);
    return panes;
}

} // namespace app
