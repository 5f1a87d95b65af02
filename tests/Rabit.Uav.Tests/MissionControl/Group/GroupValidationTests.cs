using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>Targets that one vehicle finds are validated by one other.</summary>
public sealed class GroupValidationTests
{
    private const string Field = "[[60,-180],[60,180],[360,180],[360,-180]]";

    [Fact]
    public void Target_FoundByOne_IsConfirmedByOneOther()
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunToEnd(), rig.Story);
        ValidationTask task = Assert.Single(Validated(rig));
        Assert.Equal(ValidationResult.Confirmed, task.Result);
        Assert.NotEqual(task.Finder, task.Validator);
        Assert.Equal(1, rig.Rigs.Sum(r => r.Decisions.Count(d => d.Contains("Searching -> Revisiting"))));
        Assert.All(rig.Rigs, r => Assert.Equal(MissionOutcome.Accomplished, r.Status.Result.Outcome));
    }

    [Fact]
    public void Target_OnlyTheFinderSeesIt_IsRejected()
    {
        using GroupRig rig = Open(2, targets: 0);
        rig.Rigs[0].Vehicle.Targets.Add((100, 0, DefaultTargetClasses.Red));
        rig.Rigs[0].Vehicle.Targets.Add((300, 0, DefaultTargetClasses.Red));
        Assert.True(rig.RunToEnd(), rig.Story);
        List<ValidationTask> tasks = Validated(rig);
        Assert.NotEmpty(tasks);
        Assert.All(tasks, t => Assert.Equal((1, 2, ValidationResult.Rejected), (t.Finder, t.Validator, t.Result)));
    }

    [Fact]
    public void Target_FoundAlone_IsRevisitedByTheFinder()
    {
        using GroupRig rig = Open(1);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(1, rig.Rigs[0].Status.Revisits);
        Assert.Empty(Validated(rig));
    }

    [Fact]
    public void Target_FoundByTwoAtOnce_IsValidatedOnce()
    {
        using GroupRig rig = Open(3, targets: 0, maxDetourMetres: 1000);
        Assert.True(rig.RunUntil(() => rig.Rigs.All(r => r.Status.Phase == MissionPhase.Searching), 200), rig.Story);
        for (int i = 0; i < 2; i++)
        {
            StandInVehicle vehicle = rig.Rigs[i].Vehicle;
            vehicle.Report(vehicle.MakeTrack(7, 200, 20 - (20 * i), DefaultTargetClasses.Red, 9, TrackState.Confirmed));
        }

        // Two wait for bids; one of them is left to the other.
        Assert.True(rig.RunUntil(() => Tasks(rig, 0).Length == 2, 3), rig.Story);
        rig.Run(3);
        Assert.Single(Tasks(rig, 0), t => t.State == ValidationState.Awarded);
        Assert.Equal([1], Tasks(rig, 0).Where(t => t.State != ValidationState.Closed).Select(t => (int)t.Finder));
    }

    // North of it are the lanes of one vehicle, south of it those of the other.
    [Theory]
    [InlineData(0, true)]
    [InlineData(1000, false)]
    public void Target_LanesAreLeft_IsValidatedAfterThemUnlessTheDetourIsAllowed(double maxDetourMetres, bool isAfter)
    {
        using GroupRig rig = Open(2, targets: 0, maxDetourMetres: maxDetourMetres);
        foreach ((MissionRig vehicle, int i) in rig.Rigs.Select((r, i) => (r, i)))
        {
            vehicle.Vehicle.Targets.Add((75, -20 * i, DefaultTargetClasses.Red));
            vehicle.Vehicle.Targets.Add((345, -20 * i, DefaultTargetClasses.Blue));
        }

        Assert.True(rig.RunUntil(() => Validating(rig).Any(), 900), rig.Story);
        double coverage = rig.Rigs.Max(r => r.Status.Coverage);
        Assert.True(isAfter ? coverage > 0.9 : coverage < 0.8, $"{coverage} {rig.Story}");
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(2, Validated(rig).Count(t => t.Result == ValidationResult.Confirmed));
    }

    [Fact]
    public void Target_BesideALaneOfAnother_IsConfirmedInPassing()
    {
        using GroupRig rig = Open(2, targets: 0, maxDetourMetres: 0);
        Assert.True(rig.RunUntil(() => rig.Rigs.All(r => r.Status.Phase == MissionPhase.Searching), 200), rig.Story);
        PlaceBesideTheBorder(rig);
        Assert.True(rig.RunToEnd(), rig.Story);
        ValidationTask task = Assert.Single(Validated(rig));
        Assert.Equal(ValidationResult.Confirmed, task.Result);
        Assert.Contains("confirmed in passing", rig.Story);
        Assert.DoesNotContain("Searching -> Revisiting", rig.Story);
    }

    // In the first lane of the northern share, which the higher vehicle sees from its own.
    private static void PlaceBesideTheBorder(GroupRig rig)
    {
        int northern = rig.ShareOf(0).First == 0 ? 1 : 0;
        double north = 60 + (30 * rig.ShareOf(northern).First) + 2;
        for (int i = 0; i < 2; i++)
            rig.Rigs[i].Vehicle.Targets.Add((north, -20 * i, DefaultTargetClasses.Red));
    }

    private static ImmutableArray<ValidationTask> Tasks(GroupRig rig, int vehicle)
        => rig.StatusOf(vehicle).Validations;

    [Fact]
    public void Target_ValidatorIsLost_IsValidatedByTheThird()
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => Validating(rig).Any(), 600), rig.Story);
        int validator = Validating(rig).Single();
        rig.Lost.Add(validator);
        Assert.True(rig.RunToEnd(), rig.Story);
        ValidationTask task = Assert.Single(Validated(rig));
        Assert.NotEqual(validator + 1, task.Validator);
        Assert.NotEqual(task.Finder, task.Validator);
    }

    [Fact]
    public void Target_ValidatedBeforeOneJoins_IsNotValidatedAgain()
    {
        using GroupRig rig = Open(3, maxDetourMetres: 1000);
        rig.SwitchedOn = 2;
        Assert.True(rig.RunUntil(() => Validated(rig).Count == 1, 600), rig.Story);
        rig.Run(10);
        rig.SwitchedOn = 3;
        Assert.True(rig.RunUntil(() => rig.Rigs[2].Status.Phase == MissionPhase.InTransit, 60), rig.Story);
        StandInVehicle late = rig.Rigs[2].Vehicle;
        late.Report(late.MakeTrack(7, 200, -20, DefaultTargetClasses.Red, 9, TrackState.Confirmed));
        Assert.True(rig.RunUntil(() => Tasks(rig, 2).Any(t => t.Finder == 3), 5), rig.Story);
        Assert.True(
            rig.RunUntil(() => Tasks(rig, 2).All(t => t.State == ValidationState.Closed), 1.5), rig.Story);
        Assert.Single(Validated(rig));
        Assert.DoesNotContain(Tasks(rig, 2), t => t.Finder == 3 && t.Validator != 0);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Targets_FortyPercentLost_EachIsValidatedByOneOther(int seed)
    {
        using GroupRig rig = Open(3, seed, targets: 3);
        rig.Loss = 0.4;
        Assert.True(rig.RunToEnd(), rig.Story);
        List<ValidationTask> tasks = Validated(rig);
        Assert.True(tasks.Count == 3, $"{tasks.Count} {rig.Story}");
        Assert.All(tasks, t => Assert.Equal(ValidationResult.Confirmed, t.Result));
    }

    [Fact]
    public void Validator_HoldsMeanwhile_GivesTheTargetBack()
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => Validating(rig).Any(), 600), rig.Story);
        int validator = Validating(rig).Single();
        rig.Rigs[validator].Vehicle.Health = new HealthReport
        {
            Level = HealthLevel.Warning,
            Advice = HealthAdvice.Hold,
            AdviceText = "pictures",
        };
        Assert.True(rig.RunUntil(() => Validating(rig).Any(v => v != validator), 90), rig.Story);
    }

    [Fact]
    public void Target_OperatorRejectsIt_NoneFliesThereAndAllKnow()
    {
        using GroupRig rig = Open(3, maxDetourMetres: 0);
        Assert.True(rig.RunUntil(() => Finder(rig) is not null, 600), rig.Story);
        rig.Rigs[Finder(rig)!.Value].Manager.Reject(1, "test", "a bin");
        rig.Run(3);
        Assert.All(
            Enumerable.Range(0, 3), i => Assert.True(Tasks(rig, i).Single().IsRejectedByOperator, rig.Story));
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.True(Assert.Single(Validated(rig)).IsRejectedByOperator, rig.Story);
        Assert.DoesNotContain("Searching -> Revisiting", rig.Story, System.StringComparison.Ordinal);
        Assert.All(rig.Rigs, r => Assert.Equal(0, r.Status.TracksConfirmed));
    }

    [Fact]
    public void Target_OperatorRejectsItWhileAnotherFliesThere_ThatOneTurnsBack()
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => Validating(rig).Any(), 600), rig.Story);
        rig.Rigs[Finder(rig)!.Value].Manager.Reject(1, "test", "a bin");
        Assert.True(rig.RunUntil(() => !Validating(rig).Any(), 2), rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.True(Assert.Single(Validated(rig)).IsRejectedByOperator, rig.Story);
    }

    // Whose result was that it is one; also where what it says comes late.
    [Theory]
    [InlineData(0)]
    [InlineData(0.4)]
    public void Target_OperatorOfItsValidatorRejectsIt_IsRejectedForAll(double loss)
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => Validated(rig).Count == 1, 900), rig.Story);
        rig.Loss = loss;
        rig.Rigs[Validated(rig)[0].Validator - 1].Manager.Reject(1, "test", "a bin");
        rig.Run(5);
        Assert.All(
            Enumerable.Range(0, 3).SelectMany(i => Tasks(rig, i)), t => Assert.True(t.IsRejectedByOperator, rig.Story));
        Assert.All(rig.Rigs, r => Assert.Equal(0, r.Status.TracksConfirmed));
    }

    // The finder has a task of its own, which is not ended either.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Target_OperatorOfAnotherConfirmedItBefore_StaysConfirmedThere(bool isConfirmedByItsFinder)
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => Validated(rig).Count == 1, 900), rig.Story);
        ValidationTask task = Validated(rig)[0];
        (byte confirms, byte rejects) = isConfirmedByItsFinder
            ? (task.Finder, task.Validator)
            : (task.Validator, task.Finder);
        rig.Rigs[confirms - 1].Manager.Confirm(1, "test", "seen by eye");
        rig.Run(1);
        rig.Rigs[rejects - 1].Manager.Reject(1, "test", "a bin");
        rig.Run(5);
        Assert.Equal(1, rig.Rigs[confirms - 1].Status.TracksConfirmed);
        Assert.Equal(0, rig.Rigs[rejects - 1].Status.TracksConfirmed);
        Assert.DoesNotContain(Tasks(rig, rejects - 1), t => t.Finder == confirms && t.IsRejectedByOperator);
    }

    [Fact]
    public void Target_RejectedAndThenConfirmed_IsConfirmedForThatVehicleAloneAndTheAnswerSaysSo()
    {
        using GroupRig rig = Open(2);
        Assert.True(rig.RunUntil(() => Validated(rig).Count == 1, 900), rig.Story);
        MissionControlManager op = rig.Rigs[Validated(rig)[0].Finder - 1].Manager;
        op.Reject(1, "test", "a bin");
        rig.Run(2);
        OperatorRequest confirm = op.Confirm(1, "test", "no bin");
        rig.Run(2);
        Assert.Equal(OperatorOutcome.Accepted, confirm.Outcome);
        Assert.Equal("for this vehicle alone: for the group it stays rejected", confirm.Answer);
        Assert.True(Assert.Single(Validated(rig)).IsRejectedByOperator);
    }

    private static int? Finder(GroupRig rig) => Enumerable.Range(0, rig.Rigs.Count)
        .Where(i => Tasks(rig, i).Any(t => t.Finder == i + 1)).Select(i => (int?)i).FirstOrDefault();

    private static IEnumerable<int> Validating(GroupRig rig) => Enumerable.Range(0, rig.Rigs.Count)
        .Where(i => !rig.Lost.Contains(i)
            && rig.Rigs[i].Status.Text?.StartsWith("validating", System.StringComparison.Ordinal) == true);

    private static List<ValidationTask> Validated(GroupRig rig)
    {
        IEnumerable<ImmutableArray<ValidationTask>> known = rig.Rigs.Select((_, i) => rig.StatusOf(i).Validations);
        return known.SelectMany(t => t).Where(t => t.Result != ValidationResult.Unknown)
            .GroupBy(t => (t.Finder, t.Session, t.Number)).Select(g => g.First()).ToList();
    }

    // The homes are 20 m apart.
    private static GroupRig Open(int vehicles, int seed = 1, int targets = 1, double maxDetourMetres = 150)
    {
        var rig = new GroupRig(
            vehicles, MissionRig.Mission(area: Field), seed,
            (_, options) => options.Group!.MaxValidationDetourMetres = maxDetourMetres);
        for (int i = 0; i < vehicles * targets; i++)
        {
            (int vehicle, int target) = (i % vehicles, i / vehicles);
            rig.Rigs[vehicle].Vehicle.Targets.Add((200 - (60 * target), 20 - (20 * vehicle), DefaultTargetClasses.Red));
        }

        return rig;
    }
}
