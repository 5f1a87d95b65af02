using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>A vehicle in a search whose sources of position and battery agree, but for what a test changes.</summary>
internal sealed class FlownVehicle : IDisposable
{
    private const double Period = 0.25;

    private static readonly LocalNedFrame Frame = LocalNedFrame.IgnoringGeoid(
        GeodeticPosition.FromDegrees(47.3977, 8.5456, 488));

    private double _north;

    public FlownVehicle() => Rig.PostMission(MissionPhase.Searching);

    public delegate void Change(ref VehicleState state, ref NavigationStatus navigation);

    public HealthRig Rig { get; } = new();

    public HealthReport Report => Rig.Report;

    /// <summary>Speed to the north, m/s.</summary>
    public double Speed { get; set; } = 6;

    /// <summary>Flies for a time; each report is changed before it is posted.</summary>
    public void Fly(double seconds, Change? change = null)
    {
        for (double flown = 0; flown < seconds; flown += Period)
        {
            Rig.PostLink();
            VehicleState state = Describe();
            NavigationStatus navigation = Navigation();
            change?.Invoke(ref state, ref navigation);
            Rig.PostVehicle(state);
            Rig.PostNavigation(navigation);
            Rig.Run(Period);
            _north += Speed * Period;
        }
    }

    public void Dispose() => Rig.Dispose();

    /// <summary>A place so far north of where it began, metres.</summary>
    public static GeodeticPosition PlaceOf(double north) => Frame.ToGeodetic(new NedPosition(north, 0, -30));

    private VehicleState Describe() => new()
    {
        SystemId = 1,
        IsConnected = true,
        IsArmed = true,
        SystemStatus = MavState.Active,
        LandedState = MavLandedState.InAir,
        LastHeartbeatTime = Rig.Reactor.Now,
        PositionTime = Rig.Reactor.Now,
        Position = PlaceOf(_north),
        HeightAboveHomeMetres = 30,
        VelocityNed = new NedVector(Speed, 0, 0),
        GpsTime = Rig.Reactor.Now,
        GpsFix = GpsFixType.Type3dFix,
        Satellites = 12,
        BatteryTime = Rig.Reactor.Now,
        BatteryRemaining = 0.8,
        BatteryVolts = 11.7,
        BatteryAmperes = 15,
        BatteryChargeState = MavBatteryChargeState.Ok,
    };

    private NavigationStatus Navigation() => new()
    {
        DilutionTime = Rig.Reactor.Now,
        HorizontalDilution = 0.9,
        EstimatorTime = Rig.Reactor.Now,
        EstimatorRatio = 0.2,
        PressureTime = Rig.Reactor.Now,
        PressureHeightMetres = 530,
    };
}
