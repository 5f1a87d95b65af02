using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.Simulation.Tests.Camera;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.World;

/// <summary>Targets of other kinds than coloured panels, in a world that is otherwise the same.</summary>
public sealed class TargetKindTests
{
    private static readonly NedPosition[] Area = Scene.Corners((0, 0), (0, 120), (120, 120), (120, 0));

    private static readonly SimulatedTargetKind[] All =
        [.. Enumerable.Range(0, 8).Select(k => (SimulatedTargetKind)k)];

    [Fact]
    public void Place_NoKinds_IsTheWorldWithoutThem()
    {
        IReadOnlyList<SimulatedTarget> plain = TargetField.Place(7, Area, 5, 4);
        foreach (SimulatedTargetKind[] kinds in new[] { [], new[] { SimulatedTargetKind.ColouredPanel } })
        {
            IReadOnlyList<SimulatedTarget> same = TargetField.Place(7, Area, 5, 4, kinds, partlyHidden: 0);
            Assert.Equal(plain.Select(Describe), same.Select(Describe));
            Assert.All(same, t => Assert.Null(t.Pattern));
        }
    }

    [Fact]
    public void Place_AllKinds_LieWherePanelsWouldBesideTheSameDistractors()
    {
        IReadOnlyList<SimulatedTarget> plain = TargetField.Place(7, Area, 16, 4);
        IReadOnlyList<SimulatedTarget> mixed = TargetField.Place(7, Area, 16, 4, All, partlyHidden: 3);

        Assert.Equal(
            plain.Select(t => (t.Id, t.Position, t.Heading)), mixed.Select(t => (t.Id, t.Position, t.Heading)));
        Assert.Equal(plain.Skip(16).Select(Describe), mixed.Skip(16).Select(Describe));
        Assert.Equal(3, mixed.Count(t => t.IsPartlyHidden));
        Assert.Equal(
            ["white", "black", "person", "car", "aruco", "apriltag"],
            mixed.Skip(1).Take(7).Where(t => !t.Class.ToString().Contains('-')).Select(t => t.Class.ToString()));
        Assert.Contains('-', mixed[3].Class.ToString());
        Assert.NotEqual(mixed[3].Class, mixed[11].Class);
        Assert.Equal(mixed[4].Surface, mixed[12].Surface);   // one jacket
        Assert.NotEqual(mixed[6].MarkerId, mixed[14].MarkerId);
    }

    [Fact]
    public void Place_AllKinds_DeclareClassesThatAMissionMayHave()
    {
        TargetClass[] declared =
        [
            .. TargetField.Place(3, Area, 24, 0, All, 0).Select(t => t.Declared).OfType<TargetClass>()
                .GroupBy(c => c.Name).Select(c => c.First()),
        ];

        // The detectors check them.
        _ = new MarkerTargetDetector([.. declared.Where(c => c.Marker is not null)]);
        _ = new ShapeTargetDetector([.. TargetClass.Defaults, .. declared.Where(c => c.Marker is null)]);
        Assert.Equal(MarkerFamily.ArUco4x4, declared.Single(c => c.Name.ToString() == "aruco").Marker!.Family);
        Assert.All(declared.Where(c => c.Marker is null), c => Assert.NotNull(c.Colour));
    }

    [Fact]
    public void Place_TwoColouredPanels_DeclareBothColours()
    {
        TargetClass[] declared =
            [.. TargetField.Place(3, Area, 3, 0, [SimulatedTargetKind.TwoColouredPanel], 0).Select(t => t.Declared!)];

        Assert.Equal(
            ["black-white", "blue-yellow", "red-white"], declared.Select(c => c.Name.ToString()).OrderBy(n => n));
        Assert.All(declared, c => Assert.True(c.IsPanel && c.SecondColour is not null));
        _ = new PanelTargetDetector([.. declared]);
    }

    [Fact]
    public void Names_EveryKind_HasOneThatIsReadBack()
    {
        foreach (SimulatedTargetKind kind in All)
        {
            Assert.True(SimulatedTargetKindNames.TryParse(SimulatedTargetKindNames.NameOf(kind), out var read));
            Assert.Equal(kind, read);
        }

        Assert.False(SimulatedTargetKindNames.TryParse("Coloured", out _));
        Assert.False(SimulatedTargetKindNames.TryParse(null, out _));
        Assert.Throws<ArgumentOutOfRangeException>(() => SimulatedTargetKindNames.NameOf((SimulatedTargetKind)8));
        Assert.Equal(8, SimulatedTargetKindNames.All.Split(',').Length);
    }

    [Fact]
    public void Place_SameSeed_LooksTheSameAndAnotherSeedOther()
    {
        string one = Looks(5);
        Assert.Equal(one, Looks(5));
        Assert.NotEqual(one, Looks(6));
    }

    [Fact]
    public void PartlyHidden_AnySeed_LeavesThreeFifthsToFourFifths()
    {
        for (ulong seed = 0; seed < 50; seed++)
        {
            var random = new SeededSequence(seed);
            SurfacePattern pattern = SurfacePattern.Of(new SurfaceColour(1, 2, 3)).PartlyHidden(ref random);
            int seen = 0;
            for (int i = 0; i < 10_000; i++)
                seen += pattern.TryAt(((i / 100) + 0.5) / 100, ((i % 100) + 0.5) / 100, out _) ? 1 : 0;

            Assert.True(seen is > 5800 and < 8200, $"seed {seed}: {seen} of 10 000 are seen");
        }
    }

    [Theory]
    [InlineData(-0.001, 0.5)]
    [InlineData(1, 0.5)]
    [InlineData(0.5, 1)]
    [InlineData(double.NaN, 0.5)]
    public void TryAt_Beside_IsTheGround(double down, double right)
        => Assert.False(SurfacePattern.Of(new SurfaceColour(1, 2, 3)).TryAt(down, right, out _));

    [Fact]
    public void Options_KindsThatThereAreNot_AreRefused()
    {
        var options = new SimulationOptions { TargetKinds = [(SimulatedTargetKind)8], PartlyHiddenCount = -1 };

        ArgumentException refused = Assert.Throws<ArgumentException>(() => new SimulatedWorld(options));
        Assert.Contains("TargetKinds must be kinds that there are", refused.Message);
        Assert.Contains("PartlyHiddenCount is -1", refused.Message);
        Assert.Throws<ArgumentOutOfRangeException>(() => TargetField.Place(1, Area, 1, 0, [(SimulatedTargetKind)8], 0));
    }

    [Fact]
    public void With_MotionAndFrame_KeepWhatItIs()
    {
        SimulatedTarget marker = TargetField.Place(3, Area, 1, 0, [SimulatedTargetKind.ArUcoMarker], 0)[0];
        SimulatedTarget moved = marker.With(
            SimulatedMotion.Walking, TargetRoutes.Make(3, marker, SimulatedMotion.Walking, Area));
        SimulatedTarget elsewhere = moved.At(new NedPosition(1, 2, 0), TimeSpan.FromSeconds(3));

        Assert.Equal(
            (marker.MarkerId, marker.Pattern, marker.Declared, marker.Name),
            (elsewhere.MarkerId, elsewhere.Pattern, elsewhere.Declared, elsewhere.Name));
        Assert.Equal(SimulatedMotion.Walking, elsewhere.Motion);
        Assert.Equal(new NedPosition(1, 2, 0), elsewhere.Position);
    }

    private static string Looks(ulong seed) => string.Join(
        "; ", TargetField.Place(seed, Area, 16, 0, All, 4).Select(t => Describe(t) + t.MarkerId));

    private static string Describe(SimulatedTarget t) => FormattableString.Invariant(
        $"{t.Id} {t.Name} {t.Class} {t.Position} {t.Heading.Radians:R} {t.SideMetres} {t.Surface.Red} {t.Surface.Green} {t.Surface.Blue}");
}
