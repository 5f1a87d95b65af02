using System;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>The progress of a mission on the disk, and a mission that is continued from there.</summary>
public sealed class MissionProgressTests : IDisposable
{
    // The way to the target and back is more than a third of the four lanes.
    private const string Revisit = ", \"revisit\": { \"maxWayFraction\": 0.5 }";

    private readonly string _folder = Path.Combine(
        Path.GetTempPath(), "rabit-progress-" + Guid.NewGuid().ToString("N"));

    public MissionProgressTests() => Directory.CreateDirectory(_folder);

    private string FilePath => Path.Combine(_folder, "field.progress.json");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void File_InTheSecondLane_SaysWhatIsFlownSeenAndFound()
    {
        using MissionRig rig = FlyToTheSecondLane();
        MissionProgress progress = MissionProgress.ReadFile(FilePath);

        Assert.Equal(("test", MissionPhase.Searching), (progress.MissionName, progress.Phase));
        Assert.True(progress is { IsCommanding: true, IsInAir: true });
        Assert.Equal((1, rig.Status.LanesFlown), (progress.LanesFlown, rig.Status.LanesFlown));
        Assert.InRange(progress.Coverage, 0.3, rig.Status.Coverage);
        Assert.InRange(progress.FlownMetresOfLeg, 5, 100);
        MissionProgressTarget target = Assert.Single(progress.Targets);
        Assert.Equal((DefaultTargetClasses.Red, true), (target.Class, target.IsRevisited));
        Assert.False(File.Exists(FilePath + ".new"));
    }

    // What the operator decided is not in the mission file.
    [Fact]
    public void Resume_AfterRejectionSkipAndAnotherArea_KeepsThem()
    {
        GeodeticPosition[] wider = Wider();
        using (MissionRig rig = FlyToTheSecondLane())
        {
            MissionControlManager op = rig.Manager;
            op.Reject(rig.Vehicle.Tracks[0].Id, "test", "a bin");
            op.SkipLane("test", "a crane");
            op.ChangeSpeed(6.5, "test", "gusts");
            OperatorRequest offer = op.OfferArea([.. wider], [], "test", "a hint");
            rig.Run(2);
            Assert.Equal(OperatorOutcome.Accepted, offer.Outcome);
            op.ContinueMission("test", "over there");
            rig.Run(8);
        }

        MissionProgress progress = MissionProgress.ReadFile(FilePath);
        Assert.Empty(progress.Targets);
        Assert.Equal(DefaultTargetClasses.Red, Assert.Single(progress.RejectedTargets).Class);
        using var second = new MissionRig(Mission(), o =>
        {
            o.Resume = progress;
            o.ProgressFile = FilePath;
        });
        second.Vehicle.Targets.Add((90, 5, DefaultTargetClasses.Red));
        second.Vehicle.Targets.Add((100, 90, DefaultTargetClasses.Blue));
        Assert.Equal(MissionPhase.Searching, second.RunUntil(MissionPhase.Searching));
        second.Vehicle.Tracks.Add(second.Vehicle.MakeTrack(1, 90, 5, DefaultTargetClasses.Red, reports: 5));
        Assert.Equal(MissionPhase.Done, second.RunToEnd());
        MissionFlight flight = second.Manager.Flight!;
        Assert.Equal((6.5, wider.Length), (flight.Mission.SpeedMetresPerSecond, flight.Mission.Area.Length));
        Assert.InRange(flight.Plan!.Area.Area, 16_000, 16_400);
        Assert.Equal(1, second.Status.LanesSkipped);
        Assert.InRange(second.Status.Coverage, 0.9, 0.98);
        Assert.Equal((1, 1), (second.Status.Revisits, second.Status.TracksRejected));
        Assert.Contains("track 1 was rejected on an earlier flight", second.Story, StringComparison.Ordinal);

        // And a third flight knows of it too.
        Assert.Single(MissionProgress.ReadFile(FilePath).RejectedTargets);
    }

    [Fact]
    public void File_AfterATakeover_SaysThatWeDoNotCommand()
    {
        using MissionRig rig = FlyToTheSecondLane();
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(1);
        Assert.True(MissionProgress.ReadFile(FilePath) is
        { IsCommanding: false, IsInAir: true, Phase: MissionPhase.HandedOver });
    }

    [Fact]
    public void Resume_WithANewBattery_FliesOnlyWhatIsLeft()
    {
        double whole;
        using (MissionRig rig = FlyToTheSecondLane())
        {
            rig.RunToEnd();
            whole = InLanes(rig);
        }

        using (FlyToTheSecondLane())
        {
        }

        MissionProgress progress = MissionProgress.ReadFile(FilePath);
        using var second = new MissionRig(Mission(), o => o.Resume = progress);
        second.Vehicle.Targets.Add((90, 5, DefaultTargetClasses.Red));
        // Put down a few metres from where it stood before.
        (second.Vehicle.North, second.Vehicle.East) = (1.5, -2);
        Assert.Equal(MissionPhase.Done, second.RunToEnd());

        Assert.Equal(MissionOutcome.Accomplished, second.Status.Result.Outcome);
        Assert.InRange(second.Status.Coverage, 0.985, 1);
        Assert.Contains("1 of them flown already", second.Story, StringComparison.Ordinal);
        Assert.InRange(InLanes(second), 0, whole - 100);
        Assert.Equal(0, second.Status.Revisits);
        Assert.Contains("was revisited on an earlier flight: no revisit", second.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Resume_InFlight_ContinuesAtTheOperatorsWord()
    {
        (double North, double East, double Height) at;
        using (MissionRig rig = FlyToTheSecondLane())
            at = (rig.Vehicle.North, rig.Vehicle.East, rig.Vehicle.Height);
        using var second = new MissionRig(
            Mission(), o => o.Resume = MissionProgress.ReadFile(FilePath));
        (second.Vehicle.North, second.Vehicle.East, second.Vehicle.Height) = at;
        second.Vehicle.IsArmed = true;
        second.Run(10);
        Assert.Equal(MissionPhase.HandedOver, second.Status.Phase);
        Assert.Empty(second.Vehicle.Commands);

        second.Manager.ContinueMission("test", "the program was started again");
        second.Run(2);
        Assert.Equal(MissionPhase.Done, second.RunToEnd());
        Assert.InRange(second.Status.Coverage, 0.985, 1);
        Assert.Equal(MissionOutcome.Accomplished, second.Status.Result.Outcome);
    }

    [Fact]
    public void Resume_AtAnotherPlace_IsRefusedByName()
    {
        using (FlyToTheSecondLane())
        {
        }

        using var second = new MissionRig(
            Mission(), o => o.Resume = MissionProgress.ReadFile(FilePath));
        second.Vehicle.North = -70;
        second.Run(10);
        Assert.Equal(MissionPhase.Failed, second.Status.Phase);
        Assert.StartsWith(
            "the progress is of another place: its home is 70.0 m away", second.Status.Text!, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", "another", "is the progress of mission 'test', not of 'another'")]
    [InlineData(", \"fenceMarginMetres\": 50", "test", "mission 'test' with other values than now")]
    public void Resume_OfAnotherMission_IsRefusedByName(string more, string name, string fault)
    {
        using (FlyToTheSecondLane())
        {
        }

        MissionPlan other = MissionPlan.Parse(MissionRig.Text(Revisit + more), name);
        ArgumentException refusal = Assert.Throws<ArgumentException>(() => new MissionControlManager(
            new MissionControlOptions { Mission = other, Resume = MissionProgress.ReadFile(FilePath) }));
        Assert.Contains(fault, refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_CutOffAtAnyByteOrChanged_IsRefusedByName()
    {
        using (FlyToTheSecondLane())
        {
        }

        string text = File.ReadAllText(FilePath);
        for (int length = 0; length < text.Length; length += 37)
            Assert.Throws<MissionProgressException>(() => MissionProgress.Parse(text.Remove(length), "half.json"));
        MissionProgressException changed = Assert.Throws<MissionProgressException>(() => MissionProgress.Parse(
            text.Replace("\"lanesFlown\":1", "\"lanesFlown\":2"), "half.json"));
        Assert.Equal(
            "Progress file 'half.json': it is not complete or was changed: its SHA-256 does not match.",
            changed.Message);
    }

    // What an ordered end has held needs no return by a program after it.
    [Fact]
    public void Stop_InOrder_ProgressSaysThatNothingIsCommanded()
    {
        using (MissionRig rig = MissionRig.In(MissionPhase.Searching, o => o.ProgressFile = FilePath))
        {
            rig.Run(1);
            rig.Stop();
            Assert.Equal(MissionStopResult.Held, rig.Status.StopResult);
        }

        MissionProgress progress = MissionProgress.ReadFile(FilePath);
        Assert.Equal((false, true), (progress.IsCommanding, progress.IsInAir));
    }

    [Fact]
    public void Read_AnotherVersion_IsRefusedByName()
    {
        using (FlyToTheSecondLane())
        {
        }

        string text = File.ReadAllText(FilePath);
        string body = text.Remove(text.LastIndexOf(",\"sha256\"", StringComparison.Ordinal))
            .Replace("\"version\":1", "\"version\":7");
        string other = body + ",\"sha256\":\"" + Sha256Hex.Of(body) + "\"}\n";
        Assert.Contains(
            "it is of version 7; version 1 is read",
            Assert.Throws<MissionProgressException>(() => MissionProgress.Parse(other, "x")).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void ReadFile_NotThere_IsRefusedByNameInOneSentence()
    {
        string refusal = Assert.Throws<MissionProgressException>(
            () => MissionProgress.ReadFile(Path.Combine(_folder, "nowhere.json"))).Message;
        Assert.Contains("nowhere.json", refusal, StringComparison.Ordinal);
        Assert.EndsWith(".", refusal, StringComparison.Ordinal);
        Assert.DoesNotContain("..", refusal, StringComparison.Ordinal);
    }

    [Fact]
    public void File_FolderIsGone_TheFlightGoesOnAndTheLogSaysSoOnce()
    {
        using var rig = new MissionRig(
            Mission(), o => o.ProgressFile = Path.Combine(_folder, "missing", "p.json"));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(1, rig.Decisions.Count(d => d.Contains("progress file not written", StringComparison.Ordinal)));
    }

    private static MissionPlan Mission() => MissionRig.Mission(Revisit);

    private static GeodeticPosition[] Wider()
    {
        LocalNedFrame frame = LocalNedFrame.IgnoringGeoid(MissionRig.Home);
        return [.. new[] { (60, -60), (60, 120), (150, 120), (150, -60) }
            .Select(c => frame.ToGeodetic(new NedPosition(c.Item1, c.Item2, 0)))];
    }

    private static double InLanes(MissionRig rig)
    {
        double metres = 0;
        for (int i = 1; i < rig.Vehicle.Path.Count; i++)
        {
            (double n, double e, _) = rig.Vehicle.Path[i];
            (double n0, double e0, _) = rig.Vehicle.Path[i - 1];
            metres += n > 50 ? Math.Sqrt(((n - n0) * (n - n0)) + ((e - e0) * (e - e0))) : 0;
        }

        return metres;
    }

    private MissionRig FlyToTheSecondLane()
    {
        var rig = new MissionRig(Mission(), o => o.ProgressFile = FilePath);
        rig.Vehicle.Targets.Add((90, 5, DefaultTargetClasses.Red));
        rig.RunUntil(MissionPhase.Revisiting);
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(20);
        return rig;
    }
}
