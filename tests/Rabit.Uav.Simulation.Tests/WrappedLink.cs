using System;
using System.Threading;
using Rabit.Links;

namespace Rabit.Uav.Simulation.Tests;

/// <summary>Around one end of a link: passes everything on but what a derived class changes.</summary>
internal abstract class WrappedLink(IByteLink link) : IByteLink
{
    protected IByteLink Inner { get; } = link;

    public string Url => Inner.Url;

    public bool Blocks => Inner.Blocks;

    public LinkCounters Counters => Inner.Counters;

    public ByteLinkState State => Inner.State;

    public string? LastFault => Inner.LastFault;

    public abstract LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite);

    public virtual void Write(byte[] buffer, int offset, int count) => Inner.Write(buffer, offset, count);

    public void Unblock() => Inner.Unblock();

    public void SetReadableCallback(Action? callback) => Inner.SetReadableCallback(callback);

    public void Dispose() => Inner.Dispose();
}
