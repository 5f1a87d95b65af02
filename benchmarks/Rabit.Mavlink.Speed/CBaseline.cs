using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;

namespace Rabit.Mavlink.Speed;

/// <summary>
/// The C baseline (c/baseline.c) over the same messages, as a process of its own; the best of its runs counts.
/// </summary>
internal sealed class CBaseline
{
    private readonly string _program;
    private readonly string _folder;
    private readonly Dictionary<string, double> _seconds = new(StringComparer.Ordinal);

    public CBaseline(string program, FrameSet set)
    {
        _program = program;
        _folder = Path.Combine(Path.GetTempPath(), "rabit-mavlink-speed");
        Directory.CreateDirectory(_folder);
        Write(set);
    }

    /// <summary>Runs it once more.</summary>
    public void Run()
    {
        var start = new ProcessStartInfo(
            _program, $"\"{PathOf("frames")}\" \"{PathOf("crc-extra")}\" \"{PathOf("lengths")}\"")
        {
            RedirectStandardOutput = true,
            UseShellExecute = false,
        };
        using var process = Process.Start(start)!;
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        if (process.ExitCode != 0)
            throw new InvalidOperationException($"{_program} ended with {process.ExitCode}.");
        foreach (string line in output.Split(['\n'], StringSplitOptions.RemoveEmptyEntries))
        {
            string[] parts = line.Split(' ');
            double seconds = double.Parse(parts[1], CultureInfo.InvariantCulture) * 1e-9;
            _seconds[parts[0]] = _seconds.TryGetValue(parts[0], out double best) ? Math.Min(best, seconds) : seconds;
        }
    }

    /// <summary>Its best time per frame; null for what it does not do.</summary>
    public double? SecondsPerFrame(string? name)
        => name is not null && _seconds.TryGetValue(name, out double seconds) ? seconds : null;

    // All frames as MAVLink 2 without signature, which is what the baseline knows.
    private void Write(FrameSet set)
    {
        var sender = new MavlinkSender(1, 191);
        var wire = new byte[MavlinkFrame.MaxWireLength];
        using FileStream frames = File.Create(PathOf("frames"));
        using FileStream extras = File.Create(PathOf("crc-extra"));
        using FileStream lengths = File.Create(PathOf("lengths"));
        for (int index = 0; index < set.Messages.Length; index++)
        {
            frames.Write(wire, 0, set.Messages[index].Write(sender, wire));
            extras.WriteByte(set.Infos[index].Message.CrcExtra);
            lengths.WriteByte(set.Infos[index].Message.MaxLength);
        }
    }

    private string PathOf(string name) => Path.Combine(_folder, name + ".bin");
}
