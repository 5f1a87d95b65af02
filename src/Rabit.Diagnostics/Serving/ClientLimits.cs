using System;

namespace Rabit.Diagnostics.Serving;

/// <summary>What a client may take of the program.</summary>
internal sealed record ClientLimits
{
    public int MaxClients { get; init; } = 4;

    /// <summary>A request in bytes, its line break not counted.</summary>
    public int MaxRequestLength { get; init; } = 4096;

    public int MaxRequestsPerSecond { get; init; } = 50;

    /// <summary>From the connection to the first request.</summary>
    public TimeSpan FirstRequest { get; init; } = TimeSpan.FromSeconds(10);

    /// <summary>From one request to the next, while nothing is streamed.</summary>
    public TimeSpan Idle { get; init; } = TimeSpan.FromSeconds(60);

    /// <summary>How long a client may take nothing of a line that is sent to it.</summary>
    public TimeSpan Send { get; init; } = TimeSpan.FromSeconds(5);

    public TimeSpan MinStatusInterval { get; init; } = TimeSpan.FromMilliseconds(100);

    public TimeSpan MinEchoInterval { get; init; } = TimeSpan.FromMilliseconds(10);

    public TimeSpan MaxInterval { get; init; } = TimeSpan.FromMinutes(1);
}
