using System;
using System.Collections.Generic;
using Rabit.Mavlink.Framing;

namespace Rabit.Mavlink;

/// <summary>
/// The set of messages that a receiver knows: message id to CRC_EXTRA, lengths and target fields. Immutable, safe from
/// any thread. Those that come with the package are <see cref="All"/>, <see cref="Common"/>,
/// <see cref="ArduPilotMega"/> and others; <see cref="Combine"/> puts several together.
/// </summary>
/// <example>
/// <code>
/// MavlinkDialect dialect = MavlinkDialect.Common;
/// if (dialect.TryGetMessage("ATTITUDE", out MavlinkMessageInfo message))
///     Console.WriteLine($"id {message.Id}, CRC_EXTRA {message.CrcExtra}");
/// foreach (MavlinkFieldDefinition field in dialect.FindDefinition(message.Id)!.Fields)
///     Console.WriteLine($"{field.Name}, {field.Units}");
/// </code>
/// </example>
public sealed partial class MavlinkDialect
{
    private readonly Dictionary<int, MavlinkMessageInfo> _byId;

    /// <summary>Makes a dialect of the given messages.</summary>
    /// <param name="name">What to call it in errors and tools.</param>
    /// <param name="messages">Its messages; no id may come twice.</param>
    /// <exception cref="ArgumentException">
    /// Two messages have one id, and the text names both; or an id is outside 0 to 16 777 215.
    /// </exception>
    public MavlinkDialect(string name, IReadOnlyCollection<MavlinkMessageInfo> messages)
    {
        Name = name ?? throw new ArgumentNullException(nameof(name));
        _byId = new Dictionary<int, MavlinkMessageInfo>(
            (messages ?? throw new ArgumentNullException(nameof(messages))).Count);
        foreach (MavlinkMessageInfo message in messages)
        {
            if (message.Id is < 0 or > WireFormat.MaxMessageIdV2)
                throw new ArgumentException(
                    $"Dialect '{name}': {message.Name} has id {message.Id}; ids are 0 to {WireFormat.MaxMessageIdV2}.",
                    nameof(messages));
            if (_byId.TryGetValue(message.Id, out MavlinkMessageInfo other))
                throw new ArgumentException(
                    $"Dialect '{name}': {other.Name} and {message.Name} both have id {message.Id}.", nameof(messages));
            _byId.Add(message.Id, message);
        }

        Table = new MessageTable(messages);
    }

    /// <summary>What the dialect is called.</summary>
    public string Name { get; }

    /// <summary>How many messages it has.</summary>
    public int Count => _byId.Count;

    /// <summary>Its messages, in no order.</summary>
    public IReadOnlyCollection<MavlinkMessageInfo> Messages => _byId.Values;

    /// <summary>The same messages, for a look-up per frame.</summary>
    internal MessageTable Table { get; }

    /// <summary>Finds a message by its id.</summary>
    /// <param name="messageId">Any number; one that is no id is simply not found.</param>
    /// <param name="message">The description where found.</param>
    /// <returns>Whether the dialect knows the id.</returns>
    public bool TryGetMessage(int messageId, out MavlinkMessageInfo message)
    {
        int index = Table.IndexOf(messageId);
        message = Table.At(index);
        return index != 0;
    }
}
