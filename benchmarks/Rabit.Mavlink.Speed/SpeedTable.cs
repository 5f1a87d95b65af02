using System;
using System.Globalization;
using System.IO;

namespace Rabit.Mavlink.Speed;

/// <summary>Measures and prints the table of one set of frames.</summary>
internal sealed class SpeedTable
{
    private const int ChunkLength = 1024;

    // Signing takes twenty times as long as framing: with all frames no pass would be short.
    private const int FewFrames = 1000;

    private readonly FrameSet _set;
    private readonly byte[] _copy;
    private readonly byte[] _wire = new byte[MavlinkFrame.MaximumWireLength];
    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
    private readonly MavlinkSender _sender = new(1, 191);
    private readonly MavlinkSender _signingSender = new(1, 191);
    private readonly MavlinkSigner _signer;
    private readonly MavlinkSigningKey _key = MavlinkSigningKey.FromPassphrase("a phrase for measuring");
    private readonly MavlinkSigningClock _clock = new();
    private readonly MavlinkFrame[] _signed;
    private readonly int _fewBytes;
    private long _checked;

    public SpeedTable(FrameSet set)
    {
        _set = set;
        _copy = new byte[set.Stream.Length];
        _clock.Advance(new DateTime(2026, 1, 1, 0, 0, 0, DateTimeKind.Utc), TimeSpan.Zero);
        _signer = new MavlinkSigner(_key, 1, _clock);
        _signingSender.Signer = _signer;
        _signed = new MavlinkFrame[Math.Min(FewFrames, set.Frames.Length)];
        for (int index = 0; index < _signed.Length; index++)
        {
            _signed[index] = _signer.Sign(set.Frames[index], set.Infos[index].Message.CrcExtra);
            _fewBytes += set.Frames[index].WireLength;
        }
    }

    public void Print(TextWriter output)
    {
        output.WriteLine();
        output.WriteLine(Text($"{_set.Name}: {_set.Frames.Length} frames, {_set.Stream.Length} bytes"));
        output.WriteLine("                                    ns/frame   Mframes/s      MB/s   x limit    gen0   bytes");
        int all = _set.Frames.Length;
        double limit = Row(output, "copy of the bytes", Copy, all, 0);
        limit += Row(output, "checksum alone", Checksum, all, 0);
        Row(output, "framing + checksum", Read, all, limit);
        Row(output, "... in chunks of 1 kB", ReadInChunks, all, limit);
        Row(output, "... and decoded to messages", ReadAndDecode, all, limit);
        Row(output, "decode alone", Decode, all, limit);
        Row(output, "encode", Encode, all, limit);
        Row(output, "encode and sign", EncodeAndSign, _signed.Length, limit);
        Row(output, "sign a frame", Sign, _signed.Length, limit);
        Row(output, "verify a signature", Verify, _signed.Length, limit);
        if (_checked == 0)
            throw new InvalidOperationException("Nothing was done.");
    }

    // Returns the time per frame; 'limit' is that of copy and checksum.
    private double Row(TextWriter output, string name, Action work, int frames, double limit)
    {
        Measurement measured = Measurement.Of(work);
        double perFrame = measured.Seconds / frames;
        int bytes = frames == _set.Frames.Length ? _set.Stream.Length : _fewBytes;
        string ratio = limit > 0 ? (perFrame / limit).ToString("0.00", CultureInfo.InvariantCulture) : "";
        output.WriteLine(Text(
            $"  {name,-32}{perFrame * 1e9,10:0.0}{1e-6 / perFrame,12:0.00}{bytes / measured.Seconds / 1e6,10:0}{ratio,10}{measured.Collections,8}{measured.Bytes,8}"));
        return perFrame;
    }

    private void Copy() => Buffer.BlockCopy(_set.Stream, 0, _copy, 0, _copy.Length);

    // What the wire format asks for: each frame's bytes but its magic, checksum and signature, then the extra byte.
    private void Checksum()
    {
        int position = 0;
        int sum = 0;
        MavlinkFrame[] frames = _set.Frames;
        for (int index = 0; index < frames.Length; index++)
        {
            int length = frames[index].WireLength;
            ushort crc = MavlinkCrc.Add(MavlinkCrc.Initial, _set.Stream.AsSpan(position + 1, length - 3));
            sum += MavlinkCrc.Add(crc, (byte)index);
            position += length;
        }

        _checked += sum;
    }

    private void Read()
    {
        ReadOnlySpan<byte> rest = _set.Stream;
        while (_reader.TryRead(ref rest, out MavlinkFrame frame, out _))
            _checked += frame.Sequence;
        if (_reader.PendingBytes != 0)
            throw new InvalidOperationException("The stream does not end with a whole frame.");
    }

    private void ReadInChunks()
    {
        for (int start = 0; start < _set.Stream.Length; start += ChunkLength)
        {
            ReadOnlySpan<byte> rest = _set.Stream.AsSpan(start, Math.Min(ChunkLength, _set.Stream.Length - start));
            while (_reader.TryRead(ref rest, out MavlinkFrame frame, out _))
                _checked += frame.Sequence;
        }
    }

    private void ReadAndDecode()
    {
        ReadOnlySpan<byte> rest = _set.Stream;
        int index = 0;
        while (_reader.TryRead(ref rest, out MavlinkFrame frame, out _))
        {
            if (_set.Messages[index++].Decode(frame))
                _checked++;
        }
    }

    private void Decode()
    {
        for (int index = 0; index < _set.Frames.Length; index++)
        {
            if (_set.Messages[index].Decode(_set.Frames[index]))
                _checked++;
        }
    }

    private void Encode()
    {
        foreach (SampleMessage message in _set.Messages)
            _checked += message.Write(_sender, _wire);
    }

    private void EncodeAndSign()
    {
        for (int index = 0; index < _signed.Length; index++)
            _checked += _set.Messages[index].Write(_signingSender, _wire);
    }

    private void Sign()
    {
        for (int index = 0; index < _signed.Length; index++)
            _checked += _signer.Sign(_set.Frames[index], _set.Infos[index].Message.CrcExtra).Checksum;
    }

    private void Verify()
    {
        for (int index = 0; index < _signed.Length; index++)
        {
            if (_key.Matches(_signed[index]))
                _checked++;
        }
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
