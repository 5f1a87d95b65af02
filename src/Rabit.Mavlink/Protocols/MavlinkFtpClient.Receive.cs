using System;
using System.Buffers.Binary;
using System.Globalization;
using System.Text;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

// Answers.
public sealed partial class MavlinkFtpClient
{
    private const int NumberLength = 4;

    /// <summary>Answers that belong to nothing that was requested: copies and late ones.</summary>
    public long StrayAnswers { get; private set; }

    /// <summary>Handles a received frame; all but answers of the component to us are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.MessageId != FileTransferProtocol.MavlinkId
            || new MavlinkAddress(frame.SystemId, frame.ComponentId) != _target
            || !frame.TryDecode(out FileTransferProtocol message)
            || message.TargetSystem != _sender.SystemId || message.TargetComponent != _sender.ComponentId)
            return;
        message.Payload.CopyTo(_packet.Bytes);
        if (_packet.Size > FtpPacket.MaxData || _packet.Opcode is not (FtpOpcode.Ack or FtpOpcode.Nak))
            return;
        bool isOld = (short)(ushort)(_packet.Sequence - _firstSequence) < 0;
        if (_step == FtpOpcode.None || isOld)
        {
            StrayAnswers++;
            return;
        }

        _lastAnswer = (short)(ushort)(_packet.Sequence - _lastAnswer) > 0 ? _packet.Sequence : _lastAnswer;
        bool isData = _packet.Opcode == FtpOpcode.Ack
            && _packet.RequestOpcode is FtpOpcode.BurstReadFile or FtpOpcode.ReadFile;
        if (isData && _step is FtpOpcode.BurstReadFile or FtpOpcode.ReadFile && _packet.Session == _session)
            TakeData(now);
        else if (_packet.RequestOpcode != _step || _packet.Sequence != (ushort)(_sequence + 1))
            StrayAnswers++;
        else if (_packet.Opcode == FtpOpcode.Nak)
            TakeRefusal(now);
        else
            TakeAnswer(now);
    }

    private void TakeAnswer(TimeSpan now)
    {
        switch (_step)
        {
            case FtpOpcode.ListDirectory:
                TakeEntries(now);
                break;
            case FtpOpcode.OpenFileReadOnly when _packet.Size >= NumberLength:
                TakeSize(BinaryPrimitives.ReadUInt32LittleEndian(_packet.Data), now);
                break;
            case FtpOpcode.CalculateCrc32 when _packet.Size >= NumberLength:
                _isChecked = BinaryPrimitives.ReadUInt32LittleEndian(_packet.Data) == Checksum();
                End(_isChecked ? MavlinkFtpStatus.Done : MavlinkFtpStatus.WrongChecksum, 0, now);
                break;
            case FtpOpcode.TerminateSession:
                Complete(now);
                break;
            default:
                // Without the number that it is for it says nothing: asked again in time.
                StrayAnswers++;
                break;
        }
    }

    private void TakeRefusal(TimeSpan now)
    {
        var error = (FtpError)(_packet.Size > 0 ? _packet.Data[0] : 0);
        switch (_step)
        {
            case FtpOpcode.ListDirectory when error == FtpError.EndOfFile:
                End(MavlinkFtpStatus.Done, 0, now);
                break;
            case FtpOpcode.BurstReadFile or FtpOpcode.ReadFile
                when error == FtpError.InvalidSession && _reopens < MaxReopens:
                // It has closed the file: after a time, or by a late copy of an earlier request.
                _reopens++;
                _isOpen = false;
                Go(FtpOpcode.OpenFileReadOnly, now);
                break;
            case FtpOpcode.BurstReadFile when error == FtpError.UnknownCommand:
                _hasBursts = false;
                ContinueReading(now);
                break;
            case FtpOpcode.CalculateCrc32 when error == FtpError.UnknownCommand:
                End(MavlinkFtpStatus.Done, 0, now);
                break;
            case FtpOpcode.TerminateSession:
                Complete(now);
                break;
            default:
                End(
                    error == FtpError.FileNotFound ? MavlinkFtpStatus.NotFound : MavlinkFtpStatus.Refused, (int)error,
                    now);
                break;
        }
    }

    private void TakeSize(uint size, TimeSpan now)
    {
        _isOpen = true;
        _session = _packet.Session;
        if (size > _options.MaxFileSize)
        {
            End(MavlinkFtpStatus.TooLarge, 0, now);
            return;
        }

        // Opened again it goes on; that it is the same file the checksum shows.
        if (_reopens == 0 || size != _content.Length)
        {
            _content = new byte[size];
            _gaps.Reset(size);
        }

        ContinueReading(now);
    }

    // Late packets of an earlier burst are of the same file: they count too.
    private void TakeData(TimeSpan now)
    {
        long start = _packet.Offset;
        long end = Math.Min(start + _packet.Size, _content.Length);
        if (start >= end || !_gaps.Fill(start, end))
        {
            StrayAnswers++;
        }
        else
        {
            _packet.Data.Slice(0, (int)(end - start)).CopyTo(_content.AsSpan((int)start));
            _tries = Math.Min(_tries, 1);
            _due = now + _options.AnswerTimeout;
        }

        bool isAnswered = _packet.RequestOpcode == _step
            && (_step == FtpOpcode.BurstReadFile
                ? _packet.IsBurstComplete
                : _packet.Sequence == (ushort)(_sequence + 1));
        if (_gaps.IsEmpty || isAnswered)
            ContinueReading(now);
    }

    private void ContinueReading(TimeSpan now)
    {
        if (_gaps.IsEmpty)
        {
            Go(FtpOpcode.CalculateCrc32, now);
            return;
        }

        Go(FtpOpcode.ReadFile, now);
        ChooseRead();
    }

    // "Fname\tsize" of a file, "Dname" of a directory, "S" of what is skipped, each ended by a zero.
    private void TakeEntries(TimeSpan now)
    {
        int before = _listOffset;
        ReadOnlySpan<byte> rest = _packet.Data.Slice(0, _packet.Size);
        while (rest.Length > 0)
        {
            int end = rest.IndexOf((byte)0);
            string text = Encoding.UTF8.GetString(rest.Slice(0, end < 0 ? rest.Length : end).ToArray());
            rest = end < 0 ? default : rest.Slice(end + 1);
            if (text.Length == 0)
                continue;
            _listOffset++;
            if (_entries.Count < _options.MaxEntries && TryRead(text, out MavlinkFileEntry entry))
                _entries.Add(entry);
        }

        // A packet without an entry would be asked for forever.
        if (_listOffset == before || _entries.Count >= _options.MaxEntries)
            End(MavlinkFtpStatus.Done, 0, now);
        else
            Go(FtpOpcode.ListDirectory, now);
    }

    private static bool TryRead(string text, out MavlinkFileEntry entry)
    {
        string[] parts = text.Split('\t');
        long size = 0;
        bool isDirectory = text[0] == 'D';
        bool isFile = text[0] == 'F' && parts.Length == 2
            && long.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out size);
        bool isNamed = (isDirectory || isFile) && parts[0].Length > 1;
        entry = isNamed ? new MavlinkFileEntry(parts[0].Substring(1), size, isDirectory) : default;
        return isNamed;
    }

    private uint Checksum()
    {
        uint hash = 0;
        foreach (byte value in _content)
            hash = MavlinkParameterHash.Add(hash, value);
        return hash;
    }
}
