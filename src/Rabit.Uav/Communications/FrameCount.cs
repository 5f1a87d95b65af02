using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>How many frames of one message came from one source. Immutable.</summary>
public sealed class FrameCount
{
    internal FrameCount(
        int messageId, string? name, byte systemId, byte componentId, MavlinkVersion version, long count)
    {
        MessageId = messageId;
        Name = name;
        SystemId = systemId;
        ComponentId = componentId;
        Version = version;
        Count = count;
    }

    /// <summary>The message id.</summary>
    public int MessageId { get; }

    /// <summary>The name in the dialect; null for an id that it does not know.</summary>
    public string? Name { get; }

    /// <summary>System id of the sender.</summary>
    public byte SystemId { get; }

    /// <summary>Component id of the sender.</summary>
    public byte ComponentId { get; }

    /// <summary>The wire format.</summary>
    public MavlinkVersion Version { get; }

    /// <summary>How many.</summary>
    public long Count { get; }
}
