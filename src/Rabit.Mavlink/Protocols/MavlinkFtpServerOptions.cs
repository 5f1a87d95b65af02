using System;

namespace Rabit.Mavlink;

/// <summary>Limits and times of a <see cref="MavlinkFtpServer"/>. Immutable.</summary>
public sealed class MavlinkFtpServerOptions
{
    /// <summary>How many files may be open at once, by all stations together; 4.</summary>
    public int MaxSessions { get; init; } = 4;

    /// <summary>How long a file stays open without a request for it; 30 s.</summary>
    public TimeSpan SessionTimeout { get; init; } = TimeSpan.FromSeconds(30);

    /// <summary>How many packets of data one burst has at most; 100.</summary>
    public int BurstPackets { get; init; } = 100;

    /// <summary>
    /// The time between the packets of a burst; 10 ms. A slow radio needs more, to have room for other things.
    /// </summary>
    public TimeSpan BurstInterval { get; init; } = TimeSpan.OfSeconds(0.01);

    /// <summary>How many answers may wait to be sent; 16. What comes on top is dropped and counted.</summary>
    public int Capacity { get; init; } = 16;
}
