namespace Rabit.Links.Tests;

/// <summary>A link that reopens, and an other end that comes and goes.</summary>
public abstract class ReopeningBed : LinkTestBed
{
    /// <summary>The other end is there; again, after <see cref="LinkTestBed.PeerGoes"/>.</summary>
    public abstract void ComeUp();

    /// <summary>Waits until the link is open.</summary>
    public abstract void AwaitPeer();
}
