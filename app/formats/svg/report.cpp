// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/report.h"

#include "app/base/text.h"
#include "app/formats/svg/refused.h"

#include <algorithm>

namespace app::svg {

namespace {

const QString others = QStringLiteral("…");

// The text in quotation marks, shortened.
QString shownExcerpt(std::string_view text)
{
    constexpr qsizetype most = 40;
    const QString words = QString::fromUtf8(text.substr(0, 4 * most)).simplified();
    return u'“' + (words.size() > most ? words.left(most) + u'…' : words) + u'”';
}

} // namespace

Report::Counted& Report::of(const LossKind& kind)
{
    const auto found = std::ranges::find(counted_, &kind, &Counted::kind);
    return found != counted_.end() ? *found : counted_.emplace_back(Counted{&kind, 0, line_});
}

// An entry for each text of this kind; one for all texts beyond the first `most`.
Report::Counted& Report::of(const LossKind& kind, const QString& text)
{
    constexpr int most = 20;
    int texts = 0;
    for (Counted& counted : counted_) {
        if (counted.kind != &kind)
            continue;
        if (counted.texts.front() == text || ++texts > most)
            return counted;
    }
    return counted_.emplace_back(Counted{&kind, 0, line_, {texts < most ? text : others}});
}

void Report::add(const LossKind& kind, int count)
{
    if (count > 0 && silences_ == 0)
        of(kind).count += count;
}

void Report::add(const LossKind& kind, std::string_view text)
{
    constexpr qsizetype most = 3;
    if (silences_ > 0)
        return;
    const QString one = shownExcerpt(text);
    if (kind.each) {
        ++of(kind, one).count;
        return;
    }
    Counted& counted = of(kind);
    ++counted.count;
    if (counted.texts.size() <= most && !counted.texts.contains(one))
        counted.texts << (counted.texts.size() < most ? one : others);
}

std::vector<Loss> Report::losses() const
{
    std::vector<Loss> losses;
    for (const auto& [kind, count, line, texts] : counted_) {
        const char* const instead = count == 1 ? kind->oneInstead : kind->manyInstead;
        QString what = Text::tr(count == 1 ? kind->one : kind->many);
        if (!texts.isEmpty())
            what = what.arg(texts.join(QStringLiteral(", ")));
        losses.push_back({what, count, kind->remark, instead ? Text::tr(instead) : QString(), line,
                          kind->cut, kind->outlined});
    }
    return losses;
}

} // namespace app::svg
