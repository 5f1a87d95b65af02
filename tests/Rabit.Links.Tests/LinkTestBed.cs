using System;

namespace Rabit.Links.Tests;

/// <summary>A link under test, and what stands at its other end.</summary>
public abstract class LinkTestBed : IDisposable
{
    /// <summary>How long a test waits for what must happen, on a machine that is busy.</summary>
    public static TimeSpan TestTimeout => Rabit.Tests.Shared.TestTimeout.Limit;

    /// <summary>Opened, and known to the other end.</summary>
    public abstract IByteLink Link { get; }

    public abstract void PeerSends(params byte[] bytes);

    public abstract byte[] PeerReceives(int count);

    public abstract void PeerGoes();

    public void Dispose()
    {
        Link.Dispose();
        PeerGoes();
        GC.SuppressFinalize(this);
    }
}
