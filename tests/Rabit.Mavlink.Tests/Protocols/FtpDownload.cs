using System;
using System.Text;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// Downloads one file as a ground station does: opens it, reads bursts from the first byte that is missing on, asks for
/// the checksum, closes it. A request without an answer is sent again with the same number.
/// </summary>
internal sealed class FtpDownload(string path, MavlinkSender sender)
{
    private static readonly TimeSpan AnswerTimeout = TimeSpan.FromSeconds(0.7);
    private readonly FtpPacket _packet = new();
    private FtpOpcode _step = FtpOpcode.OpenFileReadOnly;
    private ushort _sequence = 100;
    private byte _session;
    private bool[] _known = [];

    public byte[] Content { get; private set; } = [];

    public uint Checksum { get; private set; }

    public bool IsOver { get; private set; }

    public FtpError Error { get; private set; }

    public TimeSpan NextDue { get; private set; }

    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (IsOver || now < NextDue)
            return false;
        NextDue = now + AnswerTimeout;
        _packet.Clear();
        _packet.Sequence = _sequence;
        _packet.Opcode = _step;
        _packet.Session = _session;
        if (_step is FtpOpcode.OpenFileReadOnly or FtpOpcode.CalculateCrc32)
        {
            byte[] name = Encoding.UTF8.GetBytes(path);
            name.CopyTo(_packet.Data);
            _packet.Size = (byte)name.Length;
        }
        else if (_step == FtpOpcode.BurstReadFile)
        {
            _packet.Offset = (uint)Array.IndexOf(_known, false);
            _packet.Size = FtpPacket.MaxData;
        }

        frame = sender.Create(new FileTransferProtocol
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Payload = new ByteArray251(_packet.Bytes),
        });
        return true;
    }

    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (IsOver || !frame.TryDecode(out FileTransferProtocol message))
            return;
        message.Payload.CopyTo(_packet.Bytes);
        bool isBurst = _packet.RequestOpcode == FtpOpcode.BurstReadFile;
        if (_packet.RequestOpcode != _step || (!isBurst && _packet.Sequence != (ushort)(_sequence + 1)))
            return;
        if (_packet.Opcode == FtpOpcode.Nak)
        {
            Error = (FtpError)_packet.Data[0];
            IsOver = true;
            return;
        }

        Take(now);
    }

    private void Take(TimeSpan now)
    {
        switch (_step)
        {
            case FtpOpcode.OpenFileReadOnly:
                _session = _packet.Session;
                Content = new byte[BitConverter.ToUInt32(_packet.Data.ToArray(), 0)];
                _known = new bool[Content.Length];
                Next(_known.Length > 0 ? FtpOpcode.BurstReadFile : FtpOpcode.CalculateCrc32, now);
                break;
            case FtpOpcode.BurstReadFile:
                NextDue = now + AnswerTimeout;
                _packet.Data.Slice(0, _packet.Size).CopyTo(Content.AsSpan((int)_packet.Offset));
                for (int i = 0; i < _packet.Size; i++)
                    _known[_packet.Offset + i] = true;
                if (Array.IndexOf(_known, false) < 0)
                    Next(FtpOpcode.CalculateCrc32, now);
                else if (_packet.IsBurstComplete)
                    Next(FtpOpcode.BurstReadFile, now);
                break;
            case FtpOpcode.CalculateCrc32:
                Checksum = BitConverter.ToUInt32(_packet.Data.ToArray(), 0);
                Next(FtpOpcode.TerminateSession, now);
                break;
            default:
                IsOver = true;
                break;
        }
    }

    private void Next(FtpOpcode step, TimeSpan now)
    {
        _step = step;
        _sequence += 1000;
        NextDue = now;
    }
}
