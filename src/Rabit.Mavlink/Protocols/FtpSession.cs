using System;

namespace Rabit.Mavlink.Protocols;

/// <summary>An open file, and the burst that is being sent of it.</summary>
internal sealed class FtpSession
{
    public bool IsOpen { get; private set; }

    public MavlinkAddress Source { get; private set; }

    public ReadOnlyMemory<byte> Content { get; private set; }

    public TimeSpan UsedAt { get; set; }

    /// <summary>How many packets of the burst are left; 0: there is none.</summary>
    public int BurstLeft { get; set; }

    public long BurstOffset { get; set; }

    public byte BurstSize { get; set; }

    public ushort BurstSequence { get; set; }

    public TimeSpan BurstDue { get; set; }

    public void Open(MavlinkAddress source, ReadOnlyMemory<byte> content, TimeSpan now)
    {
        (IsOpen, Source, Content, UsedAt, BurstLeft) = (true, source, content, now, 0);
    }

    public void Close() => (IsOpen, Content, BurstLeft) = (false, default, 0);
}
