using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Text;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

// Answers to requests.
public sealed partial class MavlinkFtpServer
{
    private const int CountLength = 4;

    private void Answer(MavlinkAddress source, TimeSpan now)
    {
        uint hash = HashOf(_request.Bytes);
        int place = StationOf(source);
        ref LastAnswer last = ref _last[place];
        if (last.Source == source && last.RequestHash == hash && _request.Opcode != FtpOpcode.BurstReadFile)
        {
            Repeats++;
            Enqueue(last.Message);
            return;
        }

        _answer.Clear();
        _answer.Sequence = (ushort)(_request.Sequence + 1);
        _answer.Session = _request.Session;
        _answer.RequestOpcode = _request.Opcode;
        _answer.Offset = _request.Offset;
        _answer.Opcode = FtpOpcode.Ack;
        FtpError error = Execute(source, now, out bool isAnswered);
        if (!isAnswered)
            return;
        if (error != FtpError.None)
            Refuse(error);
        FileTransferProtocol message = MessageTo(source);
        last = new LastAnswer { Source = source, RequestHash = hash, Message = message };
        Enqueue(message);
    }

    private FtpError Execute(MavlinkAddress source, TimeSpan now, out bool isAnswered)
    {
        isAnswered = true;
        if (_request.Size > FtpPacket.MaxData)
            return FtpError.InvalidDataSize;
        switch (_request.Opcode)
        {
            case FtpOpcode.None:
                return FtpError.None;
            case FtpOpcode.TerminateSession:
                return Terminate(source);
            case FtpOpcode.ResetSessions:
                foreach (FtpSession session in _sessions)
                {
                    if (session.IsOpen && session.Source == source)
                        session.Close();
                }

                return FtpError.None;
            case FtpOpcode.ListDirectory:
                return List();
            case FtpOpcode.OpenFileReadOnly:
                return Open(source, now);
            case FtpOpcode.ReadFile:
                return Read(source, now);
            case FtpOpcode.BurstReadFile:
                FtpError error = StartBurst(source, now);
                isAnswered = error != FtpError.None;
                return error;
            case FtpOpcode.CalculateCrc32:
                return TryGetFile(out ReadOnlyMemory<byte> content)
                    ? AnswerNumber(HashOf(content.Span))
                    : FtpError.FileNotFound;
            case FtpOpcode.CreateFile or FtpOpcode.WriteFile or FtpOpcode.RemoveFile or FtpOpcode.CreateDirectory
                or FtpOpcode.RemoveDirectory or FtpOpcode.OpenFileWriteOnly or FtpOpcode.TruncateFile
                or FtpOpcode.Rename:
                return FtpError.FileProtected;
            default:
                return FtpError.UnknownCommand;
        }
    }

    private FtpError Terminate(MavlinkAddress source)
    {
        FtpSession? session = SessionOf(source);
        session?.Close();
        return session is null ? FtpError.InvalidSession : FtpError.None;
    }

    private FtpError Open(MavlinkAddress source, TimeSpan now)
    {
        if (!TryGetFile(out ReadOnlyMemory<byte> content))
            return FtpError.FileNotFound;
        int free = Array.FindIndex(_sessions, session => !session.IsOpen);
        if (free < 0)
            return FtpError.NoSessionsAvailable;
        _sessions[free].Open(source, content, now);
        _answer.Session = (byte)free;
        return AnswerNumber((uint)content.Length);
    }

    private FtpError Read(MavlinkAddress source, TimeSpan now)
    {
        if (SessionOf(source) is not { } session)
            return FtpError.InvalidSession;
        session.UsedAt = now;
        session.BurstLeft = 0;
        if (_request.Offset >= session.Content.Length)
            return FtpError.EndOfFile;
        Copy(session.Content.Span.Slice((int)_request.Offset), _request.Size);
        return FtpError.None;
    }

    private FtpError StartBurst(MavlinkAddress source, TimeSpan now)
    {
        if (SessionOf(source) is not { } session)
            return FtpError.InvalidSession;
        session.UsedAt = now;
        session.BurstLeft = 0;
        if (_request.Offset >= session.Content.Length)
            return FtpError.EndOfFile;
        session.BurstLeft = _options.BurstPackets;
        session.BurstOffset = _request.Offset;
        session.BurstSize = _request.Size == 0 ? (byte)FtpPacket.MaxData : _request.Size;
        session.BurstSequence = _request.Sequence;
        session.BurstDue = now;
        return FtpError.None;
    }

    private MavlinkFrame NextOfBurst(int index, TimeSpan now)
    {
        FtpSession session = _sessions[index];
        _answer.Clear();
        _answer.Sequence = ++session.BurstSequence;
        _answer.Session = (byte)index;
        _answer.Opcode = FtpOpcode.Ack;
        _answer.RequestOpcode = FtpOpcode.BurstReadFile;
        _answer.Offset = (uint)session.BurstOffset;
        Copy(session.Content.Span.Slice((int)session.BurstOffset), session.BurstSize);
        session.BurstOffset += _answer.Size;
        session.BurstLeft--;
        if (session.BurstOffset >= session.Content.Length)
            session.BurstLeft = 0;
        _answer.IsBurstComplete = session.BurstLeft == 0;
        session.BurstDue = now + _options.BurstInterval;
        session.UsedAt = now;
        return _sender.Create(MessageTo(session.Source));
    }

    // "Fname\tsize" of a file, "Dname" of a directory, each ended by a zero. The offset counts entries.
    private FtpError List()
    {
        if (!TryGetPath(out string path) || !_files.TryGetDirectory(path, out IReadOnlyList<MavlinkFileEntry> entries))
            return FtpError.FileNotFound;
        if (_request.Offset >= entries.Count)
            return FtpError.EndOfFile;
        int used = 0;
        for (int i = (int)_request.Offset; i < entries.Count; i++)
        {
            string text = entries[i].IsDirectory
                ? $"D{entries[i].Name}\0"
                : FormattableString.Invariant($"F{entries[i].Name}\t{entries[i].Size}\0");
            byte[] bytes = Encoding.UTF8.GetBytes(text);
            if (bytes.Length > FtpPacket.MaxData)
                bytes = [(byte)'S', 0];   // skipped: it does not fit into a packet
            if (used + bytes.Length > FtpPacket.MaxData)
                break;
            bytes.CopyTo(_answer.Data.Slice(used));
            used += bytes.Length;
        }

        _answer.Size = (byte)used;
        return FtpError.None;
    }

    private bool TryGetFile(out ReadOnlyMemory<byte> content)
    {
        content = default;
        return TryGetPath(out string path) && _files.TryGetFile(path, out content);
    }

    // The path is as long as the request says, or ends at a zero before.
    private bool TryGetPath(out string path)
    {
        Span<byte> data = _request.Data.Slice(0, _request.Size);
        int end = data.IndexOf((byte)0);
        string text = Encoding.UTF8.GetString(data.Slice(0, end < 0 ? data.Length : end).ToArray());
        return TryNormalise(text, out path);
    }

    private FtpSession? SessionOf(MavlinkAddress source)
        => _request.Session < _sessions.Length && _sessions[_request.Session] is { IsOpen: true } session
            && session.Source == source
            ? session
            : null;

    private FtpError AnswerNumber(uint number)
    {
        _answer.Size = CountLength;
        BinaryPrimitives.WriteUInt32LittleEndian(_answer.Data, number);
        return FtpError.None;
    }

    private void Copy(ReadOnlySpan<byte> content, int size)
    {
        ReadOnlySpan<byte> part = content.Slice(0, Math.Min(size, content.Length));
        part.CopyTo(_answer.Data);
        _answer.Size = (byte)part.Length;
    }

    private void Refuse(FtpError error)
    {
        if (error != FtpError.EndOfFile)
            Refusals++;
        _answer.Opcode = FtpOpcode.Nak;
        _answer.Size = 1;
        _answer.Data.Clear();
        _answer.Data[0] = (byte)error;
    }

    private FileTransferProtocol MessageTo(MavlinkAddress target) => new()
    {
        TargetSystem = target.SystemId,
        TargetComponent = target.ComponentId,
        Payload = new ByteArray251(_answer.Bytes),
    };

    private void Enqueue(in FileTransferProtocol message)
    {
        if (_answerCount == _answers.Length)
        {
            Dropped++;
            return;
        }

        _answers[(_firstAnswer + _answerCount) % _answers.Length] = message;
        _answerCount++;
    }

    // The place of a station's last answer; a new station takes that of the one that came longest ago.
    private int StationOf(MavlinkAddress source)
    {
        for (int i = 0; i < _last.Length; i++)
        {
            if (_last[i].Source == source)
                return i;
        }

        _nextStation = (_nextStation + 1) % _last.Length;
        return _nextStation;
    }

    private static uint HashOf(ReadOnlySpan<byte> bytes)
    {
        uint hash = 0;
        foreach (byte value in bytes)
            hash = MavlinkParameterHash.Add(hash, value);
        return hash;
    }
}
