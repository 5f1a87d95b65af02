using System;

namespace Rabit.Links;

/// <summary>
/// What is set for one link, beside what it is: the options behind its URL. Immutable. A link uses the times; the
/// others are for the program that speaks over it, for example Communications in Rabit.Uav.
/// </summary>
/// <example>
/// <code>
/// LinkSettings radio = LinkUrl.Parse("serial:/dev/ttyUSB0:57600,name=radio,rate=3600,deny-out=@1/154").Settings;
/// </code>
/// </example>
public sealed class LinkSettings
{
    /// <summary>Nothing is set.</summary>
    public static LinkSettings None { get; } = new();

    /// <summary><c>name=</c>: what the link is called in reports; null for its URL.</summary>
    public string? Name { get; init; }

    /// <summary><c>rate=</c>: how many bytes a second it carries; null where that is not known.</summary>
    public int? BytesPerSecond { get; init; }

    /// <summary>
    /// <c>flush=</c>, milliseconds: after what silence the beginning of a message is taken for noise; null for what is
    /// usual on such a link.
    /// </summary>
    public TimeSpan? FlushAfter { get; init; }

    /// <summary>
    /// <c>hold=</c>, milliseconds: how long a message may wait for others, to go out with them in one write or
    /// datagram; null for not at all. What is urgent takes along at once what waits.
    /// </summary>
    public TimeSpan? HoldTime { get; init; }

    /// <summary><c>idle=</c>, seconds, for <c>udpin</c>: after what silence a peer is forgotten.</summary>
    public TimeSpan? IdleTime { get; init; }

    /// <summary><c>keepalive=</c>, seconds, for <c>udpout</c>: see <see cref="LinkOptions.KeepAlive"/>.</summary>
    public TimeSpan? KeepAlive { get; init; }

    /// <summary><c>optional</c>: that it is silent, or not open, is no warning.</summary>
    public bool IsOptional { get; init; }

    /// <summary><c>listen-only</c>: the other end only listens; what comes in is counted and goes nowhere.</summary>
    public bool IsListenOnly { get; init; }

    /// <summary><c>receive-only</c>: nothing is sent over it.</summary>
    public bool IsReceiveOnly { get; init; }

    /// <summary><c>position=no</c> makes it false: our own position is not sent over it.</summary>
    public bool SendsPosition { get; init; } = true;

    /// <summary><c>key=</c>: the file of the key that it is signed with; null for none of its own.</summary>
    public string? KeyFile { get; init; }

    /// <summary><c>allow-in=</c> or <c>allow=</c>: what alone may come in; null for all.</summary>
    public LinkFilter? AllowIn { get; init; }

    /// <summary><c>allow-out=</c> or <c>allow=</c>: what alone may go out; null for all.</summary>
    public LinkFilter? AllowOut { get; init; }

    /// <summary><c>deny-in=</c> or <c>deny=</c>: what may not come in; null for nothing.</summary>
    public LinkFilter? DenyIn { get; init; }

    /// <summary><c>deny-out=</c> or <c>deny=</c>: what may not go out; null for nothing.</summary>
    public LinkFilter? DenyOut { get; init; }

    /// <summary>Whether a message may come in. Any thread.</summary>
    /// <param name="messageId">The id of the message.</param>
    /// <param name="systemId">The system id of its sender.</param>
    /// <param name="componentId">The component id of its sender.</param>
    public bool AdmitsIn(int messageId, byte systemId, byte componentId)
        => !IsListenOnly && Passes(AllowIn, DenyIn, messageId, systemId, componentId);

    /// <summary>Whether a message may go out. Any thread.</summary>
    /// <param name="messageId">The id of the message.</param>
    /// <param name="systemId">The system id of its sender.</param>
    /// <param name="componentId">The component id of its sender.</param>
    public bool AdmitsOut(int messageId, byte systemId, byte componentId)
        => !IsReceiveOnly && Passes(AllowOut, DenyOut, messageId, systemId, componentId);

    private static bool Passes(LinkFilter? allow, LinkFilter? deny, int messageId, byte systemId, byte componentId)
        => allow?.NamesBoth(messageId, systemId, componentId) != false
            && deny?.NamesEither(messageId, systemId, componentId) != true;
}
