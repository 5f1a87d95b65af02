using System;

namespace Rabit.Mavlink;

/// <summary>Times and limits of a <see cref="MavlinkFtpClient"/>. Immutable.</summary>
public sealed class MavlinkFtpClientOptions
{
    /// <summary>
    /// How long an answer, or the next packet of a burst, is waited for before the request is sent again; 0.7 s.
    /// </summary>
    public TimeSpan AnswerTimeout { get; init; } = TimeSpan.OfSeconds(0.7);

    /// <summary>How often a request is sent again while nothing new comes; 6.</summary>
    public int Retries { get; init; } = 6;

    /// <summary>How many bytes a file may have that is read; 16 MiB.</summary>
    public int MaxFileSize { get; init; } = 16 * 1024 * 1024;

    /// <summary>How many entries a directory may have that is listed; 10 000. More are left out.</summary>
    public int MaxEntries { get; init; } = 10_000;
}
