using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// One link as Communications sees it: what reads it, what writes it, what is counted, what is reported of it.
/// </summary>
internal sealed class LinkPort(
    int number,
    string url,
    FrameStatistics tally,
    BlockingReader<LinkFrame> reader,
    BlockingWriter<FrameToWrite>? writer,
    MessagePublisher<LinkStatus> status,
    Func<long> bytesLost,
    Func<long> incompatibleFrames,
    LinkFrameTarget? target,
    IByteLink? link,
    RecordedFile? file,
    LinkSettings settings,
    TunnelRateLimiter rateLimiter,
    LinkScheduler? scheduler)
{
    // Header, checksum, what TUNNEL says of its content, and the content.
    internal const int MaxTunnelLength = 12 + 5 + ExchangeWire.MaxLength;

    // Enough that the link never waits for us; what else waits in the exchange is sent in the order of its classes.
    private const int MaxWaitingMessages = 4;

    private long _framesOut;
    private long _rejectedOut;
    private long _filteredIn;
    private long _filteredOut;
    private TimeSpan? _lastFrameTime;
    private TimeSpan? _groundStationTime;
    private bool _leadsToAutopilot;
    private MavlinkSignatureCounters _signatures;
    private long _reportedRejections;
    private long _duplicates;

    private readonly LinkHold? _hold = writer is not null && settings.HoldTime is { } hold
        ? new LinkHold(writer, hold)
        : null;

    // Where frames do not wait for others.
    private readonly LinkOutput? _output = writer is not null && settings.HoldTime is null
        ? new LinkOutput(writer, target!, link!)
        : null;

    // By sender (system, component).
    private readonly Dictionary<int, byte> _sequences = [];

    public int Number { get; } = number;

    public BlockingReader<LinkFrame> Reader { get; } = reader;

    /// <summary>What goes out in which order; null where the link has no budget.</summary>
    public LinkScheduler? Scheduler { get; } = scheduler;

    /// <summary>A recorded log must lose nothing: it waits when there is no room.</summary>
    public bool IsRecorded => file is not null;

    public bool HasEnded => Reader.State is DeviceState.Ended or DeviceState.Faulted;

    /// <summary>See <see cref="LinkStatus.AddressConflicts"/>.</summary>
    public long AddressConflicts { get; private set; }

    /// <summary>When they are logged.</summary>
    public DropReport ConflictReport { get; } = new();

    public void CountAddressConflict() => AddressConflicts++;

    public void CountDuplicate() => _duplicates++;

    /// <summary>Whether its last frame is older than that.</summary>
    public bool IsSilent(TimeSpan since) => !(_lastFrameTime >= since);

    /// <summary>The number of the next frame that a sender of ours sends over this link.</summary>
    public byte NextSequence(in MavlinkFrame frame)
    {
        int sender = (frame.SystemId << 8) | frame.ComponentId;
        _sequences.TryGetValue(sender, out byte sequence);
        _sequences[sender] = unchecked((byte)(sequence + 1));
        return sequence;
    }

    /// <summary>Whether our own position goes out over it.</summary>
    public bool TakesPosition => settings.SendsPosition;

    /// <summary>Whether its settings let a frame in; one that they do not is counted.</summary>
    public bool Admits(in MavlinkFrame frame)
    {
        if (settings.AdmitsIn(frame.MessageId, frame.SystemId, frame.ComponentId))
            return true;
        _filteredIn++;
        return false;
    }

    /// <summary>Whether its settings let a frame out.</summary>
    public bool IsOpenTo(in MavlinkFrame frame)
        => settings.AdmitsOut(frame.MessageId, frame.SystemId, frame.ComponentId);

    /// <summary>Whether its settings let a frame out; one that they do not is counted.</summary>
    public bool AdmitsOut(in MavlinkFrame frame)
    {
        if (IsOpenTo(frame))
            return true;
        _filteredOut++;
        return false;
    }

    public void CountReceived(in LinkFrame frame) => _lastFrameTime = frame.Time;

    /// <summary>
    /// Notes who is at the other end, by heartbeats. The one message that is looked into here, since the loss of a
    /// ground station concerns the link, and counts also where Autopilot Interface hangs.
    /// </summary>
    public void NoteHeartbeat(in LinkFrame frame)
    {
        if (!frame.IsChecked || !frame.Frame.TryDecode(out Heartbeat heartbeat))
            return;
        if (heartbeat.Type == MavType.Gcs)
            _groundStationTime = frame.Time;
        _leadsToAutopilot |= heartbeat.Autopilot != MavAutopilot.Invalid && heartbeat.Type != MavType.Gcs;
    }

    /// <summary>Takes what the radio of the link reports of its buffer.</summary>
    public void NoteRadio(in LinkFrame frame)
    {
        if (Scheduler is not null && frame.IsChecked && frame.Frame.TryDecode(out RadioStatus radio))
            Scheduler.NoteRadioBuffer(radio.Txbuf, frame.Time);
    }

    /// <summary>Whether a ground station, and no autopilot, is at the other end.</summary>
    /// <param name="since">Its last heartbeat is not older.</param>
    public bool IsToGroundStation(TimeSpan since) => _groundStationTime >= since && !_leadsToAutopilot;

    public void CountSignature(MavlinkSignatureResult result) => _signatures = _signatures.With(result);

    /// <summary>
    /// Says how many frames were rejected since they were last reported; again only when they have doubled, so that a
    /// flood fills no log.
    /// </summary>
    public bool TakeNewRejections(out MavlinkSignatureCounters counts, out long rejected)
    {
        counts = _signatures;
        rejected = counts.Rejected - _reportedRejections;
        if (rejected == 0 || counts.Rejected < 2 * _reportedRejections)
            return false;
        _reportedRejections = counts.Rejected;
        return true;
    }

    /// <returns>Whether it is on its way.</returns>
    public bool Send(in MavlinkFrame frame, TimeSpan now)
    {
        if (writer is null)
            return false;
        bool isSent = !IsUnconnected(writer);
        if (isSent && _hold is not null)
            _hold.Add(frame, now);
        else if (isSent)
            isSent = _output!.Send(frame);
        if (!isSent)
        {
            _rejectedOut++;
            return false;
        }

        _framesOut++;
        return true;
    }

    /// <summary>When frames that wait for others are to go out; the longest time where none do.</summary>
    public TimeSpan FlushDue => _hold?.Due ?? TimeSpan.MaxValue;

    /// <summary>Lets go frames that wait for others.</summary>
    public void Flush() => _hold?.Flush();

    /// <summary>Whether the link carries frames that we send: it is open, and not for receiving only.</summary>
    public bool IsSending => writer is not null && !settings.IsReceiveOnly && !IsOpening && !IsUnconnected(writer);

    /// <summary>
    /// Whether the link can carry a frame of vehicle messages of this class now: it is open, within the limit of such
    /// messages, and not many of the class wait for their turn already.
    /// </summary>
    public bool HasRoom(SendClass sendClass, TimeSpan now)
        => IsSending && rateLimiter.HasRoom(MaxTunnelLength, now)
            && (Scheduler is null || Scheduler.WaitingOf(sendClass) < MaxWaitingMessages);

    /// <summary>How long until their limit lets the longest of them through.</summary>
    public TimeSpan TimeToRoom(TimeSpan now) => rateLimiter.TimeToRoom(MaxTunnelLength, now);

    /// <summary>Counts a frame of vehicle messages against their limit.</summary>
    public void TakeRate(in MavlinkFrame frame) => rateLimiter.Take(frame.WireLength);

    public void PostStatus(TimeSpan now, TimeSpan silentAfter, long droppedIn)
    {
        // Where the other end closed the link, that our next write then fails is no news.
        Exception? fault = Reader.State == DeviceState.Ended ? null : Reader.Fault ?? writer?.Fault;
        QueueCounters incoming = Reader.Counters;
        long lostOut = CountLostOut();
        status.Value = new LinkStatus
        {
            State = StateAt(now, silentAfter, fault),
            Url = url,
            Fault = fault?.Message ?? (IsOpening ? link!.LastFault : null),
            LastFrameTime = _lastFrameTime,
            GroundStationTime = _groundStationTime,
            FramesIn = tally.Frames,
            FramesOut = _framesOut - lostOut,
            FramesMissing = tally.Missing,
            BytesLost = bytesLost(),
            FramesDroppedIn = droppedIn + incoming.Dropped + incoming.Rejected + DiscardedIn,
            FramesDroppedOut = _rejectedOut + lostOut + (Scheduler?.Dropped ?? 0),
            Budget = Scheduler?.Status(now) ?? default,
            FramesDuplicate = _duplicates,
            AddressConflicts = AddressConflicts,
            Signatures = _signatures,
            FramesFilteredIn = _filteredIn,
            FramesFilteredOut = _filteredOut,
            Name = settings.Name,
            IsOptional = settings.IsOptional,
            Openings = link?.Counters.Openings ?? 0,
            Progress = file?.Progress ?? double.NaN,
        };
        status.Post();
    }

    public LinkSummary Summarise()
        => new(
            url, tally.Frames, tally.Counts(), tally.Sources(), bytesLost(), file?.FirstDamageOffset,
            incompatibleFrames(), tally.NotListed, file?.MendedFrames ?? 0, file?.RefusedFrames);

    // What a log still held when the run was stopped was not dropped: it is in the log.
    private long DiscardedIn => IsRecorded ? 0 : Reader.Discarded;

    private long CountLostOut()
    {
        if (writer is null)
            return 0;
        QueueCounters outgoing = writer.Counters;
        return outgoing.Dropped + target!.Lost + (writer.State == DeviceState.Faulted ? outgoing.Resident : 0);
    }

    private bool IsOpening => link?.State is ByteLinkState.Opening or ByteLinkState.WaitingToReopen;

    private bool IsUnconnected(BlockingWriter<FrameToWrite> writer)
        => Reader.State == DeviceState.Ended || writer.State is DeviceState.Faulted or DeviceState.Ended;

    private LinkState StateAt(TimeSpan now, TimeSpan silentAfter, Exception? fault)
    {
        if (fault is not null)
            return LinkState.Failed;
        if (HasEnded)
            return LinkState.Ended;
        if (IsOpening)
            return LinkState.Opening;
        if (_lastFrameTime is not { } last)
            return LinkState.Waiting;
        return now - last > silentAfter ? LinkState.Silent : LinkState.Receiving;
    }
}
