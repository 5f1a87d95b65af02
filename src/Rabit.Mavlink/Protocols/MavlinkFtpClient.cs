using System;
using System.Collections.Generic;
using System.Text;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Reads the files of one component (MAVLink guide, "File Transfer Protocol"): lists directories, reads files in bursts
/// and checks them by their checksum, one transfer after another, each with exactly one outcome. No I/O, no clock:
/// frames in, frames out, time as argument. One thread; allocates for a transfer, nothing per packet of data.
/// </summary>
/// <remarks>
/// Packets of a burst that were lost are read again: small gaps one by one, large ones by another burst. A component
/// without bursts, or without checksums, is read without them.
/// </remarks>
/// <example>
/// <code>
/// var client = new MavlinkFtpClient(new MavlinkSender(255, 190), new MavlinkAddress(1, 191));
/// client.TryStartRead("targets/track-001.png", TimeSpan.Zero);
///
/// // For every frame that arrives: client.Handle(frame, now). After that, and at client.NextDue at the latest:
/// static void Step(MavlinkFtpClient client, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (client.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     if (client.TryTakeOutcome(out MavlinkFtpOutcome outcome))
///         Console.WriteLine($"{outcome.Status}, {client.Content.Length} bytes");
/// }
/// </code>
/// </example>
public sealed partial class MavlinkFtpClient
{
    // Packets of a burst have numbers of their own; those of one that a transfer has left behind are below the next.
    private const int SequenceStep = 1000;

    // A gap of so many packets is read by bursts.
    private const int MaxSingleReads = 4;
    private const int MaxTriesToClose = 2;
    private const int MaxReopens = 3;

    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress _target;
    private readonly MavlinkFtpClientOptions _options;
    private readonly FtpPacket _packet = new();
    private readonly FtpGaps _gaps = new();
    private readonly List<MavlinkFileEntry> _entries = [];
    private byte[] _path = [];
    private byte[] _content = [];
    private bool _isReading;
    private bool _hasBursts;

    // What is requested, by which number, how often it was, and when again. None: nothing is under way.
    private FtpOpcode _step;
    private ushort _sequence;
    private ushort _firstSequence;
    private ushort _lastAnswer;
    private byte _session;
    private bool _isOpen;
    private int _reopens;
    private int _listOffset;
    private int _tries;
    private int _sent;
    private TimeSpan _due;

    // What comes of it, once the file is closed.
    private (MavlinkFtpStatus Status, int Error) _result;
    private bool _isChecked;
    private MavlinkFtpOutcome? _outcome;

    /// <summary>Makes a client.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="target">Whose files.</param>
    /// <param name="options">Times and limits; null for the defaults.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentException">The target is not one component.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A time or limit is out of range.</exception>
    public MavlinkFtpClient(MavlinkSender sender, MavlinkAddress target, MavlinkFtpClientOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        if (target.SystemId == 0 || target.ComponentId == 0)
            throw new ArgumentException("Files belong to one component; 0 means all.", nameof(target));
        _target = target;
        _options = options ?? new MavlinkFtpClientOptions();
        if (_options.AnswerTimeout <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(
                nameof(options), _options.AnswerTimeout, "The time for an answer is above 0.");
        if (_options.Retries < 0 || _options.MaxFileSize < 0 || _options.MaxEntries < 0)
            throw new ArgumentOutOfRangeException(
                nameof(options), _options.Retries, "Retries, and the limits of files and directories, are at min 0.");
    }

    /// <summary>Whether a transfer is under way, or its outcome not taken yet: no other can start.</summary>
    public bool IsBusy => _step != FtpOpcode.None || _outcome is not null;

    /// <summary>What was read last, until the next transfer begins; only what is there of a file that failed.</summary>
    public ReadOnlyMemory<byte> Content => _content;

    /// <summary>What was listed last, until the next transfer begins.</summary>
    public IReadOnlyList<MavlinkFileEntry> Entries => _entries;

    /// <summary>How many bytes of the file are here.</summary>
    public int BytesDone => (int)(_content.Length - _gaps.Bytes);

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for.
    /// </summary>
    public TimeSpan NextDue => _step == FtpOpcode.None ? TimeSpan.MaxValue : _due;

    /// <summary>Starts to read a file.</summary>
    /// <param name="path">Its path, names with '/' between them; at most 239 bytes.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    /// <exception cref="ArgumentException">No path that fits.</exception>
    public bool TryStartRead(string path, TimeSpan now)
        => TryStart(path, FtpOpcode.OpenFileReadOnly, now);

    /// <summary>Starts to list a directory.</summary>
    /// <param name="path">Its path; "/" is the root.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    /// <exception cref="ArgumentException">No path that fits.</exception>
    public bool TryStartList(string path, TimeSpan now) => TryStart(path, FtpOpcode.ListDirectory, now);

    /// <summary>Ends the transfer; the file is closed first.</summary>
    /// <param name="now">The time.</param>
    public void Cancel(TimeSpan now)
    {
        if (_step != FtpOpcode.None && _step != FtpOpcode.TerminateSession)
            End(MavlinkFtpStatus.Cancelled, 0, now);
    }

    /// <summary>Takes the outcome of the last transfer; it is returned once.</summary>
    /// <param name="outcome">The outcome.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeOutcome(out MavlinkFtpOutcome outcome)
    {
        outcome = _outcome ?? default;
        bool had = _outcome is not null;
        _outcome = null;
        return had;
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (_step == FtpOpcode.None || now < _due)
            return false;
        int most = _step == FtpOpcode.TerminateSession ? MaxTriesToClose : _options.Retries + 1;
        if (_tries >= most)
        {
            // A file that is not closed is closed by the component in time.
            if (_step == FtpOpcode.TerminateSession)
                Complete(now);
            else
                End(MavlinkFtpStatus.Unanswered, 0, now);
            return TryTakeFrame(now, out frame);
        }

        // A burst that went dry goes on from its first gap: another request.
        if (_tries > 0 && _step is FtpOpcode.BurstReadFile or FtpOpcode.ReadFile)
            ChooseRead();
        _tries++;
        _sent++;
        _due = now + _options.AnswerTimeout;
        frame = Request();
        return true;
    }

    private bool TryStart(string path, FtpOpcode step, TimeSpan now)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(path ?? throw new ArgumentNullException(nameof(path)));
        if (bytes.Length is 0 or > FtpPacket.MaxData || Array.IndexOf(bytes, (byte)0) >= 0)
            throw new ArgumentException(
                $"'{path}' has {bytes.Length} bytes; a path has 1 to {FtpPacket.MaxData}, without a zero.",
                nameof(path));
        if (IsBusy)
            return false;
        (_path, _content, _isReading) = (bytes, [], step == FtpOpcode.OpenFileReadOnly);
        _entries.Clear();
        _gaps.Reset(0);
        (_isOpen, _isChecked, _hasBursts) = (false, false, true);
        (_listOffset, _sent, _session, _reopens) = (0, 0, 0, 0);
        _result = (MavlinkFtpStatus.Done, 0);
        _sequence = _firstSequence = (ushort)(_lastAnswer + SequenceStep);
        Go(step, now);
        return true;
    }

    private void Go(FtpOpcode step, TimeSpan now)
    {
        _step = step;
        _sequence++;
        _tries = 0;
        _due = now;
    }

    private void ChooseRead()
    {
        (long from, long to) = _gaps.First;
        _step = _hasBursts && to - from > MaxSingleReads * FtpPacket.MaxData
            ? FtpOpcode.BurstReadFile
            : FtpOpcode.ReadFile;
        _sequence++;
    }

    private void End(MavlinkFtpStatus status, int error, TimeSpan now)
    {
        _result = (status, error);
        if (_isOpen)
            Go(FtpOpcode.TerminateSession, now);
        else
            Complete(now);
    }

    private void Complete(TimeSpan now)
    {
        _step = FtpOpcode.None;
        _isOpen = false;
        _outcome = new MavlinkFtpOutcome(_result.Status, _result.Error, _isChecked, _sent, now);
    }

    private MavlinkFrame Request()
    {
        _packet.Clear();
        _packet.Sequence = _sequence;
        _packet.Opcode = _step;
        _packet.Session = _session;
        switch (_step)
        {
            case FtpOpcode.BurstReadFile or FtpOpcode.ReadFile:
                (long from, long to) = _gaps.First;
                _packet.Offset = (uint)from;
                _packet.Size = (byte)(_step == FtpOpcode.BurstReadFile
                    ? FtpPacket.MaxData
                    : Math.Min(FtpPacket.MaxData, to - from));
                break;
            case FtpOpcode.TerminateSession: break;
            default:
                _path.CopyTo(_packet.Data);
                _packet.Size = (byte)_path.Length;
                _packet.Offset = (uint)(_step == FtpOpcode.ListDirectory ? _listOffset : 0);
                break;
        }

        return _sender.Create(new FileTransferProtocol
        {
            TargetSystem = _target.SystemId,
            TargetComponent = _target.ComponentId,
            Payload = new ByteArray251(_packet.Bytes),
        });
    }
}
