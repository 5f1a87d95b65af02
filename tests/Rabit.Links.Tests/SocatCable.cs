using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace Rabit.Links.Tests;

/// <summary>Two serial devices that socat joins by a null-modem cable.</summary>
internal sealed class SocatCable : IDisposable
{
    private const string DeviceMark = "PTY is ";

    private readonly Process _socat;

    public SocatCable()
    {
        _socat = Process.Start(new ProcessStartInfo("socat", "-d -d pty,raw,echo=0 pty,raw,echo=0")
        {
            UseShellExecute = false,
            RedirectStandardError = true,
        }) ?? throw new InvalidOperationException("socat did not start");

        var devices = new List<string>();
        while (_socat.StandardError.ReadLine() is { } line)
        {
            int mark = line.IndexOf(DeviceMark, StringComparison.Ordinal);
            if (mark >= 0) devices.Add(line.Substring(mark + DeviceMark.Length));
            if (line.Contains("starting data transfer loop")) break;
        }

        FirstDevice = devices[0];
        SecondDevice = devices[1];
    }

    public string FirstDevice { get; }

    public string SecondDevice { get; }

    public void Unplug()
    {
        if (!_socat.HasExited) _socat.Kill();
        _socat.WaitForExit();
    }

    public void Dispose()
    {
        Unplug();
        _socat.Dispose();
    }
}
