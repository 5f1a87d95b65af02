using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Puts the texts for people together that components send in chunks (MAVLink, STATUSTEXT: id and chunk_seq), of
/// several senders at a time. No I/O, no clock: frames in, texts out, time as argument. One thread; allocates the
/// texts.
/// </summary>
/// <remarks>
/// A text of one message is there at once; of several, as soon as all chunks have come, in whatever order. When no
/// further chunk comes for a second, what is there is the text, with "…" for what is missing. Texts are UTF-8, also
/// where a character is cut between two chunks; bytes that are none are read as Latin-1. Of more than 32 chunks, and
/// of more than 8 texts at a time, the oldest is ended as it is.
/// </remarks>
/// <example>
/// <code>
/// var texts = new MavlinkStatusTextReceiver();
///
/// // For every frame that arrives: texts.Handle(frame, now). After that, and at texts.NextDue at the latest:
/// static void Step(MavlinkStatusTextReceiver texts, TimeSpan now)
/// {
///     while (texts.TryTake(now, out MavlinkStatusText text))
///         Console.WriteLine($"{text.Severity}: {text.Text}");
/// }
/// </code>
/// </example>
public sealed class MavlinkStatusTextReceiver
{
    private const int Slots = 8;
    private const int MaxWaiting = 32;

    private static readonly TimeSpan ChunkTimeout = TimeSpan.FromSeconds(1);

    private readonly StatusTextSlot[] _slots = new StatusTextSlot[Slots];
    private readonly MavlinkStatusText[] _waiting = new MavlinkStatusText[MaxWaiting];
    private readonly char[] _characters = new char[(StatusTextSlot.MaxChunks * MavlinkStatusTextSplitter.ChunkBytes)
        + StatusTextSlot.MaxChunks + 1];
    private int _firstWaiting;
    private int _waitingCount;

    /// <summary>Makes a receiver.</summary>
    public MavlinkStatusTextReceiver()
    {
        for (int i = 0; i < Slots; i++)
            _slots[i] = new StatusTextSlot();
    }

    /// <summary>Texts that were ended with chunks missing.</summary>
    public long Incomplete { get; private set; }

    /// <summary>Copies of chunks.</summary>
    public long Repeats { get; private set; }

    /// <summary>Chunks that cannot be: behind the last of their text, or beyond 32.</summary>
    public long Refused { get; private set; }

    /// <summary>Texts that were not taken out in time: the oldest were dropped.</summary>
    public long Dropped { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTake"/> at the latest; <see cref="TimeSpan.MaxValue"/> while no chunk is awaited.
    /// </summary>
    public TimeSpan NextDue
    {
        get
        {
            TimeSpan next = _waitingCount > 0 ? TimeSpan.Zero : TimeSpan.MaxValue;
            foreach (StatusTextSlot slot in _slots)
            {
                if (slot.IsOpen && slot.UpdatedAt + ChunkTimeout < next)
                    next = slot.UpdatedAt + ChunkTimeout;
            }

            return next;
        }
    }

    /// <summary>Handles a received frame; all but STATUSTEXT are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.MessageId != Statustext.MavlinkId || !frame.TryDecode(out Statustext chunk))
            return;
        EndSilent(now);
        var source = new MavlinkAddress(frame.SystemId, frame.ComponentId);
        if (chunk.Id == 0)
            Enqueue(new MavlinkStatusText(source, chunk.Severity, chunk.Text.ToString(), IsComplete: true));
        else if (chunk.ChunkSeq >= StatusTextSlot.MaxChunks)
            Refused++;
        else
            Take(source, chunk, now);
    }

    /// <summary>Takes out the next text.</summary>
    /// <param name="now">The time.</param>
    /// <param name="text">The text.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTake(TimeSpan now, out MavlinkStatusText text)
    {
        EndSilent(now);
        text = default;
        if (_waitingCount == 0)
            return false;
        text = _waiting[_firstWaiting];
        _waiting[_firstWaiting] = default;
        _firstWaiting = (_firstWaiting + 1) % MaxWaiting;
        _waitingCount--;
        return true;
    }

    private void Take(MavlinkAddress source, in Statustext chunk, TimeSpan now)
    {
        StatusTextSlot slot = Find(source, chunk.Id) ?? Free();
        bool isSame = slot.IsUsed && slot.Source == source && slot.Id == chunk.Id;
        if (isSame && slot.Has(chunk.ChunkSeq) && slot.HasSame(chunk)
            && (slot.IsOpen || now - slot.UpdatedAt < ChunkTimeout))
        {
            Repeats++;
            return;
        }

        // A number that is used again: another text. One that is over takes no more chunks.
        if (!isSame || !slot.IsOpen || slot.Has(chunk.ChunkSeq))
        {
            End(slot);
            slot.Begin(source, chunk);
        }
        else if (!slot.Fits(chunk))
        {
            Refused++;
            return;
        }

        slot.Put(chunk, now);
        if (slot.IsComplete)
            End(slot);
    }

    private StatusTextSlot? Find(MavlinkAddress source, ushort id)
    {
        foreach (StatusTextSlot slot in _slots)
        {
            if (slot.IsUsed && slot.Source == source && slot.Id == id)
                return slot;
        }

        return null;
    }

    // One that was never used, else the one that is over for longest, else the one that waits for longest.
    private StatusTextSlot Free()
    {
        StatusTextSlot best = _slots[0];
        foreach (StatusTextSlot slot in _slots)
        {
            if (!slot.IsUsed)
                return slot;
            bool isBetter = slot.IsOpen == best.IsOpen ? slot.UpdatedAt < best.UpdatedAt : best.IsOpen;
            best = isBetter ? slot : best;
        }

        return best;
    }

    private void EndSilent(TimeSpan now)
    {
        foreach (StatusTextSlot slot in _slots)
        {
            if (slot.IsOpen && now - slot.UpdatedAt >= ChunkTimeout)
                End(slot);
        }
    }

    private void End(StatusTextSlot slot)
    {
        if (!slot.IsOpen)
            return;
        bool isComplete = slot.IsComplete;
        Incomplete += isComplete ? 0 : 1;
        Enqueue(new MavlinkStatusText(slot.Source, slot.Severity, slot.Read(_characters), isComplete));
        slot.Close();
    }

    private void Enqueue(in MavlinkStatusText text)
    {
        if (_waitingCount == MaxWaiting)
        {
            _firstWaiting = (_firstWaiting + 1) % MaxWaiting;
            _waitingCount--;
            Dropped++;
        }

        _waiting[(_firstWaiting + _waitingCount++) % MaxWaiting] = text;
    }
}
