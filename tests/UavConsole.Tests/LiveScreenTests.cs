using System;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.Reporting;
using Rabit.Uav.Tests.Communications;
using UavConsole.Tests.Screen;
using Xunit;

namespace UavConsole.Tests;

/// <summary>The live screen on a terminal of 80 columns, without a terminal.</summary>
public sealed class LiveScreenTests : IDisposable
{
    private readonly TestLog _log = new(
        "[red]a flight with [[a long name]] and [bold in it, longer than the screen is wide, to be sure.tlog");

    [Fact]
    public void Draw_BeforeTheStart_ShowsAnEmptyScreen()
    {
        _log.Record(0, Frames.Heartbeat());
        using UavSystem uav = Open();
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });

        Assert.Contains("managers", Draw(new LiveScreen(Monitor(reactor, uav), new RunLog())));
    }

    [Fact]
    public void Draw_HostileTextsAndValues_ShowsThemAsTheyAre()
    {
        _log.Record(0, Frames.Heartbeat())
            .Record(1, Text("[markup] [/] [red]red[/ ]]"))
            .Record(2, Text("\u001b[2Jgone\r\n\t\u0007x"))
            .Record(3, Text(new string('W', 50)))
            .Record(4, Frames.Of(
                new Attitude { TimeBootMs = 1, Roll = float.NaN, Pitch = float.PositiveInfinity, Yaw = 1e30f }))
            .Record(5, Frames.Of(
                new GlobalPositionInt { TimeBootMs = 1, Lat = int.MinValue, Lon = int.MaxValue, Alt = int.MinValue }))
            .Record(6, Frames.Of(
                new SysStatus { BatteryRemaining = -1, VoltageBattery = ushort.MaxValue, CurrentBattery = -1 }))
            .Record(7, Frames.Of(new GpsRawInt { SatellitesVisible = 255, FixType = (GpsFixType)200 }))
            .Record(8, Frames.Heartbeat(sequence: 1));
        using UavSystem uav = Open();
        var notes = new RunLog();
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false, Log = notes.Add });
        var monitor = Monitor(reactor, uav);
        var screen = new LiveScreen(monitor, notes);
        reactor.Run();
        monitor.Refresh();

        string drawn = Draw(screen);

        Assert.Contains("[markup] [/] [red]red[/ ]]", drawn);
        Assert.Contains(".[2Jgone....x", drawn);
        Assert.Contains("100%", drawn);
        Assert.DoesNotContain(drawn, c => char.IsControl(c) && c != '\n' && c != '\r');
        Assert.All(drawn.Split('\n'), line => Assert.InRange(line.TrimEnd('\r').Length, 0, 80));
    }

    public void Dispose() => _log.Dispose();

    private UavSystem Open() => UavSystem.Open(new UavOptions
    {
        Links = [LinkUrl.Parse(_log.Url + "?speed=max")],
        Subscriptions = [FlightRecorderManager.CreateSubscription()],
    });

    private static FlightMonitor Monitor(RabitReactor reactor, UavSystem uav)
    {
        var recorder = new FlightRecorderManager(
            new FlightRecorderOptions { ManagerNames = reactor.Select(m => m.Name).ToArray() });
        reactor.Add(recorder);
        return new FlightMonitor(reactor, recorder, uav.LinkCount);
    }

    private static byte[] Text(string text)
        => Frames.Of(new Statustext { Severity = MavSeverity.Alert, Text = new Text50(text) });

    private static string Draw(LiveScreen screen) => PlainConsole.Draw(screen.Draw(), width: 80, height: 50);
}
