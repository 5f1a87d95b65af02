using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// The state of the position between two evaluations: the way by positions against the way by velocities, and the
/// height against the air pressure.
/// </summary>
internal sealed class PositionWatch
{
    // A position that has moved by more is no longer frozen.
    private const double MovedMetres = 1;

    private static readonly TimeSpan MaxPressureAge = TimeSpan.FromSeconds(5);

    private readonly WayComparison _way = new();
    private GeodeticPosition? _frozenAt;
    private double _pressureAtHome = double.NaN;

    public PositionFacts Update(
        in VehicleState state, in NavigationStatus navigation, TimeSpan now, HealthOptions options)
    {
        _way.Update(state);
        if (_frozenAt is { } at && Distance(at, state.Position) > MovedMetres)
            _frozenAt = null;
        if (_way.ErrorMetres > options.PositionErrorMetres && _way.StandsStill)
            _frozenAt ??= state.Position;
        return new PositionFacts(
            state, navigation, now, _way.ErrorMetres, _frozenAt is not null, HeightError(state, navigation, now));
    }

    private static double Distance(in GeodeticPosition from, in GeodeticPosition to)
    {
        NedPosition off = LocalNedFrame.IgnoringGeoid(from).ToNed(to);
        return Math.Sqrt((off.North * off.North) + (off.East * off.East));
    }

    // On the ground the pressure at home is measured again and again: the weather changes it.
    private double HeightError(in VehicleState state, in NavigationStatus navigation, TimeSpan now)
    {
        bool isKnown = now - navigation.PressureTime <= MaxPressureAge && state.PositionTime is not null;
        if (!isKnown)
            return double.NaN;
        bool isOnGround = !state.IsArmed || state.LandedState == MavLandedState.OnGround;
        if (isOnGround || double.IsNaN(_pressureAtHome))
            _pressureAtHome = navigation.PressureHeightMetres - state.HeightAboveHomeMetres;
        return state.HeightAboveHomeMetres - (navigation.PressureHeightMetres - _pressureAtHome);
    }
}
