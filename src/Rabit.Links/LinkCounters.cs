namespace Rabit.Links;

/// <summary>
/// What went through a link and what was lost, since it was opened. A snapshot: each figure is exact, but they are not
/// all of one instant.
/// </summary>
public readonly struct LinkCounters
{
    /// <summary>Makes a snapshot.</summary>
    /// <param name="bytesRead">See <see cref="BytesRead"/>.</param>
    /// <param name="bytesWritten">See <see cref="BytesWritten"/>.</param>
    /// <param name="bytesDropped">See <see cref="BytesDropped"/>.</param>
    /// <param name="writesDropped">See <see cref="WritesDropped"/>.</param>
    /// <param name="transientFaults">See <see cref="TransientFaults"/>.</param>
    /// <param name="openings">See <see cref="Openings"/>.</param>
    /// <param name="peersForgotten">See <see cref="PeersForgotten"/>.</param>
    /// <param name="peersDisplaced">See <see cref="PeersDisplaced"/>.</param>
    public LinkCounters(
        long bytesRead, long bytesWritten, long bytesDropped, long writesDropped, long transientFaults,
        long openings = 1, long peersForgotten = 0, long peersDisplaced = 0)
    {
        Openings = openings;
        PeersForgotten = peersForgotten;
        PeersDisplaced = peersDisplaced;
        BytesRead = bytesRead;
        BytesWritten = bytesWritten;
        BytesDropped = bytesDropped;
        WritesDropped = writesDropped;
        TransientFaults = transientFaults;
    }

    /// <summary>Bytes handed out by reads.</summary>
    public long BytesRead { get; }

    /// <summary>Bytes handed on by writes, to the other end or to the operating system.</summary>
    public long BytesWritten { get; }

    /// <summary>Bytes given to a write that did not go out. Given = written + dropped.</summary>
    public long BytesDropped { get; }

    /// <summary>Writes of which at least one byte was dropped.</summary>
    public long WritesDropped { get; }

    /// <summary>
    /// Faults that passed without ending the link, for example a host that answered that the port is closed.
    /// </summary>
    public long TransientFaults { get; }

    /// <summary>How many times it was opened.</summary>
    public long Openings { get; }

    /// <summary>Peers of a link with many that were forgotten, because nothing came of them any more.</summary>
    public long PeersForgotten { get; }

    /// <summary>Peers of a link with many that had to give way to new ones, because there were too many.</summary>
    public long PeersDisplaced { get; }

    /// <summary>What two parts of one link's life come to.</summary>
    internal LinkCounters Plus(in LinkCounters other) => new(
        BytesRead + other.BytesRead, BytesWritten + other.BytesWritten, BytesDropped + other.BytesDropped,
        WritesDropped + other.WritesDropped, TransientFaults + other.TransientFaults, Openings + other.Openings,
        PeersForgotten + other.PeersForgotten, PeersDisplaced + other.PeersDisplaced);

    /// <summary>For logs, one line.</summary>
    public override string ToString() =>
        $"{BytesRead} bytes read, {BytesWritten} written, {BytesDropped} dropped in {WritesDropped} writes, "
            + $"{TransientFaults} transient faults";
}
