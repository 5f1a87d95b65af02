using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.GroundControl;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Tests.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.GroundControl;

/// <summary>The autopilot's fence, changed by others, as another area.</summary>
public sealed class AutopilotFenceOfferTests : IDisposable
{
    private const MavCmd Inside = MavCmd.NavFencePolygonVertexInclusion;
    private const MavCmd Outside = MavCmd.NavFencePolygonVertexExclusion;

    // North and east of home; the area of the mission is 60 to 150 m north, -60 to 60 m east.
    private static readonly PlanePoint[] Fence = [new(0, -160), new(0, 260), new(300, 260), new(300, -160)];
    private static readonly PlanePoint[] Shed = [new(120, 70), new(120, 90), new(140, 90), new(140, 70)];

    private readonly GroundRig _ground = new(
        MissionRig.In(MissionPhase.Searching), new GroundCommandOptions { OffersAutopilotFence = true });

    private MissionFlight Flight => _ground.Flight.Manager.Flight!;

    public void Dispose() => _ground.Dispose();

    [Fact]
    public void Change_OfTheFence_IsOfferedWithItsKeepOutsAndTakenOverByTheNextContinue()
    {
        Post(0);
        _ground.Run(2);
        Assert.Empty(_ground.Texts);
        Post(1, (Inside, Fence), (Outside, Shed));
        _ground.Run(3);
        Assert.Equal(
            "Rabit: the autopilot's fence was changed: area offered: the next continue takes it over",
            Assert.Single(_ground.Texts));
        Continue();
        Assert.Equal(MavResult.Accepted, Assert.Single(_ground.Take<CommandAck>()).Result);
        Assert.Single(Flight.Mission.KeepOuts);

        // Smaller by the mission's margin and what it needs to stop.
        double margin = Flight.Mission.FenceMarginMetres + 5;
        Assert.InRange(Flight.Plan!.Area.Corners.Min(c => c.North), margin, margin + 40);
        Assert.InRange(Flight.Plan.Area.Corners.Max(c => c.East), 260 - margin - 40, 260 - margin);
        Assert.InRange(Flight.Plan.Area.Area, 30_000, 420 * 300);
    }

    [Fact]
    public void Change_ToNoFence_WithdrawsTheArea()
    {
        Post(1, (Inside, Fence));
        _ground.Run(3);
        Post(2);
        _ground.Run(1);
        Continue();
        Assert.Equal(MavResult.Failed, Assert.Single(_ground.Take<CommandAck>()).Result);
    }

    [Theory]
    [InlineData("circle", "item 0 is no corner of a polygon in a global frame")]
    [InlineData("narrow", "there is no area in it, with a margin to it")]
    [InlineData("crossing", "there is no area in it, with a margin to it")]
    [InlineData("two", "there are 2 inclusion polygons; one is searched")]
    public void Change_ToWhatIsNoArea_IsAnnouncedAndNotOffered(string kind, string reason)
    {
        PlanePoint[] narrow = [new(0, 0), new(0, 20), new(300, 20), new(300, 0)];
        PlanePoint[] crossing = [Fence[0], Fence[2], Fence[1], Fence[3]];
        switch (kind)
        {
            case "circle": Post(1, (MavCmd.NavFenceCircleInclusion, [new PlanePoint(0, 0)])); break;
            case "narrow": Post(1, (Inside, narrow)); break;
            case "crossing": Post(1, (Inside, crossing)); break;
            default: Post(1, (Inside, Fence), (Inside, Fence)); break;
        }

        _ground.Run(3);
        Assert.Equal(
            $"Rabit: the autopilot's fence was changed, and is not offered as an area: {reason}",
            Assert.Single(_ground.Texts));
        Continue();
        Assert.Equal(MavResult.Failed, Assert.Single(_ground.Take<CommandAck>()).Result);
    }

    [Fact]
    public void AreaWithin_TheFenceOfAMission_IsItsArea()
    {
        MissionPlan mission = Flight.Mission;
        IReadOnlyList<GeodeticPosition> fence = mission.AutopilotFence(Flight.Plan!.Frame.Origin);
        LocalNedFrame frame = Flight.Plan.Frame;
        var area = new PlanePolygon(mission.AreaWithin(fence).Select(frame.ToNed)
            .Select(p => new PlanePoint(p.North, p.East)));

        // The fence leads to home, too, and so does the area in it; what the mission searches is all of it but a rim.
        Assert.All(
            Flight.Plan.Area.Corners,
            c => Assert.InRange(area.SignedDistance(c), -8, double.PositiveInfinity));
        Assert.InRange(area.Area, 0.85 * Flight.Plan.Area.Area, 2.5 * Flight.Plan.Area.Area);
    }

    private void Continue()
    {
        _ground.Send(new CommandLong
        {
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
            Command = MavCmd.DoPauseContinue,
            Param1 = 1,
        });
        _ground.Run(1);
    }

    private void Post(int changes, params (MavCmd Command, PlanePoint[] Corners)[] polygons)
    {
        LocalNedFrame frame = Flight.Plan!.Frame;
        ImmutableArray<MissionItemInt> items =
        [
            .. polygons
                .SelectMany(p => p.Corners.Select(
                    c => (p, At: frame.ToGeodetic(new NedPosition(c.North, c.East, 0)))))
                .Select((c, i) => new MissionItemInt
                {
                    Seq = (ushort)i,
                    MissionType = MavMissionType.Fence,
                    Command = c.p.Command,
                    Param1 = c.p.Corners.Length,
                    X = (int)Math.Round(c.At.Latitude.Degrees * 1e7),
                    Y = (int)Math.Round(c.At.Longitude.Degrees * 1e7),
                }),
        ];
        _ground.Fence!.Value = new AutopilotFence { IsKnown = true, Changes = changes, Items = items };
        _ground.Fence.Post();
    }
}
