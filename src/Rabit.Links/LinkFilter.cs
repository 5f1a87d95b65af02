using System;
using System.Collections.Generic;

namespace Rabit.Links;

/// <summary>
/// Which messages, by their ids and by who sent them, an option of a link names. Numbers only: what they mean is for
/// the protocol on the link. Immutable.
/// </summary>
public sealed class LinkFilter
{
    private readonly HashSet<int> _messageIds;
    private readonly HashSet<int> _senders; // system id * 256 + component id
    private readonly HashSet<int> _systems;

    /// <summary>Makes a filter.</summary>
    /// <param name="messageIds">The message ids that it names.</param>
    /// <param name="senders">The senders that it names: system id, and component id or null for all of it.</param>
    public LinkFilter(IEnumerable<int> messageIds, IEnumerable<(byte SystemId, byte? ComponentId)> senders)
    {
        _messageIds = [.. messageIds ?? throw new ArgumentNullException(nameof(messageIds))];
        _senders = [];
        _systems = [];
        foreach ((byte system, byte? component) in senders ?? throw new ArgumentNullException(nameof(senders)))
        {
            if (component is { } of) _senders.Add((system << 8) | of);
            else _systems.Add(system);
        }
    }

    private bool NamesSenders => _senders.Count + _systems.Count > 0;

    /// <summary>Whether it names the id or the sender: what a list of what is denied asks. Any thread.</summary>
    /// <param name="messageId">The id of the message.</param>
    /// <param name="systemId">The system id of its sender.</param>
    /// <param name="componentId">The component id of its sender.</param>
    public bool NamesEither(int messageId, byte systemId, byte componentId)
        => _messageIds.Contains(messageId) || IsSender(systemId, componentId);

    /// <summary>
    /// Whether it names the id, if it names ids at all, and the sender, if it names senders at all: what a list of what
    /// is allowed asks. Any thread.
    /// </summary>
    /// <param name="messageId">The id of the message.</param>
    /// <param name="systemId">The system id of its sender.</param>
    /// <param name="componentId">The component id of its sender.</param>
    public bool NamesBoth(int messageId, byte systemId, byte componentId)
        => (_messageIds.Count == 0 || _messageIds.Contains(messageId))
            && (!NamesSenders || IsSender(systemId, componentId));

    private bool IsSender(byte systemId, byte componentId)
        => NamesSenders && (_systems.Contains(systemId) || _senders.Contains((systemId << 8) | componentId));
}
