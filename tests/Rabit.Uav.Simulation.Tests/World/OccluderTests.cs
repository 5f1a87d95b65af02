using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Simulation.Tests.Camera;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.World;

/// <summary>Trees and roofs hide what is below them; without them a world is what it was.</summary>
public sealed class OccluderTests
{
    private static readonly SimulatedCameraOptions Camera = new() { NoiseSigma = 1 };

    [Theory]
    [InlineData(SimulatedOccluderKind.Tree)]
    [InlineData(SimulatedOccluderKind.Roof)]
    public void Target_BelowAnOccluder_IsNotInThePicture(SimulatedOccluderKind kind)
    {
        SimulatedTarget panel = Scene.Panel(0, 0);
        var occluder = new SimulatedOccluder { Kind = kind, LengthMetres = 6, WidthMetres = 5 };
        SimulatedTarget sheet = OccluderField.SheetOf(occluder, 0, seed: 1);

        Assert.True(occluder.Hides(panel.Position));
        Assert.Equal(Render(sheet), Render(panel, sheet));
        Assert.NotEqual(Render(), Render(panel));
    }

    [Fact]
    public void Target_BesideAnOccluder_IsInThePicture()
    {
        SimulatedTarget panel = Scene.Panel(0, 0);
        var occluder = new SimulatedOccluder { Position = new NedPosition(0, 6, 0), LengthMetres = 6, WidthMetres = 6 };
        SimulatedTarget sheet = OccluderField.SheetOf(occluder, 0, seed: 1);

        Assert.False(occluder.Hides(panel.Position));
        Assert.NotEqual(Render(sheet), Render(panel, sheet));
    }

    // Half a metre inside and outside of each edge.
    [Theory]
    [InlineData(3.5, 0, true)]
    [InlineData(4.5, 0, false)]
    [InlineData(0, 1.5, true)]
    [InlineData(0, 2.5, false)]
    [InlineData(3.5, 1.5, false)]
    public void Hides_TurnedByNinetyDegrees_GoesByItsOwnAxes(double east, double north, bool isHidden)
    {
        var tree = new SimulatedOccluder
        {
            LengthMetres = 8,
            WidthMetres = 4,
            Heading = Angle.FromDegrees(90),
            Position = new NedPosition(10, 20, 0),
        };
        var place = new NedPosition(10 + north, 20 + east, 0);
        Assert.Equal(isHidden, tree.Hides(place));
        SimulatedOccluder roof = tree with { Kind = SimulatedOccluderKind.Roof };
        Assert.Equal(isHidden || (east < 4 && north < 2), roof.Hides(place));
    }

    [Fact]
    public void World_WithOccluders_HasTheSameTargetsAndHidesNoneThatStands()
    {
        var plain = new SimulatedWorld(Options(0));
        var world = new SimulatedWorld(Options(6));

        Assert.Empty(plain.Occluders);
        Assert.Equal(plain.Things.Select(t => (t.Id, t.Position)), world.Things.Select(t => (t.Id, t.Position)));
        Assert.InRange(world.Occluders.Count, 2, 6);
        Assert.All(world.Occluders, o => Assert.DoesNotContain(
            world.Things, t => t.Motion == SimulatedMotion.Standing && o.Hides(t.Position)));
        Assert.Equal(world.Occluders, new SimulatedWorld(Options(6)).Occluders);
        foreach (SimulatedTarget mover in world.Targets.Where(t => t.Motion != SimulatedMotion.Standing))
            Assert.Contains(Enumerable.Range(0, 600), s => IsHidden(world, mover, s));
    }

    [Fact]
    public void World_SeenFromAnotherHome_HasItsOccludersAtTheSamePlace()
    {
        var world = new SimulatedWorld(Options(2));
        SimulationOptions other = Options(0);
        other.Home = world.PositionOf(new NedPosition(40, -25, 0));
        SimulatedWorld second = world.With(other, TimeSpan.Zero);

        Assert.Equal(world.Occluders.Count, second.Occluders.Count);
        for (int i = 0; i < world.Occluders.Count; i++)
        {
            NedVector off = world.Occluders[i].Position - second.Occluders[i].Position;
            Assert.Equal(40, off.North, 0.01);
            Assert.Equal(-25, off.East, 0.01);
        }
    }

    [Fact]
    public void Options_OccludersThatAreNone_AreNamed()
    {
        var options = new SimulationOptions
        {
            OccluderCount = -1,
            Occluders = [new SimulatedOccluder(), new SimulatedOccluder { WidthMetres = double.NaN }, null!],
        };
        string text = Assert.Throws<ArgumentException>(() => new SimulatedWorld(options)).Message;
        Assert.Contains("OccluderCount is -1", text);
        Assert.Contains("Occluders[1]: it is 8 by NaN m", text);
        Assert.Contains("neither null", text);
        Assert.DoesNotContain("Occluders[0]", text);
    }

    private static SimulationOptions Options(int occluders) => new()
    {
        Seed = 4,
        Motions = [SimulatedMotion.Walking, SimulatedMotion.Vehicle],
        OccluderCount = occluders,
    };

    private static bool IsHidden(SimulatedWorld world, SimulatedTarget target, int second)
        => world.Occluders.Any(o => o.Hides(target.PositionAt(TimeSpan.FromSeconds(second))));

    private static byte[] Render(params SimulatedTarget[] sheets)
    {
        byte[] pixels = new byte[640 * 480 * 3];
        var pose = new CameraPose(Scene.Pose(20), Camera);
        new PictureRenderer(Camera, (IEnumerable<SimulatedTarget>)sheets, seed: 1).Render(pose, pose, pose, 1, pixels);
        return pixels;
    }
}
