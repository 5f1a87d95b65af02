// Our side of eng/node-mavlink-check.sh.
//   NodeMavlinkCheck write FOLDER GOLDEN LOG writes ours.bin (1000 frames, half of them signed) and flight.bin (the
//   frames of a .tlog) NodeMavlinkCheck compare FOLDER GOLDEN reads theirs.bin and node.json, and prints what agrees
//   and how fast each side is
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink;
using Rabit.Mavlink.Speed;

const int Half = 500;
using var key = MavlinkSigningKey.FromPassphrase("a phrase that both sides know");
var clock = new MavlinkSigningClock();
clock.Advance(new DateTime(2026, 1, 1, 0, 0, 0, DateTimeKind.Utc), TimeSpan.Zero);
string folder = args[1];

// Lines whose fields both sides know.
JsonElement[] lines = [.. File.ReadLines(args[2])
    .Select(line => JsonDocument.Parse(line).RootElement)
    .Where(line => line.GetProperty("peer").GetString() == "agree")];
MavlinkFrame[] golden =
    [.. lines.Select(line => Frames(Convert.FromHexString(line.GetProperty("v2").GetString()!))[0])];
return args[0] == "write" ? Write(args[3]) : Compare();

int Write(string log)
{
    using FileStream ours = File.Create(Path.Combine(folder, "ours.bin"));
    var sender = new MavlinkSender(7, 191);
    var buffer = new byte[MavlinkFrame.MaxWireLength];
    for (int index = 0; index < 2 * Half; index++)
    {
        if (index == Half)
            sender.Signer = new MavlinkSigner(key, 3, clock);
        ours.Write(buffer, 0, SampleMessage.Of(golden[index % golden.Length]).Write(sender, buffer));
    }

    using FileStream flight = File.Create(Path.Combine(folder, "flight.bin"));
    using FileStream file = File.OpenRead(log);
    var reader = new TlogReader(file, MavlinkDialect.All);
    while (reader.TryRead(out MavlinkFrame frame, out TlogRecord record))
    {
        if (record.IsChecked)
            flight.Write(buffer, 0, frame.WriteTo(buffer));
    }

    return 0;
}

int Compare()
{
    var faults = new List<string>();
    List<MavlinkFrame> theirs = Frames(File.ReadAllBytes(Path.Combine(folder, "theirs.bin")));
    var verifier = new MavlinkVerifier(key, clock, (in MavlinkFrame _, int _) => true);
    for (int index = 0; index < theirs.Count; index++)
    {
        MavlinkFrame frame = theirs[index];
        MavlinkFrame expected = golden[index % golden.Length];
        string name = $"frame {index} {lines[index % golden.Length].GetProperty("name")}: {frame}";
        if ((frame.MessageId, frame.SystemId, frame.ComponentId, frame.Sequence)
            != (expected.MessageId, (byte)9, (byte)190, (byte)index))
            faults.Add(name);
        if (!Payload(frame).AsSpan().SequenceEqual(Payload(expected)))
            faults.Add(name + ": payload");
        if (frame.IsSigned != index >= Half || !verifier.Verify(frame).IsAccepted()
            || (frame.IsSigned && frame.SignatureLinkId != 4))
            faults.Add(name + ": signature");
    }

    using var node = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "node.json")));
    JsonElement ours = node.RootElement.GetProperty("ours");
    string[] theirFaults = [.. ours.GetProperty("faults").EnumerateArray().Select(fault => fault.GetString()!)];
    Console.WriteLine($"node-mavlink read {ours.GetProperty("frames")} frames of ours, {theirFaults.Length} faults");
    Console.WriteLine($"we read {theirs.Count} frames of node-mavlink, {faults.Count} faults");
    foreach (string fault in theirFaults.Concat(faults).Take(20))
        Console.WriteLine("  " + fault);
    bool isSlow = !PrintSpeeds(node.RootElement.GetProperty("flight"));
    return faults.Count + theirFaults.Length > 0 || theirs.Count != 2 * Half
        || ours.GetProperty("frames").GetInt32() != 2 * Half || isSlow
        ? 1
        : 0;
}

bool PrintSpeeds(JsonElement node)
{
    byte[] flight = File.ReadAllBytes(Path.Combine(folder, "flight.bin"));
    SampleMessage[] messages = [.. Frames(flight).Select(frame => SampleMessage.Of(frame))];
    double framing = Best(flight, null);
    double decoding = Best(flight, messages);
    int theirFrames = node.GetProperty("frames").GetInt32();
    double theirFraming = node.GetProperty("framingNanoseconds").GetDouble() / theirFrames;
    double theirDecoding = node.GetProperty("decodingNanoseconds").GetDouble() / theirFrames;
    Console.WriteLine($"the flight has {messages.Length} frames, of which node-mavlink found {theirFrames}");
    Row("framing and checksum", framing / messages.Length, theirFraming);
    Row("... and decoded", decoding / messages.Length, theirDecoding);
    return theirFraming >= 20 * framing / messages.Length && theirDecoding >= 20 * decoding / messages.Length;
}

static void Row(string name, double ours, double theirs) => Console.WriteLine(string.Create(
    CultureInfo.InvariantCulture,
    $"{name,-22}{1e3 / ours,8:0.00} M frames/s, node-mavlink {1e3 / theirs:0.000} M frames/s: {theirs / ours:0} "
        + $"times"));

// Nanoseconds of the best pass, in pieces as a file or a socket would bring them.
static double Best(byte[] stream, SampleMessage[]? messages)
{
    double best = double.MaxValue;
    var reader = new MavlinkFrameReader(MavlinkDialect.All);
    for (int pass = 0; pass < 300; pass++)
    {
        int index = 0;
        long start = Stopwatch.GetTimestamp();
        for (int offset = 0; offset < stream.Length; offset += 65536)
        {
            ReadOnlySpan<byte> rest = stream.AsSpan(offset, Math.Min(65536, stream.Length - offset));
            while (reader.TryRead(ref rest, out MavlinkFrame frame, out _))
                messages?[index++].Decode(frame);
        }

        best = Math.Min(best, Stopwatch.GetElapsedTime(start).TotalNanoseconds);
    }

    return best;
}

static byte[] Payload(in MavlinkFrame frame)
{
    var payload = new byte[frame.PayloadLength];
    frame.CopyPayloadTo(payload);
    return payload;
}

static List<MavlinkFrame> Frames(byte[] bytes)
{
    var found = new List<MavlinkFrame>();
    var reader = new MavlinkFrameReader(MavlinkDialect.All);
    ReadOnlySpan<byte> rest = bytes;
    while (reader.TryRead(ref rest, out MavlinkFrame frame, out _))
        found.Add(frame);
    return found;
}
