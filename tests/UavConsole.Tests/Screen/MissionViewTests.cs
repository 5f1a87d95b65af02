using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Rabit.Uav.Reporting.Tests;
using Spectre.Console;
using Xunit;
using Xunit.Abstractions;

namespace UavConsole.Tests;

/// <summary>The screen of a mission on a terminal of 80 by 24, without a terminal.</summary>
public sealed class MissionViewTests(ITestOutputHelper output)
{
    private static readonly string[] ManagerNames =
    [
        "communications", "autopilot", "image processing", "sensor fusion", "mission control", "health",
        "simulated vehicle"
    ];

    private readonly List<Action> _posts = [];

    [Fact]
    public void Draw_InTheMiddleOfASearch_FitsAndShowsAll()
    {
        string[] lines = Draw("lane 2 of 4", DefaultTargetClasses.Red).Split('\n')
            .Select(l => l.TrimEnd('\r', ' ')).ToArray();

        Assert.InRange(lines.Count(l => l.Length > 0), 20, 24);
        Assert.All(lines, l => Assert.InRange(l.Length, 0, 80));
        string all = string.Join("\n", lines);
        foreach (string expected in new[]
        {
            "search of a meadow", "searching", "lane 2 of 4", "62.0%", "1 of 4 flown", "1 confirmed", "1 red ±2.4 m",
            "GUIDED, armed", "87%", "Good", "H", "R", "sensor fusion", "Ended, 3 runs"
        })
            Assert.Contains(expected, all);
    }

    [Fact]
    public void Draw_HostileTexts_ShowsThemAsTheyAre()
    {
        string drawn = Draw(
            "[red]a[/] [[b\u001b[2J\nc \u0007 and so on, far longer than there is room", DefaultTargetClasses.Red);

        Assert.Contains("[red]a[/] [[b.[2J.c", drawn);
        Assert.DoesNotContain(drawn, c => char.IsControl(c) && c != '\n' && c != '\r');
        Assert.All(drawn.Split('\n'), l => Assert.InRange(l.TrimEnd('\r').Length, 0, 80));
    }

    // Shown before --fly arms: what refuses the flight is never below the edge of the screen.
    [Fact]
    public void Draw_BeforeTheMotorsRun_ShowsTheChecklistWithItsFailuresFirst()
    {
        string drawn = Draw(
            "waiting", DefaultTargetClasses.Red, MissionPhase.WaitingForVehicle, isArmed: false,
            Checklist(passing: 30));
        string[] lines = drawn.Split('\n').Select(l => l.TrimEnd('\r', ' ')).ToArray();

        Assert.InRange(lines.Count(l => l.Length > 0), 20, 24);
        Assert.All(lines, l => Assert.InRange(l.Length, 0, 80));
        Assert.Contains("pre-flight checklist: REFUSES THE FLIGHT", lines[1]);
        Assert.Contains("fail     battery: 31 %", lines[2]);
        Assert.Contains("override hdop: 2.1", lines[3]);
        Assert.Contains("warn     return-height: 15 m; set", lines[4]);
        Assert.Contains("more lines", drawn);
    }

    [Fact]
    public void Draw_MotorsRun_ShowsTheMapAgain()
        => Assert.DoesNotContain(
            "pre-flight", Draw("climbing", DefaultTargetClasses.Red, MissionPhase.Arming, true, Checklist(passing: 1)));

    [Fact]
    public void Draw_TakenOver_SaysHowToCommandAgain()
    {
        string drawn = Draw("the pilot took over", DefaultTargetClasses.Red, MissionPhase.HandedOver);

        Assert.Contains("nothing is commanded. To command again", drawn);
        Assert.Contains("--return or --resume FILE", drawn);
        Assert.All(drawn.Split('\n'), l => Assert.InRange(l.TrimEnd('\r').Length, 0, 80));
    }

    [Fact]
    public void Draw_WithKeys_ShowsThemInTheLastLineAndStillFits()
    {
        string[] lines = Draw("lane 2 of 4", DefaultTargetClasses.Red, keys: new FixedHints("r return  h hold [x]"))
            .Split('\n').Select(l => l.TrimEnd('\r', ' ')).Where(l => l.Length > 0).ToArray();

        Assert.InRange(lines.Length, 20, 24);
        Assert.Equal("r return  h hold [x]", lines.Last());
    }

    private static PreflightReport Checklist(int passing) => new()
    {
        IsComplete = true,
        Lines =
        [
            .. Enumerable.Range(0, passing).Select(
                i => new PreflightLine($"line {i}", PreflightResult.Pass, "good", string.Empty, IsOverridden: false)),
            new("return-height", PreflightResult.Warn, "15 m", "set obstacleHeightMetres", IsOverridden: false),
            new("hdop", PreflightResult.Fail, "2.1", string.Empty, IsOverridden: true),
            new("battery", PreflightResult.Fail, "31 %", "charge it", IsOverridden: false),
        ],
    };

    private string Draw(
        string missionText, TargetClassName colour, MissionPhase phase = MissionPhase.Searching, bool isArmed = true,
        PreflightReport? checklist = null, IKeyHints? keys = null)
    {
        var notes = new RunLog();
        var reactor = new RabitReactor(
            new ReactorOptions { Time = new VirtualTime(1), Log = notes.Add, StopsOnSignals = false });
        foreach (string name in ManagerNames)
            reactor.Add(new IdleManager(name));
        var recorder = new FlightRecorderManager(new FlightRecorderOptions { ManagerNames = ManagerNames });
        reactor.Add(recorder);
        Post(reactor.Workspace, MessageNames.VehicleState, Vehicle() with { IsArmed = isArmed });
        Post(reactor.Workspace, MessageNames.Health, new HealthReport { Level = HealthLevel.Good });
        Post(reactor.Workspace, MessageNames.Mission, new MissionStatus
        {
            Phase = phase,
            Plan = MadeUpSite.Plan,
            Coverage = 0.62,
            LanesFlown = 1,
            Text = missionText,
        });
        Post(reactor.Workspace, MessageNames.Tracks, new TrackList(TimeSpan.Zero, [Track(colour)]));
        reactor.Workspace.Publish(MessageNames.StatusTexts, RecentItems<StatusText>.None);
        reactor.Workspace.Publish(MessageNames.Preflight, checklist ?? PreflightReport.None);
        var monitor = new FlightMonitor(reactor, recorder, linkCount: 0);
        var screen = new LiveScreen(monitor, notes, showsMission: true, keys: keys);
        reactor.Start();
        foreach (Action post in _posts)
            post();
        reactor.RunFor(TimeSpan.FromSeconds(2));
        monitor.Refresh();
        reactor.Stop();
        reactor.Finish();
        string drawn = Draw(screen);
        output.WriteLine(drawn);
        return drawn;
    }

    private void Post<T>(RabitWorkspace workspace, string name, T value)
    {
        MessagePublisher<T> publisher = value is TrackList
            ? workspace.Publish(name, value)
            : workspace.Publish<T>(name);
        _posts.Add(() =>
        {
            publisher.Value = value;
            publisher.Post();
        });
    }

    private static VehicleState Vehicle() => new()
    {
        SystemId = 1,
        ComponentId = 1,
        IsConnected = true,
        IsArmed = true,
        Mode = "GUIDED",
        PositionTime = TimeSpan.Zero,
        Position = MadeUpSite.Frame.ToGeodetic(new NedPosition(65, 90, -40)),
        HeightAboveHomeMetres = 40.2,
        VelocityNed = new NedVector(0, -6, 0),
        Attitude = EulerAngles.FromRadians(0, 0, -Math.PI / 2),
        BatteryTime = TimeSpan.Zero,
        BatteryRemaining = 0.87,
        BatteryVolts = 15.9,
        BatteryAmperes = 14,
    };

    private static TargetTrack Track(TargetClassName colour) => new()
    {
        Id = 1,
        Class = colour,
        State = TrackState.Confirmed,
        Reports = 12,
        Covariance = new HorizontalCovariance(1, 0, 1),
        Position = MadeUpSite.Frame.ToGeodetic(new NedPosition(48, 60, 0)),
    };

    private static string Draw(LiveScreen screen)
    {
        var text = new StringWriter();
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No,
            ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(text),
        });
        console.Profile.Width = 80;
        console.Profile.Height = 24;
        console.Write(screen.Draw());
        return text.ToString();
    }

    private sealed class FixedHints(string line) : IKeyHints
    {
        public string Line => line;
    }

    private sealed class IdleManager(string name) : RabitManager(name)
    {
        protected override void ExecuteUnitOfWork() => Log("a note");
    }
}
