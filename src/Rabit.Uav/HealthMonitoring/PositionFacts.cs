using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the position: is it known, and do its sources agree?</summary>
internal readonly struct PositionFacts(
    in VehicleState state, in NavigationStatus navigation, TimeSpan now, double disagreementMetres, bool isFrozen,
    double heightErrorMetres)
{
    // Reported twice a second or once a second.
    private static readonly TimeSpan MaxReportAge = TimeSpan.FromSeconds(5);

    // Reported several times a second.
    private static readonly TimeSpan MaxPositionAge = TimeSpan.FromSeconds(2);

    public VehicleState State { get; } = state;

    public NavigationStatus Navigation { get; } = navigation;

    /// <summary>
    /// Whether the motors run in the air and the autopilot is connected: on the ground a position may come and go.
    /// </summary>
    public bool IsInFlight { get; } = state.IsConnected && now - state.LastHeartbeatTime <= MaxReportAge
        && state.IsArmed && state.LandedState != MavLandedState.OnGround;

    /// <summary>Whether the autopilot reports where it is.</summary>
    public bool HasPosition { get; } = now - state.PositionTime <= MaxPositionAge;

    /// <summary>Whether the receiver, which reported once, has a fix in three dimensions.</summary>
    public bool HasFix { get; } = now - state.GpsTime <= MaxReportAge && state.GpsFix >= GpsFixType.Type3dFix;

    public bool ReportsFix { get; } = state.GpsTime is not null;

    public bool ReportsEstimator { get; } = now - navigation.EstimatorTime <= MaxReportAge;

    /// <summary>HDOP; NaN where it is not known.</summary>
    public double HorizontalDilution { get; }
        = now - navigation.DilutionTime <= MaxReportAge ? navigation.HorizontalDilution : double.NaN;

    /// <summary>
    /// How far positions and velocities disagree about the way of the last seconds, metres; NaN where not known.
    /// </summary>
    public double DisagreementMetres { get; } = disagreementMetres;

    /// <summary>Whether the position has stood still since it began to disagree with the velocity.</summary>
    public bool IsFrozen { get; } = isFrozen;

    /// <summary>
    /// Height above home by the autopilot less that by the air pressure since take-off, metres; NaN where not known.
    /// </summary>
    public double HeightErrorMetres { get; } = heightErrorMetres;
}
