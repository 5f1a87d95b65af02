using System;
using System.Collections.Generic;
using System.Text;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Serves files to be read (MAVLink guide, "File Transfer Protocol"): lists directories, opens, reads, reads in bursts,
/// computes CRC-32. Everything that would write is refused. No I/O, no clock: frames in, frames out, time as argument.
/// One thread; nothing is allocated per packet of data.
/// </summary>
/// <remarks>
/// A request that is received again, with the same number from the same station, gets the same answer and is not
/// executed again. A path may not leave the root: "..", ".", '\' and control characters are no names. Open files are
/// limited, belong to the station that opened them, and are closed when no request comes for them.
/// </remarks>
/// <example>
/// <code>
/// var files = new MavlinkMemoryFiles();
/// files.Set("targets/1.jpg", new byte[] { 0xFF, 0xD8 });
/// var server = new MavlinkFtpServer(new MavlinkSender(1, 191), files);
///
/// // For every frame that arrives: server.Handle(frame, now). After that, and at server.NextDue at the latest:
/// static void Step(MavlinkFtpServer server, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (server.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
/// }
/// </code>
/// </example>
public sealed partial class MavlinkFtpServer
{
    private const int Stations = 4;

    private readonly MavlinkSender _sender;
    private readonly IMavlinkFileStore _files;
    private readonly MavlinkFtpServerOptions _options;
    private readonly FtpSession[] _sessions;
    private readonly FtpPacket _request = new();
    private readonly FtpPacket _answer = new();
    private readonly FileTransferProtocol[] _answers;
    private readonly LastAnswer[] _last = new LastAnswer[Stations];
    private int _firstAnswer;
    private int _answerCount;
    private int _nextStation;

    /// <summary>Makes a server.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures; it is who is asked.</param>
    /// <param name="files">The files.</param>
    /// <param name="options">Limits and times; null for the defaults.</param>
    /// <exception cref="ArgumentNullException">No sender, or no files.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A limit or time is out of range.</exception>
    public MavlinkFtpServer(MavlinkSender sender, IMavlinkFileStore files, MavlinkFtpServerOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        _files = files ?? throw new ArgumentNullException(nameof(files));
        _options = options ?? new MavlinkFtpServerOptions();
        if (_options.MaxSessions is < 1 or > byte.MaxValue)
            throw new ArgumentOutOfRangeException(nameof(options), _options.MaxSessions, "1 to 255 sessions.");
        if (_options.BurstPackets < 1 || _options.Capacity < 1)
            throw new ArgumentOutOfRangeException(
                nameof(options), _options.BurstPackets, "A burst and the capacity are at min 1.");
        if (_options.BurstInterval <= TimeSpan.Zero || _options.SessionTimeout <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(
                nameof(options), _options.BurstInterval, "The burst interval and the session timeout are above 0.");
        _sessions = new FtpSession[_options.MaxSessions];
        for (int i = 0; i < _sessions.Length; i++)
            _sessions[i] = new FtpSession();
        _answers = new FileTransferProtocol[_options.Capacity];
    }

    /// <summary>How many files are open.</summary>
    public int OpenSessions
    {
        get
        {
            int open = 0;
            foreach (FtpSession session in _sessions)
                open += session.IsOpen ? 1 : 0;
            return open;
        }
    }

    /// <summary>Requests that were received again, and answered as before.</summary>
    public long Repeats { get; private set; }

    /// <summary>Requests that were refused; the end of a file and of a directory do not count.</summary>
    public long Refusals { get; private set; }

    /// <summary>Answers that were not sent, since too many were waiting.</summary>
    public long Dropped { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for. A time in the past means at once.
    /// </summary>
    public TimeSpan NextDue
    {
        get
        {
            if (_answerCount > 0)
                return TimeSpan.Zero;
            TimeSpan next = TimeSpan.MaxValue;
            foreach (FtpSession session in _sessions)
            {
                if (session.BurstLeft > 0 && session.BurstDue < next)
                    next = session.BurstDue;
            }

            return next;
        }
    }

    /// <summary>Handles a received frame; all but file transfers for us are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.MessageId != FileTransferProtocol.MavlinkId || !frame.TryDecode(out FileTransferProtocol message)
            || message.TargetSystem != _sender.SystemId || message.TargetComponent != _sender.ComponentId)
            return;
        CloseUnused(now);
        message.Payload.CopyTo(_request.Bytes);

        // Answers to a client of ours are no requests: two servers would refuse each other's refusals without end.
        if (_request.Opcode is FtpOpcode.Ack or FtpOpcode.Nak)
            return;
        Answer(new MavlinkAddress(frame.SystemId, frame.ComponentId), now);
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        if (_answerCount > 0)
        {
            frame = _sender.Create(_answers[_firstAnswer]);
            _firstAnswer = (_firstAnswer + 1) % _answers.Length;
            _answerCount--;
            return true;
        }

        for (int i = 0; i < _sessions.Length; i++)
        {
            if (_sessions[i].BurstLeft > 0 && now >= _sessions[i].BurstDue)
            {
                frame = NextOfBurst(i, now);
                return true;
            }
        }

        frame = default;
        return false;
    }

    /// <summary>Checks a path, and brings it into one form: names with '/' between them.</summary>
    internal static bool TryNormalise(string path, out string normal)
    {
        normal = "";
        if (path is null)
            return false;
        var names = new List<string>();
        foreach (string name in path.Split('/'))
        {
            if (name is "." or "..")
                return false;
            foreach (char character in name)
            {
                if (character < ' ' || character is '\\' or '\x7F' or '\uFFFD')
                    return false;
            }

            if (name.Length > 0)
                names.Add(name);
        }

        normal = string.Join("/", names);
        return Encoding.UTF8.GetByteCount(normal) <= FtpPacket.MaxData - 1;
    }

    private void CloseUnused(TimeSpan now)
    {
        foreach (FtpSession session in _sessions)
        {
            if (session.IsOpen && now - session.UsedAt > _options.SessionTimeout)
                session.Close();
        }
    }

    /// <summary>What a station was answered last, in case it has not received it.</summary>
    private struct LastAnswer
    {
        public MavlinkAddress Source;
        public uint RequestHash;
        public FileTransferProtocol Message;
    }
}
