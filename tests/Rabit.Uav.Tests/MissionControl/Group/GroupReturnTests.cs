using System;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>What keeps a vehicle of a group that returns apart from others.</summary>
public sealed class GroupReturnTests
{
    private const string Field = "[[60,-180],[60,180],[360,180],[360,-180]]";
    private const double HomesApartMetres = 20;
    private const double HomeMetres = 15;

    // Of what is not received nothing is known: the layers keep the vehicles apart, also on the way home.
    [Fact]
    public void Return_RadioIsDead_StaysInItsLayerOverAllThatAreInTheirs()
    {
        using GroupRig rig = Open();
        rig.Reaches = (_, _) => false;
        double apart = double.PositiveInfinity;
        rig.Rigs[0].Manager.ReturnToLaunch("test", "weather");
        PlaceOnTheWayHome(rig);
        rig.RunUntil(
            () =>
            {
                if (rig.Rigs[0].Vehicle is { } v && new PlanePoint(v.North, v.East).Length > HomeMetres)
                    apart = Math.Min(apart, Math.Abs(v.Height - rig.Rigs[1].Vehicle.Height));
                return rig.Rigs[0].Status.Phase is MissionPhase.Done;
            },
            300);
        Assert.InRange(apart, GroupOptions.SeparationMetres, 25);
    }

    private static GroupRig Open()
    {
        var rig = new GroupRig(2, MissionRig.Mission(area: Field));
        bool isReady = rig.RunUntil(
            () => rig.Rigs.All(r => r.Status.Phase == MissionPhase.Searching)
                && rig.Rigs[0].Vehicle is { } v && new PlanePoint(v.North, v.East).Length > 160,
            400);
        Assert.True(isReady, rig.Story);
        return rig;
    }

    // The second one halfway, in its layer.
    private static void PlaceOnTheWayHome(GroupRig rig)
    {
        (StandInVehicle first, StandInVehicle second) = (rig.Rigs[0].Vehicle, rig.Rigs[1].Vehicle);
        (second.North, second.East) = (first.North / 2, (first.East / 2) - HomesApartMetres);
    }
}
