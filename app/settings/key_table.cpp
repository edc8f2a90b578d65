// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/key_table.h"

#include "app/base/text.h"
#include "app/settings/usable_key.h"

#include <algorithm>
#include <set>
#include <utility>

namespace app {

namespace {

constexpr qsizetype mostEntries = 500, longestEntry = 200; // of a settings file
constexpr QChar between = u'\t';

} // namespace

KeyTable::KeyTable(std::vector<KeyedCommand> commands, const QStringList& saved)
    : commands_(std::move(commands))
{
    for (const KeyedCommand& command : commands_)
        keys_.push_back(command.standard);
    read(saved);
}

bool KeyTable::isStandard(std::size_t command) const
{
    return keys_[command] == commands_[command].standard;
}

bool KeyTable::isStandard() const
{
    for (std::size_t i = 0; i < commands_.size(); ++i)
        if (!isStandard(i))
            return false;
    return true;
}

std::optional<std::size_t> KeyTable::find(const QString& key) const
{
    const auto found = std::ranges::find(commands_, key, &KeyedCommand::key);
    if (key.isEmpty() || found == commands_.end())
        return std::nullopt;
    return std::size_t(found - commands_.begin());
}

std::optional<std::size_t> KeyTable::holder(const QKeySequence& key, std::size_t besides) const
{
    for (std::size_t i = 0; i < commands_.size(); ++i)
        if (i != besides && keys_[i].contains(key))
            return i;
    return std::nullopt;
}

QString KeyTable::refusal(std::size_t command, const QKeySequence& key) const
{
    const KeyedCommand& wanted = commands_[command];
    if (wanted.scope == KeyedCommand::Scope::Fixed)
        return Text::tr("The keys of “%1” cannot be changed.").arg(wanted.name);
    if (const QString why = whyNoShortcut(key, wanted.scope); !why.isEmpty())
        return why;
    for (const KeyedCommand& other : commands_)
        if (other.scope == KeyedCommand::Scope::Fixed && other.standard.contains(key))
            return Text::tr("%1 belongs to “%2” and cannot be changed.")
                .arg(key.toString(QKeySequence::NativeText), other.name);
    return {};
}

void KeyTable::take(const QKeySequence& key, std::size_t besides)
{
    for (std::size_t i = 0; i < commands_.size(); ++i)
        if (i != besides && commands_[i].scope != KeyedCommand::Scope::Fixed)
            keys_[i].removeAll(key);
}

void KeyTable::give(std::size_t command, const QKeySequence& key)
{
    if (!refusal(command, key).isEmpty())
        return;
    take(key, command);
    keys_[command] = {key};
}

void KeyTable::clear(std::size_t command)
{
    if (commands_[command].scope != KeyedCommand::Scope::Fixed)
        keys_[command].clear();
}

std::vector<KeyMove> KeyTable::reset(std::size_t command)
{
    std::vector<KeyMove> moves;
    for (const QKeySequence& key : commands_[command].standard) {
        if (const auto other = holder(key, command))
            moves.push_back({*other, key, true});
        take(key, command);
    }
    const Keys given = std::exchange(keys_[command], commands_[command].standard);
    for (const QKeySequence& key : given)
        if (const auto owner = lacking(key)) {
            keys_[*owner].push_back(key);
            std::ranges::sort(keys_[*owner], {}, [&](const QKeySequence& each) {
                return commands_[*owner].standard.indexOf(each);
            });
            moves.push_back({*owner, key, false});
        }
    return moves;
}

/// The command whose standard key this is while nothing has it. One that a person gave another key
/// keeps that alone.
std::optional<std::size_t> KeyTable::lacking(const QKeySequence& key) const
{
    const std::size_t none = commands_.size();
    if (holder(key, none))
        return std::nullopt;
    const auto hasOnlyStandard = [this](std::size_t i) {
        return std::ranges::all_of(keys_[i], [&](const QKeySequence& each) {
            return commands_[i].standard.contains(each);
        });
    };
    for (std::size_t i = 0; i < none; ++i)
        if (commands_[i].standard.contains(key) && hasOnlyStandard(i))
            return i;
    return std::nullopt;
}

void KeyTable::reset()
{
    for (std::size_t i = 0; i < commands_.size(); ++i)
        keys_[i] = commands_[i].standard;
}

QStringList KeyTable::saved() const
{
    QStringList entries;
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        if (isStandard(i) || commands_[i].key.isEmpty())
            continue;
        QStringList parts{commands_[i].key};
        for (const QKeySequence& key : keys_[i])
            parts << key.toString(QKeySequence::PortableText);
        entries << parts.join(between);
    }
    return entries;
}

void KeyTable::read(const QStringList& saved)
{
    std::set<QString> seen;
    for (const QString& entry : saved.mid(0, mostEntries)) {
        const QString command = entry.left(longestEntry).section(between, 0, 0);
        if (!seen.insert(command).second || !read(entry))
            ++ignored_;
    }
    ignored_ += int(std::max<qsizetype>(0, saved.size() - mostEntries));
}

/// A key that was given to an earlier command stays there.
bool KeyTable::read(const QString& entry)
{
    if (entry.size() > longestEntry)
        return false;
    QStringList parts = entry.split(between);
    const auto command = find(parts.takeFirst());
    if (!command || commands_[*command].scope == KeyedCommand::Scope::Fixed)
        return false;
    Keys usable;
    bool good = true;
    for (const QString& part : parts) {
        const QKeySequence key(part, QKeySequence::PortableText);
        const auto other = holder(key, *command);
        const bool isGiven = other && !commands_[*other].standard.contains(key);
        const bool isStandard = commands_[*command].standard.contains(key);
        if (!isGiven && (isStandard || refusal(*command, key).isEmpty()))
            usable << key;
        else
            good = false;
    }
    if (!good && usable.isEmpty())
        return false;
    for (const QKeySequence& key : usable)
        take(key, *command);
    keys_[*command] = usable;
    return good;
}

QString keysText(const QList<QKeySequence>& keys)
{
    constexpr qsizetype most = 2;
    QStringList texts;
    for (const QKeySequence& key : keys)
        if (key.count() > 0 && (key[0].key() < Qt::Key_F13 || key[0].key() > Qt::Key_F35))
            texts << key.toString(QKeySequence::NativeText);
    return texts.mid(0, most).join(Text::tr(" or "));
}

} // namespace app
