// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hard_cases/hard_case.h"

#include "app/base/text.h"
#include "app/comparison/variants.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <charconv>

namespace app {

static constexpr std::array<const char*, 8> keys{"right",   "allowed", "lost",         "shown",
                                                 "outside", "moved",   "not-a-number", "endless"};

QString keyOf(Ruling ruling) { return QLatin1StringView(keys[std::size_t(ruling)]); }

std::optional<Ruling> findRuling(const QString& key)
{
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (key == QLatin1StringView(keys[i]))
            return Ruling(i);
    return std::nullopt;
}

namespace {

using Numbers = std::array<double, 4>;

QString translated(const QJsonObject& entry, QLatin1StringView field)
{
    const QString text = entry[field].toString();
    return text.isEmpty() ? text : Text::tr(text.toUtf8().constData());
}

/// Four decimal numbers, including "nan" and "inf". The shortest text that reads back is exact.
std::optional<Numbers> numbers(const QJsonValue& value)
{
    const QList<QByteArray> words = value.toString().toLatin1().simplified().split(' ');
    Numbers all{};
    if (words.size() != qsizetype(all.size()))
        return std::nullopt;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const QByteArray& word = words[qsizetype(i)];
        const char* end = word.constData() + word.size();
        if (const auto read = std::from_chars(word.constData(), end, all[i]);
            read.ec != std::errc() || read.ptr != end)
            return std::nullopt;
    }
    return all;
}

/// Fills in the fields that can be read; or returns which field is wrong.
QString fill(HardCase& hard, const QJsonObject& entry)
{
    const auto line = numbers(entry[QLatin1StringView("line")]);
    const auto window = numbers(entry[QLatin1StringView("window")]);
    const QJsonValue visibleJson = entry[QLatin1StringView("visible")];
    const auto visible = numbers(visibleJson);
    if (!line || !window || (!visibleJson.isNull() && !visible))
        return QStringLiteral("line, window, visible");
    hard.line = {{(*line)[0], (*line)[1]}, {(*line)[2], (*line)[3]}};
    hard.window = {{(*window)[0], (*window)[1]}, {(*window)[2], (*window)[3]}};
    if (visible)
        hard.visible = {{(*visible)[0], (*visible)[1]}, {(*visible)[2], (*visible)[3]}};
    const QJsonObject faults = entry[QLatin1StringView("faults")].toObject();
    for (auto fault = faults.begin(); fault != faults.end(); ++fault) {
        const auto ruling = findRuling(fault.value().toString());
        if (!ruling || !findVariant(fault.key()))
            return fault.key();
        hard.faults.emplace_back(fault.key(), *ruling);
    }
    return {};
}

std::vector<HardCase> ownCases()
{
    QFile file(QStringLiteral(":/hard_cases/hard_cases.json"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return readHardCases(file.readAll()).value.value_or(std::vector<HardCase>{});
}

} // namespace

const std::vector<HardCase>& hardCases()
{
    static const std::vector<HardCase> all = ownCases();
    return all;
}

const HardCase* findHardCase(const QString& key)
{
    for (const HardCase& hard : hardCases())
        if (hard.key == key)
            return &hard;
    return nullptr;
}

Result<std::vector<HardCase>> readHardCases(const QByteArray& json)
{
    using R = Result<std::vector<HardCase>>;
    QJsonParseError error;
    const auto document = QJsonDocument::fromJson(json, &error);
    if (!document.isArray())
        return R::failure(Text::tr("The hard cases cannot be read: %1, at byte %2.")
                              .arg(error.errorString())
                              .arg(error.offset));
    std::vector<HardCase> all;
    for (const auto& value : document.array()) {
        const QJsonObject entry = value.toObject();
        HardCase hard{.key = entry[QLatin1StringView("key")].toString(),
                      .title = translated(entry, QLatin1StringView("title")),
                      .origin = translated(entry, QLatin1StringView("origin")),
                      .link = entry[QLatin1StringView("link")].toString(),
                      .why = translated(entry, QLatin1StringView("why"))};
        if (hard.key.isEmpty() || hard.title.isEmpty() || hard.origin.isEmpty()
            || hard.why.isEmpty())
            return R::failure(
                Text::tr("Hard case %1 has no key, title, origin or reason.").arg(all.size() + 1));
        if (const QString wrong = fill(hard, entry); !wrong.isEmpty())
            return R::failure(Text::tr("Hard case %1: “%2” is not right.").arg(hard.key, wrong));
        all.push_back(std::move(hard));
    }
    return R::of(std::move(all));
}

} // namespace app
