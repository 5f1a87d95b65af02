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

    // One after another within a run: a machine that is slow for a while is so for both sides.
    private const int Rounds = 3;

    private readonly FrameSet _set;
    private readonly MeasurementEffort _effort;
    private readonly CBaseline? _baseline;
    private readonly byte[] _copy;
    private readonly byte[] _wire = new byte[MavlinkFrame.MaxWireLength];
    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
    private readonly MavlinkSender _sender = new(1, 191);
    private readonly MavlinkSender _signingSender = new(1, 191);
    private readonly MavlinkSigner _signer;
    private readonly MavlinkSigningKey _key = MavlinkSigningKey.FromPassphrase("a phrase for measuring");
    private readonly MavlinkSigningClock _clock = new();
    private readonly MavlinkFrame[] _signed;
    private readonly int _fewBytes;
    private long _checked;

    public SpeedTable(FrameSet set, MeasurementEffort effort, CBaseline? baseline)
    {
        _set = set;
        _effort = effort;
        _baseline = baseline;
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

    /// <summary>Measures and prints.</summary>
    /// <returns>Whether every row is within its limit and allocates nothing.</returns>
    public bool Print(TextWriter output)
    {
        output.WriteLine();
        output.WriteLine(Text($"{_set.Name}: {_set.Frames.Length} frames, {_set.Stream.Length} bytes"));
        output.WriteLine(
            "                                    ns/frame   Mframes/s      MB/s   x limit    gen0   bytes"
                + (_baseline is null ? "" : "     C ns   C / this"));
        int all = _set.Frames.Length;
        int few = _signed.Length;
        Measurement copy = Row("copy of the bytes", all, Copy);
        Measurement checksum = Row("checksum alone", all, Checksum);
        Measurement[] rows =
        [
            copy,
            checksum,
            Row("framing + checksum", all, Read, 4, 12, "read"),
            Row("... in chunks of 1 kB", all, ReadInChunks, 4, 12),
            Row("... byte by byte", all, ReadByByte, 20, 100, "read"),
            Row("... and decoded to messages", all, ReadAndDecode, 6, 24),
            Row("decode alone", all, Decode, 3, 12),
            Row("encode", all, Encode, 8, 30, "encode"),
            Row("encode and sign", few, EncodeAndSign, 60, 150, "encode-sign"),
            Row("sign a frame", few, Sign, 60, 150),
            Row("verify a signature", few, Verify, 60, 150),
        ];
        Measure(rows);
        bool isGood = true;
        foreach (Measurement row in rows)
            isGood &= Print(output, row, copy.SecondsPerFrame + checksum.SecondsPerFrame);
        if (_checked == 0)
            throw new InvalidOperationException("Nothing was done.");
        return isGood;
    }

    private Measurement Row(
        string name, int frames, Action work, double maxRatio = double.PositiveInfinity,
        double maxRatioOnMono = double.PositiveInfinity, string? cName = null)
            =>
            new(name, frames, frames == _set.Frames.Length ? _set.Stream.Length : _fewBytes, work)
            {
                CName = cName,
                MaxRatio = (maxRatio, maxRatioOnMono)
            };

    private void Measure(Measurement[] rows)
    {
        foreach (Measurement row in rows)
            row.Warm(_effort.SecondsWithoutGain);
        GC.Collect();
        for (int round = 0; round < Rounds; round++)
        {
            _baseline?.Run();
            for (int pass = 0; pass < _effort.Passes / Rounds; pass++)
            {
                foreach (Measurement row in rows)
                    row.Pass();
            }
        }
    }

    // 'limit' is the time of copy and checksum.
    private bool Print(TextWriter output, Measurement row, double limit)
    {
        double perFrame = row.SecondsPerFrame;
        double ratio = perFrame / limit;
        string beside = _baseline?.SecondsPerFrame(row.CName) is { } c
            ? Text($"{c * 1e9,9:0.0}{c / perFrame,11:0.00}")
            : "";
        bool isGood = ratio <= (RuntimeName.IsMono ? row.MaxRatio.Mono : row.MaxRatio.Net) && row.AllocatedBytes == 0
            && row.Collections == 0;
        output.WriteLine(Text(
            $"  {row.Name,-32}{perFrame * 1e9,10:0.0}{1e-6 / perFrame,12:0.00}{row.BytesPerSecond / 1e6,10:0}{ratio,10:0.00}{row.Collections,8}{row.AllocatedBytes,8}{beside}{(isGood ? "" : "  TOO MUCH")}"));
        return isGood;
    }

    private void Copy() => Buffer.BlockCopy(_set.Stream, 0, _copy, 0, _copy.Length);

    // What the wire format requires: each frame's bytes but its magic, checksum and signature, then the extra byte.
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

    private void ReadByByte()
    {
        byte[] stream = _set.Stream;
        for (int start = 0; start < stream.Length; start++)
        {
            ReadOnlySpan<byte> one = stream.AsSpan(start, 1);
            while (_reader.TryRead(ref one, out MavlinkFrame frame, out _))
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
