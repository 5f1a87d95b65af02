using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Mavlink.Definitions;

namespace Rabit.Mavlink;

// Dialects put together at run time, and what their definitions say of fields and enums.
public sealed partial class MavlinkDialect
{
    // Where definitions are looked for, in this order; none for a dialect that was made of bare descriptions.
    private readonly DefinitionData[] _sources = [];
    private readonly ConcurrentDictionary<int, MavlinkMessageDefinition?> _definitions = new();
    private readonly ConcurrentDictionary<string, MavlinkEnumDefinition> _enums = new(StringComparer.Ordinal);

    internal MavlinkDialect(
        string name, IReadOnlyCollection<MavlinkMessageInfo> messages, DefinitionData own, MavlinkDialect? basis)
        : this(name, messages, basis is null ? [own] : [own, .. basis._sources])
    {
    }

    private MavlinkDialect(string name, IReadOnlyCollection<MavlinkMessageInfo> messages, DefinitionData[] sources)
        : this(name, messages) => _sources = sources;

    /// <summary>
    /// Puts dialects together: what one link carries may come from several definitions, for example <c>Combine("mine",
    /// MavlinkDialect.Common, MineDialect.Instance)</c>. A message that several have is there once, in its longest
    /// form: extension fields are added behind the others over the years.
    /// </summary>
    /// <param name="name">What to call the whole.</param>
    /// <param name="dialects">The parts; none gives a dialect that knows no message.</param>
    /// <returns>A new dialect.</returns>
    /// <exception cref="ArgumentException">
    /// Two parts have one id for different messages; the text names both.
    /// </exception>
    public static MavlinkDialect Combine(string name, params MavlinkDialect[] dialects)
    {
        if (dialects is null)
            throw new ArgumentNullException(nameof(dialects));
        var messages = new Dictionary<int, MavlinkMessageInfo>();
        foreach (MavlinkDialect dialect in dialects)
        {
            foreach (MavlinkMessageInfo message in (dialect
                ?? throw new ArgumentException("One of the dialects is null.", nameof(dialects))).Messages)
            {
                if (!messages.TryGetValue(message.Id, out MavlinkMessageInfo other) || IsLongerForm(message, other))
                    messages[message.Id] = message;
                else if (!IsSameMessage(message, other))
                    throw new ArgumentException(
                        $"Dialect '{name}': {dialect.Name} has {message.Name} (checksum byte {message.CrcExtra}) as "
                            + $"message {message.Id}, which is {other.Name} (checksum byte {other.CrcExtra}) already.",
                        nameof(dialects));
            }
        }

        return new MavlinkDialect(
            name, messages.Values, dialects.SelectMany(dialect => dialect._sources).Distinct().ToArray());
    }

    /// <summary>
    /// Looks a message up by name, one by one: for command lines and configuration, not for the path of every frame.
    /// </summary>
    /// <param name="name">Name as the definition writes it, for example <c>ATTITUDE</c>; case does not count.</param>
    /// <param name="message">The description where found.</param>
    /// <returns>Whether the dialect has a message of that name.</returns>
    public bool TryGetMessage(string name, out MavlinkMessageInfo message)
    {
        foreach (MavlinkMessageInfo known in Messages)
        {
            if (string.Equals(known.Name, name, StringComparison.OrdinalIgnoreCase))
            {
                message = known;
                return true;
            }
        }

        message = default;
        return false;
    }

    /// <summary>
    /// The fields of a message, with their units and enums. The first call for an id reads them, every later one gives
    /// the same object.
    /// </summary>
    /// <param name="messageId">Any number.</param>
    /// <returns>
    /// The definition; null where the dialect does not know the id, or knows no more of it than a
    /// <see cref="MavlinkMessageInfo"/>.
    /// </returns>
    public MavlinkMessageDefinition? FindDefinition(int messageId) =>
        _definitions.TryGetValue(messageId, out MavlinkMessageDefinition? known) ? known
        : TryGetMessage(messageId, out MavlinkMessageInfo message) ? _definitions.GetOrAdd(
            messageId, ReadDefinition(message))
        : null;

    /// <summary>
    /// An enum with the entries that all definitions of the dialect give it. Of definitions that come with this
    /// package, these are those of <see cref="All"/>.
    /// </summary>
    /// <param name="name">Name as the definition writes it, for example <c>MAV_CMD</c>.</param>
    /// <returns>The enum; null where there is none of that name.</returns>
    public MavlinkEnumDefinition? FindEnum(string name)
    {
        if (_enums.TryGetValue(name ?? throw new ArgumentNullException(nameof(name)), out MavlinkEnumDefinition? known))
            return known;
        // Names that are none are not remembered: there is no end to them.
        return ReadEnum(name) is { } read ? _enums.GetOrAdd(name, read) : null;
    }

    /// <summary>The messages that one definition file and its includes have.</summary>
    internal MavlinkDialect Part(string file)
        => new(Path.GetFileNameWithoutExtension(file), _sources[0].MessagesOf(file), _sources);

    private static bool IsSameMessage(in MavlinkMessageInfo one, in MavlinkMessageInfo other) =>
        one.CrcExtra == other.CrcExtra && string.Equals(one.Name, other.Name, StringComparison.Ordinal);

    private static bool IsLongerForm(in MavlinkMessageInfo one, in MavlinkMessageInfo other) =>
        IsSameMessage(one, other) && one.MaxLength > other.MaxLength;

    private MavlinkMessageDefinition? ReadDefinition(in MavlinkMessageInfo message)
    {
        foreach (DefinitionData source in _sources)
        {
            if (source.Defines(message))
                return source.ReadMessage(message.Id, FindEnum);
        }

        return null;
    }

    private MavlinkEnumDefinition? ReadEnum(string name)
    {
        var entries = new List<MavlinkEnumEntry>();
        bool isBitmask = false;
        bool isKnown = false;
        foreach (DefinitionData source in _sources)
            isKnown |= source.TryReadEnum(name, entries, ref isBitmask);
        // The first definition of a name counts: a dialect's own definitions come before those it is based on.
        return isKnown
            ? new MavlinkEnumDefinition(
                name, isBitmask,
                entries.GroupBy(entry => entry.Name, StringComparer.Ordinal).Select(same => same.First()))
            : null;
    }
}
