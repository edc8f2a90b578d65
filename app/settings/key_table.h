// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace app {

/// A command that keys can be given to.
struct KeyedCommand {
    /// Where its keys work: everywhere; only while the canvas has the focus, so that letters can be
    /// typed in fields; only there while a clip window is chosen, so that signs begin numbers
    /// otherwise; or they cannot be changed.
    enum class Scope : std::uint8_t { Everywhere, Canvas, ChosenWindow, Fixed };
    QString key;  ///< its permanent name; empty: something else that keys belong to
    QString name; ///< as a person reads it
    QString menu; ///< in which it is
    Scope scope = Scope::Everywhere;
    QList<QKeySequence> standard; ///< its keys unless the person gives it others
};

/// A key that a command has got, or lost.
struct KeyMove {
    std::size_t command;
    QKeySequence key;
    bool isLost;
};

/// Which keys every command has: the standard ones, and those that the person gave. No key belongs
/// to two commands that can be changed. What the settings say is read as untrusted input.
class KeyTable {
public:
    using Keys = QList<QKeySequence>;

    /// `saved` is what `saved()` returned earlier; what is wrong in it is ignored.
    explicit KeyTable(std::vector<KeyedCommand> commands, const QStringList& saved = {});

    const std::vector<KeyedCommand>& commands() const { return commands_; }
    const Keys& keys(std::size_t command) const { return keys_[command]; }
    bool isStandard(std::size_t command) const;
    bool isStandard() const; ///< of all commands

    /// Why a command cannot have this key, in one sentence; empty: it can, at most by taking it
    /// from the one that has it.
    QString refusal(std::size_t command, const QKeySequence& key) const;
    /// The other command that has this key; empty: none.
    std::optional<std::size_t> holder(const QKeySequence& key, std::size_t besides) const;

    /// Makes this its only key, and takes it from the one that has it. Nothing if it is refused.
    void give(std::size_t command, const QKeySequence& key);
    void clear(std::size_t command); ///< leaves it without keys
    /// Gives it its standard keys, and takes them from those that have them. The keys that it had
    /// taken go back to the commands whose standard keys they are. The other commands that have
    /// got or lost keys.
    std::vector<KeyMove> reset(std::size_t command);
    void reset(); ///< all commands

    /// The commands with other keys than the standard ones: name and keys of each, between tabs.
    QStringList saved() const;
    /// How many entries of the settings were ignored, all or in part.
    int ignored() const { return ignored_; }

private:
    void read(const QStringList& saved);
    bool read(const QString& entry);
    void take(const QKeySequence& key, std::size_t besides);
    std::optional<std::size_t> find(const QString& key) const;
    std::optional<std::size_t> lacking(const QKeySequence& key) const;

    std::vector<KeyedCommand> commands_;
    std::vector<Keys> keys_;
    int ignored_ = 0;
};

/// "Ctrl+S or F12", the first two keys that a common keyboard has, as the desktop writes them.
QString keysText(const QList<QKeySequence>& keys);

} // namespace app
